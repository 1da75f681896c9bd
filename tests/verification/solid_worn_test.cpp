#include <gtest/gtest.h>

#include "support/solid_worn.hpp"

using namespace reye;

namespace {

/// Worn volume, its second moments along and across a direction over it, and their mixed one.
std::array<double, 4> moments_about(const sim::SkinRecord& scar, double angle) {
  const base::Vec3 along(std::cos(angle), std::sin(angle), 0.0), across(-std::sin(angle), std::cos(angle), 0.0);
  std::array<double, 4> m{};
  for (std::size_t j = 0; j < scar.x_mm.size(); ++j) {
    const double v = scar.area_mm2[j] * scar.wear_depth_mm[j];
    const double x = scar.x_mm[j].dot(along), y = scar.x_mm[j].dot(across);
    m[0] += v;
    m[1] += v * x * x;
    m[2] += v * y * y;
    m[3] += v * x * y;
  }
  for (int k = 1; k < 4; ++k) m[k] /= m[0];
  return m;
}

using Grid = std::map<std::pair<int, int>, double>;

Grid depth_on_grid(const sim::SkinRecord& scar, double spacing) {
  Grid grid;
  for (std::size_t j = 0; j < scar.x_mm.size(); ++j)
    grid[{static_cast<int>(std::lround(scar.x_mm[j].x() / spacing)),
          static_cast<int>(std::lround(scar.x_mm[j].y() / spacing))}] = scar.wear_depth_mm[j];
  return grid;
}

double at_place(const Grid& grid, double spacing, const base::Vec2& x) {
  const base::Vec2 at = x / spacing, low(std::floor(at.x()), std::floor(at.y())), t = at - low;
  const auto value = [&](int i, int j) {
    return grid.at({static_cast<int>(low.x()) + i, static_cast<int>(low.y()) + j});
  };
  return (1 - t.x()) * ((1 - t.y()) * value(0, 0) + t.y() * value(0, 1)) +
         t.x() * ((1 - t.y()) * value(1, 0) + t.y() * value(1, 1));
}

}  // namespace

TEST(SolidWorn, AWaveIsWornFlatByItsExponent) {
  // Pressed into full contact, a wavy surface presses with a wave of E* k A / 2, which decays with the way it slides as
  // exp(-alpha E* k s / 2), in both directions at once: 1 %, and closer on the finer mesh.
  std::vector<double> errors;
  for (const int elements : {8, 16}) {
    support::WavyBlock wavy;
    wavy.elements = elements;
    const auto played = support::play(wavy.problem());
    ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
    ASSERT_GE(played.frames.size(), 2u);
    const auto &first = played.frames.front().surfaces[0], &last = played.frames.back().surfaces[0];
    const double before = wavy.amplitude(first, first.pressure_MPa), after = wavy.amplitude(last, last.pressure_MPa);
    const double exponent = std::log(after / before) / std::log(wavy.decay());
    errors.push_back(std::max(std::abs(before / wavy.wave_MPa() - 1.0), std::abs(exponent - 1.0)));
  }
  EXPECT_LE(errors[1], 0.01);
  EXPECT_LE(errors[1], 0.3 * errors[0]) << errors[0];
}

TEST(SolidWorn, RingsThatTurnWearByTheirRadiusFirstAndPressByItsInverseLast) {
  // Equal flat rings wear by w = alpha p theta r in a first small turn, and lose the volume of its integral; worn long
  // they press by p = P / (2 pi (r_o - r_i) r), which wears evenly: 1 %.
  const support::TurningRings rings;
  const double theta = 1e-3;
  const auto first = support::play(rings.problem(theta, 1));
  ASSERT_EQ(first.summary.status, sim::RunStatus::done) << first.summary.reason;
  const auto& worn = first.frames.back().surfaces[0];
  double worst = 0.0;
  for (std::size_t j = 0; j < worn.x_mm.size(); ++j) {
    const double r = worn.x_mm[j].head<2>().norm(), w = rings.alpha * rings.mean_MPa * theta * r;
    worst = std::max(worst, std::abs(worn.wear_depth_mm[j] / w - 1.0));
  }
  EXPECT_LE(worst, 0.01);
  EXPECT_NEAR(first.summary.contacts[0].secondary.worn_volume_mm3, rings.first_volume(theta),
              0.01 * rings.first_volume(theta));
  const auto last = support::play(rings.problem(20.0, 40));
  ASSERT_EQ(last.summary.status, sim::RunStatus::done) << last.summary.reason;
  const auto& pressed = last.frames.back().surfaces[0];
  worst = 0.0;
  for (std::size_t j = 0; j < pressed.x_mm.size(); ++j)
    worst = std::max(worst, std::abs(pressed.pressure_MPa[j] / rings.last_MPa(pressed.x_mm[j].head<2>().norm()) - 1.0));
  EXPECT_LE(worst, 0.01);
}

