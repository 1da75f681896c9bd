#include <algorithm>
#include <cmath>

#include "base/formatted.hpp"
#include "cad/build/profile.hpp"
#include "scene/build.hpp"
#include "scene/geometry_files.hpp"

namespace reye::scene {

base::Analysis analysis_of(const Entry& root) {
  const auto name = root.text("analysis");
  if (name == "plane_stress") return base::Analysis::plane_stress;
  if (name == "axisymmetric") return base::Analysis::axisymmetric;
  return base::Analysis::plane_strain;
}

namespace {

std::optional<base::Kinematics> kinematics_of(const Entry& body) {
  const auto name = body.text("kinematics");
  if (name == "auto") return std::nullopt;
  return name == "finite" ? base::Kinematics::finite : base::Kinematics::small;
}

}  // namespace

std::map<std::string, BodyMaterial> body_materials_of(const Entry& root) {
  std::map<std::string, BodyMaterial> materials;
  for (const auto& entry : root.all("body"))
    materials[entry.name()] = {.material = entry.text("material"),
                               .b_bar = entry.maybe_flag("b_bar"),
                               .kinematics = kinematics_of(entry),
                               .kinematics_given = entry.given("kinematics")};
  return materials;
}

namespace {

void check_body(const Entry& entry, base::Analysis analysis, Issues& issues) {
  const bool rigid = entry.flag("rigid");
  if (rigid) refuse(entry, {"material", "b_bar", "kinematics"}, "a rigid body takes none", issues);
  if (!rigid && !entry.given("material"))
    issues.push_back({entry.key("material"), "", "missing; a body has a material or is rigid"});
  if (!rigid && analysis == base::Analysis::plane_stress && entry.flag("b_bar"))
    issues.push_back({entry.key("b_bar"), entry.written("b_bar"), "plane stress does not lock"});
}

}  // namespace

std::vector<cad::BodyOptions> bodies_of(const Entry& root, Issues& issues) {
  std::vector<cad::BodyOptions> bodies;
  for (const auto& entry : root.all("body")) {
    check_body(entry, analysis_of(root), issues);
    const auto mesh = entry.at("mesh");
    cad::BodyOptions body;
    body.name = entry.name();
    body.at = entry.pair("at");
    if (entry.given("name")) body.label = entry.text("name");
    body.rigid = entry.flag("rigid");
    body.mesh.element = mesh.text("element") == "tri" ? mesh::CellKind::tri3 : mesh::CellKind::quad4;
    body.mesh.order = entry.given("order") ? entry.whole("order") : 1;
    body.mesh.far_size_mm = mesh.number("far_size_mm");
    body.mesh.growth = mesh.number("growth");
    bodies.push_back(body);
  }
  return bodies;
}

namespace {

/// The rule against a profile that is too steep, as with heights in a unit other than that of arc lengths.
std::string too_steep(const cad::Profile& profile) {
  constexpr double steepest = 5.0;
  for (std::size_t i = 1; i < profile.arc_mm.size(); ++i) {
    const double rise = std::abs(profile.height_mm[i] - profile.height_mm[i - 1]),
                 along = profile.arc_mm[i] - profile.arc_mm[i - 1];
    if (rise <= steepest * along) continue;
    return base::formatted(
        "its height changes by %.4g mm over %.4g mm at arc length %.4g mm, more steeply than %g : 1; heights in um "
        "must be divided by 1000",
        rise, along, profile.arc_mm[i - 1], steepest);
  }
  return {};
}

std::optional<cad::Profile> profile_of(const Entry& entry, const std::string& path, Issues& issues) {
  const std::string name = entry.text("profile");
  if (name.empty()) return std::nullopt;
  const std::string file = beside(path, name);
  std::string rule = unreadable_rule(file);
  try {
    std::string bytes;
    if (rule.empty() && read_bytes(file, bytes)) {
      cad::Profile profile = cad::parse_profile(bytes);
      profile.file = name;
      rule = too_steep(profile);
      if (rule.empty()) return profile;
    }
  } catch (const base::InputError& error) {
    rule = error.issues().front().rule;
  }
  issues.push_back({entry.key("profile"), entry.written("profile"), rule});
  return std::nullopt;
}

}  // namespace

std::vector<cad::BoundaryOptions> boundaries_of(const Entry& root, const std::string& path, Issues& issues) {
  std::vector<cad::BoundaryOptions> boundaries;
  for (const auto& entry : root.all("boundary")) {
    cad::BoundaryOptions boundary;
    boundary.name = entry.name();
    boundary.body = entry.text("body");
    boundary.nearest_mm = entry.pair("nearest_mm");
    if (entry.given("type")) boundary.type = entry.text("type");
    if (const auto box = entry.numbers("box_mm"); box.size() == 4) {
      boundary.box_mm = {box[0], box[1], box[2], box[3]};
      if (box[0] >= box[2] || box[1] >= box[3])
        issues.push_back({entry.key("box_mm"), entry.written("box_mm"),
                          "must be [x_min, y_min, x_max, y_max] with x_min < x_max and y_min < y_max"});
    }
    boundary.profile = profile_of(entry, path, issues);
    boundaries.push_back(boundary);
  }
  return boundaries;
}

std::optional<cad::Section> section_of(const Entry& root, Issues& issues) {
  const auto entry = root.at("section");
  const auto point = entry.numbers("point_mm"), normal = entry.numbers("normal");
  if (point.size() != 3 || normal.size() != 3) return std::nullopt;
  const cad::Section section{{point[0], point[1], point[2]}, {normal[0], normal[1], normal[2]}};
  if (section.normal.isZero(0.0)) issues.push_back({entry.key("normal"), entry.written("normal"), "must not be zero"});
  return section;
}

bool exactly_one(const Entry& entry, std::initializer_list<std::string_view> names, Issues& issues) {
  const auto given = std::count_if(names.begin(), names.end(), [&](auto name) { return entry.given(name); });
  if (given == 1) return true;
  std::string list;
  for (const auto name : names) list += (list.empty() ? "" : ", ") + std::string(name);
  issues.push_back({entry.key(), "", (given == 0 ? "needs one of " : "takes only one of ") + list});
  return false;
}

std::string takes_instead(base::Analysis analysis, std::string_view key) {
  const bool axisymmetric = analysis == base::Analysis::axisymmetric;
  return (axisymmetric ? "an axisymmetric scene takes " : "a plane scene takes ") + std::string(key);
}

void refuse(const Entry& entry, std::initializer_list<std::string_view> names, const std::string& rule,
            Issues& issues) {
  for (const auto name : names)
    if (entry.given(name)) issues.push_back({entry.key(name), entry.written(name), rule});
}

}  // namespace reye::scene
