#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "scene/solid/build_solid.hpp"

namespace reye::scene {

namespace {

constexpr std::array<std::string_view, 3> ways = {"x", "y", "z"};
constexpr std::array<std::string_view, 3> turns = {"rotation_x", "rotation_y", "rotation_z"};

/// The parts of a motion without those that hold keys of plane scenes, which are refused by themselves.
std::vector<Entry> own_parts(const Entry& support, std::string_view motion) {
  auto parts = support.parts(motion);
  std::erase_if(parts, [](const Entry& part) {
    const bool turn = part.key().find(".rotation_") != std::string::npos;
    return turn ? part.given("moment_N_mm_per_mm") || part.given("spring_N_mm_per_mm")
                : part.given("force_N_per_mm") || part.given("spring_N_per_mm2");
  });
  return parts;
}

body::Motion plain_motion(const Entry& support, std::string_view name) {
  return {.drive = support.text(name) == "fixed" ? body::Drive::fixed : body::Drive::free};
}

body::Motion solid_motion_of(const Entry& support, std::string_view name, const MotionKeys& keys, Issues& issues) {
  if (support.parts(name).empty()) return plain_motion(support, name);
  return motion_of(own_parts(support, name), keys, issues);
}

body::Motion normal_of(const Entry& support, Issues& issues) {
  auto motion = plain_motion(support, "normal");
  for (const auto& part : support.parts("normal")) {
    motion.drive = body::Drive::moved;
    if (!part.given("motion_mm") && !part.given("force_N") && !part.given("spring_N_per_mm"))
      issues.push_back({part.key("motion_mm"), "", "missing"});
    motion.parts.push_back({part.number("motion_mm"), part.text("history")});
  }
  return motion;
}

/// The direction at right angles to an axis that is nearest to a wished one; to y where the axis is within 10 degrees
/// of that.
base::Vec3 across(const base::Vec3& axis, const base::Vec3& wished) {
  constexpr double near = 0.9848;  // cos 10 degrees
  const base::Vec3 towards = std::abs(axis.dot(wished)) > near ? base::Vec3::UnitY() : wished;
  return (towards - towards.dot(axis) * axis).normalized();
}

base::Mat3 axes_of(const Entry& entry, Issues& issues) {
  constexpr double right = 1e-3;
  base::Vec3 x = direction_of(entry, "axis_x", issues), z = direction_of(entry, "axis_z", issues);
  if (x.isZero(0.0) && z.isZero(0.0)) return base::Mat3::Identity();
  if (x.isZero(0.0)) x = across(z, base::Vec3::UnitX());
  if (z.isZero(0.0)) z = across(x, base::Vec3::UnitZ());
  if (std::abs(x.dot(z)) > right) {
    issues.push_back({entry.key("axis_x"), entry.written("axis_x"), "must be at right angles to axis_z"});
    return base::Mat3::Identity();
  }
  x = (x - x.dot(z) * z).normalized();
  base::Mat3 axes;
  axes << x, z.cross(x), z;
  return axes;
}

bool pushed(const body::SolidSupport& support) {
  return std::any_of(support.along.begin(), support.along.end(),
                     [](const body::Motion& motion) { return motion.drive == body::Drive::loaded; });
}

template <class Names>
bool any_given(const Entry& entry, const Names& names) {
  return std::any_of(names.begin(), names.end(), [&](auto name) { return entry.given(name); });
}

body::SolidSupport solid_support_of(const Entry& entry, bool of_rigid_body, Issues& issues) {
  body::SolidSupport support;
  support.name = entry.name();
  support.face = entry.text("face");
  support.body = entry.text("body");
  support.axes = axes_of(entry, issues);
  support.centre_mm = entry.triple("centre_mm");
  for (std::size_t i = 0; i < 3; ++i) {
    support.along[i] = solid_motion_of(entry, ways[i], {"motion_mm", "force_N", "spring_N_per_mm"}, issues);
    support.about[i] = solid_motion_of(entry, turns[i], {"motion_rad", "moment_N_mm", "spring_N_mm_per_rad"}, issues);
  }
  support.normal = normal_of(entry, issues);
  const bool by_default =
      entry.given("body") || (of_rigid_body && !entry.given("normal")) || any_given(entry, turns) || pushed(support);
  support.rigid = entry.maybe_flag("rigid").value_or(by_default);
  return support;
}

void check_by_node_support(const Entry& entry, const body::SolidSupport& support, Issues& issues) {
  for (const auto turn : turns) refuse(entry, {turn}, "needs a rigid face", issues);
  refuse(entry, {"centre_mm"}, "has no use where the face is not rigid", issues);
  if (pushed(support))
    issues.push_back({entry.key("rigid"), entry.written("rigid"),
                      "a force or a spring needs a rigid face; or use [load] for a force"});
  if (entry.given("normal") && !any_given(entry, ways))
    refuse(entry, {"axis_x", "axis_z"}, "has no use: normal follows the face", issues);
}

void check_solid_support(const Entry& entry, const body::SolidSupport& support, Issues& issues) {
  if (!any_given(entry, ways) && !any_given(entry, turns) && !entry.given("normal"))
    issues.push_back({entry.key(), "", "names no motion: x, y, z, normal, rotation_x, rotation_y or rotation_z"});
  if (!exactly_one_of_solids(entry, {"face", "body"}, {"edge", "point_mm"}, issues)) return;
  if (support.rigid)
    refuse(entry, {"normal"}, "a rigid face has no motion along its normals; take axis_z along the normal, and z",
           issues);
  else if (entry.given("body"))
    refuse(entry, {"rigid"}, "a rigid body moves as one", issues);
  else
    check_by_node_support(entry, support, issues);
}

}  // namespace

std::string symmetry_support(const std::string& face) { return "symmetry:" + face; }

std::vector<body::SolidSupport> solid_supports_of(const Entry& root, const cad::SolidGeometryOptions& geometry,
                                                  Issues& issues) {
  std::vector<body::SolidSupport> supports;
  for (const auto& entry : root.all("support")) {
    const auto* body = body_of_face(geometry, entry.text("face"));
    supports.push_back(solid_support_of(entry, body && body->rigid, issues));
    check_solid_support(entry, supports.back(), issues);
  }
  for (const auto& face : root.texts("symmetry")) {
    auto& support = supports.emplace_back();
    support.name = symmetry_support(face);
    support.face = face;
    support.normal.drive = body::Drive::fixed;
  }
  return supports;
}

}  // namespace reye::scene
