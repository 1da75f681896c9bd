#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/solid_problem.hpp"

using namespace reye;
using base::Vec3;

namespace {

struct PatchCase {
  const char* name;
  mesh::SolidKind lower, upper;
  std::array<int, 3> lower_parts, upper_parts;
  bool lower_is_secondary;
  double turn_deg;
  double bent = 0.0;    ///< by how much the lines of the lower block's mesh are bent, in its interface too
  bool partly = false;  ///< the lower block is rigid and larger, so that its facets are covered in part
};

constexpr double patch_E = 2.0e5, patch_p = 120.0, patch_shear = 30.0;

base::Mat3 turned_by(double deg) {
  return Eigen::AngleAxisd(deg * 3.14159265358979323846 / 180.0, Vec3(0.3, -0.5, 0.81).normalized()).toRotationMatrix();
}

/// Inner nodes of a block are moved a little, those of the skin are not.
Vec3 distorted(const Vec3& x) {
  const double bubble = 64.0 * x.x() * (1 - x.x()) * x.y() * (1 - x.y()) * x.z() * (1 - x.z());
  return x + 0.04 * bubble * Vec3(1.0, -0.7, 0.5);
}

/// `bent`: lines of the mesh are moved along the interface; the sides stay plane.
std::function<Vec3(const Vec3&)> placed(const Vec3& lo, const Vec3& hi, const base::Mat3& R, double bent = 0.0) {
  return [=](const Vec3& x) {
    const double bubble = bent * 16.0 * x.x() * (1 - x.x()) * x.y() * (1 - x.y());
    return Vec3(R * (lo + (hi - lo).cwiseProduct(distorted(x + bubble * Vec3(1.0, -0.6, 0.0)))));
  };
}

body::SolidLoad traction(const std::string& name, const std::string& face, const Vec3& t) {
  body::SolidLoad load;
  load.name = name;
  load.face = face;
  load.traction_MPa = t;
  return load;
}

/// Two blocks, one on the other, under the uniform stress of pressure p and shear tau across their interface (nu = 0):
/// the bottom is fixed, the top is moved, and the sides bear the shear that belongs to it.
sim::SolidProblem sheared_blocks(const PatchCase& c) {
  const auto R = turned_by(c.turn_deg);
  const Vec3 lo = c.partly ? Vec3(-0.37, -0.21, 0.0) : Vec3(0, 0, 0),
             hi = c.partly ? Vec3(1.28, 1.43, 1.0) : Vec3::Ones();
  auto lower = support::solid("lower", support::block(c.lower, c.lower_parts, Vec3::Ones(), placed(lo, hi, R, c.bent)),
                              patch_E, 0.0);
  lower.rigid = c.partly;
  auto upper = support::solid(
      "upper", support::block(c.upper, c.upper_parts, Vec3::Ones(), placed({0, 0, 1}, {1, 1, 2}, R)), patch_E, 0.0);
  lower.supports = {
      support::by_node("bottom", "z0", {support::fixed_motion(), support::fixed_motion(), support::fixed_motion()}, R)};
  const double height = c.partly ? 1.0 : 2.0;  // of what deforms
  upper.supports = {support::by_node("top", "z1",
                                     {support::moved(height * patch_shear / (0.5 * patch_E), ""),
                                      support::fixed_motion(), support::moved(-height * patch_p / patch_E, "")},
                                     R)};
  for (auto* body : {&lower, &upper})
    if (!body->rigid)
      body->loads = {traction("left", "x0", R * Vec3(0, 0, -patch_shear)),
                     traction("right", "x1", R * Vec3(0, 0, patch_shear))};
  auto problem = c.lower_is_secondary ? support::problem_of({lower, upper}, {0, "z1"}, {1, "z0"}, 0.5, 0.2)
                                      : support::problem_of({lower, upper}, {1, "z0"}, {0, "z1"}, 0.5, 0.2);
  problem.scene.steps = {support::step_of(1)};
  return problem;
}

class SolidPatch : public testing::TestWithParam<PatchCase> {};

}  // namespace

