#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>

#include "stability/solid_played.hpp"

using namespace reye;

namespace reye::test {
void PrintTo(const SolidMember& m, std::ostream* out) { *out << m.name; }
}  // namespace reye::test

namespace {

/// One row per member in the file that REYE_SOLID_STABILITY names: results/solid_stability tabulates them.
void write_row(const test::SolidMember& m, const test::SolidOutcome& o) {
  const char* file = std::getenv("REYE_SOLID_STABILITY");
  if (!file) return;
  std::ofstream out(file, std::ios::app);
  if (out.tellp() == 0)
    out << "group,member,status,increments,newton,newton_most,cutbacks,balance,least_pressure,force_N,peak_MPa,energy_"
           "mJ,"
           "cpu_s,reason\n";
  out.precision(4);
  out << m.group << ',' << m.name << ',' << o.status << ',' << o.increments << ',' << o.newton << ',' << o.newton_most
      << ',' << o.cutbacks << ',' << o.balance << ',' << o.least_pressure << ',' << o.force << ',' << o.peak << ','
      << o.energy << ',' << o.cpu_s << ",\"";
  for (const char c : o.reason) out << (c == '"' ? '\'' : c == '\n' ? ' ' : c);
  out << "\"\n";
}

class SolidStability : public testing::TestWithParam<test::SolidMember> {};

std::string solid_member_name(const testing::TestParamInfo<test::SolidMember>& info) {
  std::string name;
  for (const char c : info.param.name)
    name += std::isalnum(static_cast<unsigned char>(c)) ? std::string(1, c) : c == '-' ? "minus" : "_";
  return name;
}

// Each member must be done, or refused with the reason that is true of it; forces and moments on its bodies must
// balance, contact must only press, and where it is another member in other units it must give the same figures.
TEST_P(SolidStability, EndsTruly) {
  const auto& m = GetParam();
  const auto o = test::play(m);
  write_row(m, o);
  if (m.refusal.empty()) {
    EXPECT_EQ(o.status, "done") << o.reason;
  } else {
    EXPECT_NE(o.status, "done");
    EXPECT_NE(o.reason.find(m.refusal), std::string::npos) << o.reason;
  }
  EXPECT_LE(o.balance, m.balance);
  EXPECT_GE(o.least_pressure, -1e-9);
  if (m.like.empty()) return;
  for (const auto& other : test::solid_members())
    if (other.name == m.like) {
      const auto expected = test::play(other);
      EXPECT_NEAR(o.peak, expected.peak, 1e-7 * expected.peak);
      EXPECT_NEAR(o.force, expected.force, 1e-7 * expected.force);
      EXPECT_NEAR(o.energy, expected.energy, 1e-6 * expected.energy);
    }
}

class WornSolidStability : public testing::TestWithParam<test::SolidMember> {};

// Each member rubbed over three thousand cycles must be done; where it slides it must wear, what is removed must be the
// law's, forces and moments must balance and contact must only press.
TEST_P(WornSolidStability, EndsTruly) {
  const auto& m = GetParam();
  const auto o = test::play(m);
  EXPECT_EQ(o.status, "done") << o.reason;
  EXPECT_TRUE(o.depth_mm > 0.0 || o.energy == 0.0) << "it slides and does not wear";
  EXPECT_LE(o.ledger, 1e-9);
  EXPECT_LE(o.balance, 10.0 * m.balance);
  EXPECT_GE(o.least_pressure, -1e-9);
}

class RemeshedSolidStability : public testing::TestWithParam<test::SolidMember> {};

// Each member rubbed and worn, its tetrahedra remeshed after every block, must be done as without. Forces balance to
// what Newton's tolerance, 1e-9 of the largest traction, leaves of them where a block drops off another's edge.
TEST_P(RemeshedSolidStability, EndsTruly) {
  const auto& m = GetParam();
  const auto o = test::play(m);
  EXPECT_EQ(o.status, "done") << o.reason;
  EXPECT_GE(o.remeshes, 4);
  EXPECT_LE(o.ledger, 1e-9);
  EXPECT_LE(o.balance, 1e-8);
  EXPECT_GE(o.least_pressure, -1e-9);
}

/// Every third member; all where REYE_WHOLE_STABILITY is set, as the slow test does.
std::vector<test::SolidMember> remeshed_members() {
  const auto all = test::remeshed_solid_members();
  if (std::getenv("REYE_WHOLE_STABILITY")) return all;
  std::vector<test::SolidMember> third;
  for (std::size_t k = 0; k < all.size(); k += 3) third.push_back(all[k]);
  return third;
}

INSTANTIATE_TEST_SUITE_P(RemeshedSolids, RemeshedSolidStability, testing::ValuesIn(remeshed_members()),
                         solid_member_name);

INSTANTIATE_TEST_SUITE_P(WornSolids, WornSolidStability, testing::ValuesIn(test::worn_solid_members()),
                         solid_member_name);

INSTANTIATE_TEST_SUITE_P(Solids, SolidStability, testing::ValuesIn(test::solid_members()), solid_member_name);

}  // namespace

// Members are distinguished by their names.
TEST(SolidStabilityNames, AreUnique) {
  std::set<std::string> names;
  for (const auto& m : test::solid_members()) EXPECT_TRUE(names.insert(m.name).second) << m.name;
}