TEST(SolidWorn, ABallWornToFiveTimesItsContactIsACap) {
  // With twelve elements over the last radius V = alpha P s to 1e-4, the slope of the surface, and the cap of w = d -
  // r^2 / 2R has the radius and the depth of pi a^4 / 4R = V and d = a^2 / 2R, within 1 %.
  const support::WornCap cap;
  const auto played = support::play(cap.problem());
  ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
  const auto fit = support::fit_cap(played.frames.back().surfaces[0], 0.8 * cap.radius());
  const double volume = played.summary.contacts[0].secondary.worn_volume_mm3 / cap.hertz().share();
  EXPECT_NEAR(volume, cap.volume(), 1e-4 * cap.volume());
  EXPECT_NEAR(fit.radius(), cap.radius(), 0.01 * cap.radius());
  EXPECT_NEAR(fit.depth_mm, cap.depth(), 0.01 * cap.depth());
}

TEST(SolidWorn, ACircularStrokeWearsAsAStraightOne) {
  // Circles and straight strokes of equal path, long beside what the contact yields at a reversal, wear the same volume
  // within 0.3 %, that of alpha mu P s.
  const support::RubbedBall ball;
  const auto circle = support::circular_stroke(2.0, 32);
  const double length = support::RubbedBall::length(circle);
  std::vector<double> volumes;
  for (const auto& path : {circle, support::straight_stroke(0.25 * length, 0.0, 8)}) {
    const auto played = support::play(ball.problem(path));
    ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
    const double of_path = ball.alpha * ball.mu * ball.hertz().force() * length * ball.cycles;
    volumes.push_back(played.summary.contacts[0].secondary.worn_volume_mm3 / of_path);
  }
  for (const double volume : volumes) EXPECT_NEAR(volume, 1.0, 0.003);
  EXPECT_NEAR(volumes[0] / volumes[1], 1.0, 0.003);
}

TEST(SolidWorn, AStrokeTurnedTurnsTheScar) {
  // In partial slip the scar is longer across the stroke than along it. A stroke turned by 37 degrees, askew to the
  // mesh, turns it: volume and second moments about the stroke within 0.1 %, the depth within 0.5 % of the deepest in
  // the mean of squares.
  support::RubbedBall ball;
  ball.elements = 8.0;
  ball.cycles = 1;
  const double angle = 37.0 / 180.0 * std::numbers::pi, amplitude = 0.02;
  std::vector<sim::SkinRecord> scars;
  for (const double turned : {0.0, angle}) {
    const auto played = support::play(ball.problem(support::straight_stroke(amplitude, turned, 4)));
    ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
    scars.push_back(played.frames.back().surfaces[0]);
  }
  const auto straight = moments_about(scars[0], 0.0), turned = moments_about(scars[1], angle);
  EXPECT_GT(straight[2], 1.005 * straight[1]);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(turned[k], straight[k], 1e-3 * straight[k]) << k;
  EXPECT_NEAR(turned[3], 0.0, 1e-3 * straight[1]);
  const double spacing = ball.a_mm / ball.elements, reach = 0.7 * ball.a_mm;
  const auto field = depth_on_grid(scars[0], spacing);
  double squares = 0.0, area = 0.0, deepest = 0.0;
  for (std::size_t j = 0; j < scars[1].x_mm.size(); ++j) {
    const base::Vec3& x = scars[1].x_mm[j];
    if (x.head<2>().norm() > reach) continue;
    const base::Vec2 back = Eigen::Rotation2Dd(-angle) * x.head<2>();
    squares += scars[1].area_mm2[j] * std::pow(scars[1].wear_depth_mm[j] - at_place(field, spacing, back), 2);
    area += scars[1].area_mm2[j];
    deepest = std::max(deepest, scars[1].wear_depth_mm[j]);
  }
  EXPECT_LE(std::sqrt(squares / area), 0.005 * deepest) << std::sqrt(squares / area) / deepest;
}
