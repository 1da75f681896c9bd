#include "output/solid/map_figures.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

using namespace reye::output;
using reye::base::Vec2;
using reye::base::Vec3;

namespace {

constexpr int side = 24;

/// An even grid of quadrilaterals on [-1, 1]^2, bent and turned into space; values are left to the test.
DrawnSkin sheet(const Eigen::Matrix3d& turn, double bend = 0.0) {
  DrawnSkin skin;
  for (int j = 0; j <= side; ++j)
    for (int i = 0; i <= side; ++i) {
      const double x = -1.0 + 2.0 * i / side, y = -1.0 + 2.0 * j / side;
      skin.X.push_back(turn * Vec3(x, y, -bend * (x * x + y * y)));
      skin.normal.push_back(turn * Vec3(2.0 * bend * x, 2.0 * bend * y, 1.0).normalized());
    }
  const auto node = [](int i, int j) { return j * (side + 1) + i; };
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i)
      skin.facets.push_back({node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
  skin.shear_MPa.assign(skin.X.size(), Vec3::Zero());
  skin.slip_mm = skin.shear_MPa;
  skin.pressure_MPa.assign(skin.X.size(), 0.0);
  skin.area_mm2.assign(skin.X.size(), 4.0 / (side * side));
  skin.status.assign(skin.X.size(), 0);
  return skin;
}

Eigen::Matrix3d turned(double angle, const Vec3& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

double area_of(const SkinMap& map) {
  double area = 0.0;
  for (const auto& t : map.triangles) {
    const Vec2 a = map.x[t[1]] - map.x[t[0]], b = map.x[t[2]] - map.x[t[0]];
    const double twice = a.x() * b.y() - a.y() * b.x();
    EXPECT_GT(twice, 0.0);
    area += 0.5 * twice;
  }
  return area;
}

}  // namespace

// A plane surface in any position keeps its lengths and areas in the map, whose triangles run counter-clockwise.
TEST(SkinMap, PlaneSurfaceKeepsItsArea) {
  for (const double angle : {0.0, 0.7, 1.6, 3.1}) {
    const auto skin = sheet(turned(angle, Vec3(1.0, 0.4, 0.2)));
    const SkinMap map = skin_map(skin);
    EXPECT_NEAR(area_of(map), 4.0, 1e-12) << angle;
    EXPECT_NEAR((map.x[5] - map.x[77]).norm(), (skin.X[5] - skin.X[77]).norm(), 1e-12);
    EXPECT_NEAR(std::abs(map.normal.dot(skin.normal[0])), 1.0, 1e-12);
  }
}

// Axes of the map ascend with those of space: x to the right and y upwards on faces along z, seen from above or below.
TEST(SkinMap, AxesAscend) {
  for (const double angle : {0.0, std::numbers::pi}) {
    const SkinMap map = skin_map(sheet(turned(angle, Vec3::UnitX())));
    EXPECT_NEAR((map.across - Vec3::UnitX()).norm(), 0.0, 1e-9) << angle;
    EXPECT_NEAR((map.up - Vec3::UnitY()).norm(), 0.0, 1e-9) << angle;
  }
  const SkinMap upright = skin_map(sheet(turned(0.5 * std::numbers::pi, Vec3::UnitY())));
  EXPECT_EQ(axis_label(upright.across), "y");
  EXPECT_EQ(axis_label(upright.up), "z");
}

// The map looks along the normal of what is in contact, not of the whole surface, and leaves out what faces away.
TEST(SkinMap, LooksAlongTheNormalOfTheContact) {
  DrawnSkin skin = sheet(Eigen::Matrix3d::Identity(), 2.0);  // slopes up to 4: 76 degrees at its sides
  for (std::size_t i = 0; i < skin.X.size(); ++i)
    if ((skin.X[i].head<2>() - Vec2(0.8, 0.0)).norm() < 0.15) {
      skin.pressure_MPa[i] = 1.0;
      skin.status[i] = 1;
    }
  const SkinMap map = skin_map(skin);
  EXPECT_GT(map.normal.x(), 0.9);
  EXPECT_LT(map.triangles.size(), 4 * skin.facets.size() / 2);
  EXPECT_GT(map.triangles.size(), 40u);
  EXPECT_LT(map.x_seen.width(), 1.2);
  area_of(map);
}

// The lines run along the axes of an elliptic contact through its largest pressure, the longer first.
TEST(SkinMap, PrincipalLinesOfAnEllipse) {
  const double angle = 0.5;
  DrawnSkin skin = sheet(Eigen::Matrix3d::Identity());
  for (std::size_t i = 0; i < skin.X.size(); ++i) {
    const Vec2 p = Eigen::Rotation2Dd(-angle) * skin.X[i].head<2>();
    const double q = 1.0 - p.x() * p.x() / 0.64 - p.y() * p.y() / 0.16;
    skin.pressure_MPa[i] = q > 0.0 ? std::sqrt(q) : 0.0;
    skin.status[i] = q > 0.0;
  }
  const auto lines = principal_lines(skin_map(skin), skin);
  EXPECT_NEAR(lines[0].through.norm(), 0.0, 1e-12);
  EXPECT_NEAR(lines[0].along.x(), std::cos(angle), 0.01);
  EXPECT_NEAR(lines[0].along.y(), std::sin(angle), 0.01);
  EXPECT_NEAR(lines[0].along.dot(lines[1].along), 0.0, 1e-12);
}

// The lines of a round contact, and of no contact, are those of the map's axes.
TEST(SkinMap, LinesOfARoundContact) {
  DrawnSkin skin = sheet(Eigen::Matrix3d::Identity());
  for (const bool pressed : {false, true}) {
    for (std::size_t i = 0; i < skin.X.size(); ++i)
      skin.pressure_MPa[i] = pressed ? std::max(0.0, 0.5 - skin.X[i].squaredNorm()) : 0.0;
    const auto lines = principal_lines(skin_map(skin), skin);
    EXPECT_EQ(lines[0].along, Vec2(1.0, 0.0));
    EXPECT_EQ(lines[1].along, Vec2(0.0, 1.0));
  }
}

// A linear value is met exactly along a slanted line, and beyond the facets there is none.
TEST(SkinMap, SamplesALinearValueExactly) {
  const DrawnSkin skin = sheet(turned(0.9, Vec3(0.3, 1.0, 0.1)));
  SkinMap map = skin_map(skin);
  std::vector<double> rows;
  for (std::size_t i = 0; i < skin.X.size(); ++i) rows.push_back(3.0 + 2.0 * map.x[i].x() - 5.0 * map.x[i].y());
  const MapLine line{{0.1, -0.2}, Vec2(0.8, 0.6)};
  const auto samples = sampled(map, map.at_points(rows), line);
  int known = 0;
  for (std::size_t i = 0; i < samples.position.size(); ++i) {
    if (std::isnan(samples.value[i])) continue;
    const Vec2 at = line.through + samples.position[i] * line.along;
    EXPECT_NEAR(samples.value[i], 3.0 + 2.0 * at.x() - 5.0 * at.y(), 1e-9);
    ++known;
  }
  EXPECT_GT(known, 100);
  EXPECT_LT(known, static_cast<int>(samples.position.size()));
}

// A map about the rows that have worn must show those of them that touch no longer, and its axes are named after those
// of space where they are near to them.
TEST(SkinMap, AboutWornRows) {
  DrawnSkin skin = sheet(turned(0.02, Vec3::UnitY()));
  skin.wear_depth_mm.assign(skin.X.size(), 0.0);
  for (std::size_t i = 0; i < skin.X.size(); ++i)
    skin.wear_depth_mm[i] = std::max(0.0, 0.003 * (0.25 - skin.X[i].squaredNorm()));
  const auto worn = worn_rows(skin);
  const SkinMap map = skin_map(skin, worn);
  EXPECT_LT(map.x_seen.width(), 1.6);
  EXPECT_GT(map.x_seen.width(), 0.9);
  EXPECT_EQ(axis_label(map.across), "x");
  const Figure figure = depth_map(map, skin, {"pad", "", "cycle 3", {}});
  EXPECT_EQ(figure.id, "map-depth-pad");
  EXPECT_EQ(figure.title, "worn depth, secondary side, cycle 3");
  ASSERT_TRUE(figure.scale);
  EXPECT_EQ(figure.scale->label, "µm");
  EXPECT_GE(figure.scale->range.high, 0.75);
  EXPECT_LE(figure.scale->range.high, 1.0);
}

// Frames of a moving map must share view and scale.
TEST(SkinMap, Moving) {
  DrawnSkin skin = sheet(Eigen::Matrix3d::Identity());
  std::vector<MovingMap> frames;
  for (const double depth : {1.0, 3.0}) {
    skin.wear_depth_mm.assign(skin.X.size(), depth);
    frames.push_back({skin_map(skin, worn_rows(skin)), skin.wear_depth_mm, "cycle"});
  }
  const Figure figure = moving_map(frames, "mm", "moving", "depth");
  ASSERT_EQ(figure.moments.size(), 2u);
  ASSERT_TRUE(figure.scale);
  EXPECT_EQ(figure.scale->range.high, 3.0);
  ASSERT_TRUE(figure.x_range && figure.y_range);
  EXPECT_FALSE(figure.moments[0].areas.empty());
  EXPECT_NE(figure.moments[0].areas[0].colour, figure.moments[1].areas[0].colour);
}
