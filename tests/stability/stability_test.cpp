#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>

#include "stability/played.hpp"

using namespace reye;

namespace reye::test {
void PrintTo(const Member& m, std::ostream* out) { *out << m.name; }
}  // namespace reye::test

namespace {

const test::Member& member_named(const std::string& name) {
  for (const auto& m : test::members())
    if (m.name == name) return m;
  throw std::runtime_error("no member " + name);
}

/// One row per member in the file that REYE_STABILITY names: results/stability tabulates them.
void tell(const test::Member& m, const test::Played& p, double difference) {
  const char* file = std::getenv("REYE_STABILITY");
  if (!file) return;
  std::ofstream out(file, std::ios::app);
  if (out.tellp() == 0)
    out << "group,member,status,increments,newton,factorisations,newton_most,cutbacks,remeshes,ledger,balance,"
           "multiplier,difference,cpu_s,reason\n";
  out.precision(3);
  out << m.group << ',' << m.name << ',' << p.status << ',' << p.increments << ',' << p.newton << ','
      << p.factorisations << ',' << p.newton_most << ',' << p.cutbacks << ',' << p.remeshes << ',' << p.ledger << ','
      << p.balance << ',' << p.multiplier << ',' << difference << ',' << p.cpu_s << ",\"";
  for (char c : p.reason) out << (c == '"' ? '\'' : c == '\n' ? ' ' : c);
  out << "\"\n";
}

class Stability : public testing::TestWithParam<test::Member> {};

std::string test_name(const testing::TestParamInfo<test::Member>& info) {
  std::string name;
  for (char c : info.param.name)
    name += std::isalnum(static_cast<unsigned char>(c)) ? std::string(1, c) : c == '-' ? "minus" : "_";
  return name;
}

// Each member must be done, or refused with the reason that is true of it, within its budget; its ledger, the balance
// of its forces and the sign of its pressure must hold, and where it is another member in other words it must give the
// same figures.
TEST_P(Stability, EndsTruly) {
  const auto& m = GetParam();
  const auto p = test::play(m);
  const double difference = m.like.empty() ? 0.0 : test::difference(p, test::play(member_named(m.like)));
  tell(m, p, difference);
  if (m.refusal.empty()) {
    EXPECT_EQ(p.status, "done") << p.reason;
  } else {
    EXPECT_TRUE(p.status == "failed" || p.status == "refused") << p.status;
    EXPECT_NE(p.reason.find(m.refusal), std::string::npos) << p.reason;
  }
  EXPECT_LE(p.newton, m.budget);
  EXPECT_LE(p.ledger, 1e-9);
  EXPECT_LE(p.balance, 1e-10);
  EXPECT_GE(p.multiplier, 0.0);
  EXPECT_LE(difference, m.agreement);
}

INSTANTIATE_TEST_SUITE_P(Grid, Stability, testing::ValuesIn(test::members()), test_name);

}  // namespace

// Members are distinguished by their names.
TEST(StabilityGrid, NamesAreUnique) {
  std::set<std::string> names;
  for (const auto& m : test::members()) EXPECT_TRUE(names.insert(m.name).second) << m.name;
}
