#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

#include "contact/solid/skin_wear.hpp"

using namespace reye;
using base::Vec3;

namespace {

contact::SkinFrame some_frame() {
  contact::SkinFrame frame;
  frame.normal = Vec3(0.3, -0.5, 0.8).normalized();
  frame.tangent[0] = frame.normal.unitOrthogonal();
  frame.tangent[1] = frame.normal.cross(frame.tangent[0]);
  return frame;
}

wear::Law law_of(wear::LawKind kind, double pressure_exponent) {
  wear::Law law;
  law.kind = kind;
  law.secondary = 3e-5;
  law.primary = 2e-5;
  law.pressure_exponent = pressure_exponent;
  law.pressure_ref = 50.0;
  return law;
}

class WornPoint : public testing::TestWithParam<std::pair<wear::LawKind, double>> {};

}  // namespace

TEST_P(WornPoint, VolumesChangeAsTheirDerivativesSay) {
  // The derivatives of the volumes that a sliding point removes, by its traction and its motion, are those of central
  // differences.
  const auto [kind, exponent] = GetParam();
  const auto law = law_of(kind, exponent);
  const auto frame = some_frame();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int trial = 0; trial < 20; ++trial) {
    contact::SkinNode node;
    const Vec3 d = frame.across(Vec3(any(random), any(random), any(random))).normalized();
    node.slip = 0.02 * d + 0.005 * frame.across(Vec3(any(random), any(random), any(random)));
    node.traction = (80.0 + 20.0 * any(random)) * frame.normal + 30.0 * d;
    const wear::Start start{.jump = 40.0, .area = 0.3};
    const Vec3 dz(any(random), any(random), any(random)), dw(any(random), any(random), any(random));
    const auto at = [&](double t) {
      contact::SkinNode other = node;
      other.traction += t * dz;
      other.slip += t * 1e-3 * frame.across(dw);
      return contact::worn_at(law, other, frame, 0.25, start);
    };
    constexpr double h = 1e-4;
    const auto worn = at(0.0), ahead = at(h), behind = at(-h);
    const auto compare = [&](const contact::SkinWorn::Side& side, double volume_ahead, double volume_behind) {
      const double expected = (volume_ahead - volume_behind) / (2.0 * h);
      EXPECT_NEAR(side.of_traction.dot(dz) + 1e-3 * side.of_motion.dot(dw), expected, 1e-6 * std::abs(side.volume));
    };
    compare(worn.secondary, ahead.secondary.volume, behind.secondary.volume);
    compare(worn.primary, ahead.primary.volume, behind.primary.volume);
    EXPECT_NEAR(worn.primary.volume / worn.secondary.volume, 2.0 / 3.0, 1e-14);
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, WornPoint,
                         testing::Values(std::pair{wear::LawKind::energy, 0.0}, std::pair{wear::LawKind::energy, 0.6},
                                         std::pair{wear::LawKind::archard, 0.0}, std::pair{wear::LawKind::archard, 0.6},
                                         std::pair{wear::LawKind::rate, 0.0}));

TEST(SkinWearFields, EachIsInTheListOnce) {
  // Every quantity of a contact that wears is visited once, under a name of its own.
  contact::SkinWear wear;
  std::vector<std::string> names;
  contact::for_each_field(wear, [&](const contact::Field& field, const auto&) { names.emplace_back(field.name); });
  EXPECT_EQ(names.size(), 14u);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}