TEST_P(SolidPatch, PressureAndShearAreUniform) {
  // Two blocks with meshes that do not match, turned, bent or covered in part, transmit a uniform pressure and a shear
  // below mu p exactly, and forces and moments on each balance.
  const auto played = support::play(sheared_blocks(GetParam()));
  ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
  ASSERT_FALSE(played.frames.empty());
  const auto& surface = played.frames.back().surfaces.front();
  double worst = 0.0, worst_shear = 0.0;
  for (std::size_t j = 0; j < surface.pressure_MPa.size(); ++j) {
    if (surface.area_mm2[j] == 0.0 && GetParam().partly) continue;
    worst = std::max(worst, std::abs(surface.pressure_MPa[j] - patch_p));
    worst_shear = std::max(worst_shear, std::abs(surface.shear_MPa[j].norm() - patch_shear));
    EXPECT_EQ(surface.status[j], 1);
  }
  EXPECT_LE(worst, 1e-10 * patch_p);
  EXPECT_LE(worst_shear, 1e-10 * patch_p);
  EXPECT_LE(played.summary.balance, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, SolidPatch,
    testing::Values(
        PatchCase{"hex_on_hex", mesh::SolidKind::hex8, mesh::SolidKind::hex8, {3, 3, 2}, {2, 2, 2}, true, 0},
        PatchCase{"hex_on_hex_turned", mesh::SolidKind::hex8, mesh::SolidKind::hex8, {3, 3, 2}, {2, 2, 2}, true, 30},
        PatchCase{"coarse_secondary", mesh::SolidKind::hex8, mesh::SolidKind::hex8, {3, 3, 2}, {2, 2, 2}, false, 30},
        PatchCase{"tri_on_quad", mesh::SolidKind::hex8, mesh::SolidKind::tet4, {3, 2, 2}, {2, 3, 2}, false, 30},
        PatchCase{"quad_on_tri", mesh::SolidKind::hex8, mesh::SolidKind::tet4, {3, 2, 2}, {2, 3, 2}, true, 30},
        PatchCase{"tri6_on_tri6", mesh::SolidKind::tet10, mesh::SolidKind::tet10, {2, 2, 1}, {3, 1, 1}, true, 30},
        PatchCase{"tri6_on_quad", mesh::SolidKind::hex8, mesh::SolidKind::tet10, {3, 3, 2}, {2, 2, 1}, false, 0},
        PatchCase{"quad_on_tri6", mesh::SolidKind::hex8, mesh::SolidKind::tet10, {3, 3, 2}, {2, 2, 1}, true, 0},
        PatchCase{"tri6_turned", mesh::SolidKind::hex8, mesh::SolidKind::tet10, {3, 3, 2}, {2, 2, 1}, false, 30},
        PatchCase{"bent_lines", mesh::SolidKind::hex8, mesh::SolidKind::hex8, {4, 4, 2}, {3, 3, 2}, true, 30, 0.08},
        PatchCase{"bent_primary", mesh::SolidKind::hex8, mesh::SolidKind::hex8, {4, 4, 2}, {3, 3, 2}, false, 30, 0.03},
        PatchCase{"bent_triangles", mesh::SolidKind::tet4, mesh::SolidKind::hex8, {4, 4, 2}, {3, 3, 2}, true, 30, 0.08},
        PatchCase{"partly_quad", mesh::SolidKind::hex8, mesh::SolidKind::hex8, {3, 2, 1}, {4, 5, 2}, true, 30, 0, true},
        PatchCase{"partly_tri", mesh::SolidKind::tet4, mesh::SolidKind::tet4, {3, 2, 1}, {4, 5, 2}, true, 30, 0, true},
        PatchCase{
            "partly_tri6", mesh::SolidKind::tet10, mesh::SolidKind::hex8, {2, 1, 1}, {4, 5, 2}, true, 30, 0, true},
        PatchCase{
            "larger_primary", mesh::SolidKind::hex8, mesh::SolidKind::tet10, {5, 4, 1}, {2, 2, 1}, false, 30, 0, true}),
    [](const auto& one) { return std::string(one.param.name); });

TEST(SolidPatch, ABodyThatContactAloneHoldsTransmitsItsLoad) {
  // A block without support along the load is held by contact alone; the pressure is uniform and equal to the load.
  auto lower = support::solid(
      "lower", support::block(mesh::SolidKind::hex8, {3, 3, 2}, Vec3::Ones(), support::box({0, 0, 0}, {1, 1, 1})),
      patch_E, 0.3);
  auto upper = support::solid(
      "upper", support::block(mesh::SolidKind::hex8, {2, 2, 2}, Vec3::Ones(), support::box({0, 0, 1}, {1, 1, 2})),
      patch_E, 0.3);
  for (auto* body : {&lower, &upper}) body->supports = {support::symmetry("x", "x0"), support::symmetry("y", "y0")};
  lower.supports.push_back(support::symmetry("z", "z0"));
  body::SolidLoad press;
  press.name = "press";
  press.face = "z1";
  press.pressure_MPa = patch_p;
  upper.loads = {press};
  auto problem = support::problem_of({lower, upper}, {0, "z1"}, {1, "z0"}, 0.0, 0.2);
  problem.scene.steps = {support::step_of(1)};
  const auto played = support::play(problem);
  ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
  for (const double p : played.frames.back().surfaces.front().pressure_MPa) EXPECT_NEAR(p, patch_p, 1e-10 * patch_p);
  EXPECT_NEAR(played.rows.back().supports[2].force_N.z(), patch_p, 1e-10 * patch_p);
  EXPECT_LE(played.summary.balance, 1e-12);
}

TEST(SolidPatch, WithoutSupportAndContactNamesWhatIsFree) {
  // A body that neither supports nor contact hold ends the run with the motions that are free, by name.
  auto lower = support::solid("lower", support::block(mesh::SolidKind::hex8, {2, 2, 2}, Vec3::Ones()), patch_E, 0.3);
  lower.supports = {
      support::by_node("bottom", "z0", {support::fixed_motion(), support::fixed_motion(), support::fixed_motion()})};
  auto upper = support::solid(
      "upper", support::block(mesh::SolidKind::hex8, {2, 2, 2}, Vec3::Ones(), support::box({0, 0, 1}, {1, 1, 2})),
      patch_E, 0.3);
  body::SolidLoad pull = traction("pull", "z1", {0, 0, 10.0});
  upper.loads = {pull};
  auto problem = support::problem_of({lower, upper}, {0, "z1"}, {1, "z0"}, 0.3, 0.2);
  problem.scene.steps = {support::step_of(1)};
  problem.scene.max_cutbacks = 1;
  const auto played = support::play(problem);
  EXPECT_EQ(played.summary.status, sim::RunStatus::failed);
  EXPECT_NE(played.summary.reason.find("upper"), std::string::npos) << played.summary.reason;
}
