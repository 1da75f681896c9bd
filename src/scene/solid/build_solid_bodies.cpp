#include <algorithm>

#include "scene/solid/build_solid.hpp"

namespace reye::scene {

std::map<std::string, material::Material> solid_materials_of(const Entry& root) {
  std::map<std::string, material::Material> materials;
  for (const auto& entry : root.all("material"))
    materials[entry.name()] = material::LinearElastic{.E_MPa = entry.number("E_MPa"), .nu = entry.number("nu")};
  return materials;
}

namespace {

void check_solid_body(const Entry& entry, Issues& issues) {
  if (entry.flag("rigid"))
    refuse(entry, {"material"}, "a rigid body takes none", issues);
  else if (!entry.given("material"))
    issues.push_back({entry.key("material"), "", "missing; a body has a material or is rigid"});
}

}  // namespace

std::vector<cad::SolidBodyOptions> solid_bodies_of(const Entry& root, Issues& issues) {
  std::vector<cad::SolidBodyOptions> bodies;
  for (const auto& entry : root.all("body")) {
    check_solid_body(entry, issues);
    const auto mesh = entry.at("mesh");
    cad::SolidBodyOptions body;
    body.name = entry.name();
    body.at = entry.triple("at");
    if (entry.given("name")) body.label = entry.text("name");
    body.rigid = entry.flag("rigid");
    body.mesh.element = entry.whole("order") == 1 ? mesh::SolidKind::tet4 : mesh::SolidKind::tet10;
    body.mesh.far_size_mm = mesh.number("far_size_mm");
    body.mesh.growth = mesh.number("growth");
    bodies.push_back(body);
  }
  return bodies;
}

namespace {

void add_box(const Entry& entry, cad::FaceOptions& face, Issues& issues) {
  const auto box = entry.numbers("box_mm");
  if (box.size() != 6) return;
  face.box_mm.emplace();
  std::copy(box.begin(), box.end(), face.box_mm->begin());
  for (std::size_t i = 0; i < 3; ++i)
    if (box[i] >= box[i + 3])
      return issues.push_back({entry.key("box_mm"), entry.written("box_mm"),
                               "must be [x_min, y_min, z_min, x_max, y_max, z_max], each minimum below its maximum; a "
                               "plane face needs some room on both sides"});
}

}  // namespace

std::vector<cad::FaceOptions> faces_of(const Entry& root, Issues& issues) {
  std::vector<cad::FaceOptions> faces;
  for (const auto& entry : root.all("face")) {
    cad::FaceOptions face;
    face.name = entry.name();
    face.body = entry.text("body");
    face.nearest_mm = entry.triple("nearest_mm");
    if (entry.given("type")) face.type = entry.text("type");
    add_box(entry, face, issues);
    faces.push_back(face);
  }
  return faces;
}

const cad::SolidBodyOptions* body_of_face(const cad::SolidGeometryOptions& geometry, const std::string& face) {
  const auto named = [](const std::string& name) { return [&name](const auto& item) { return item.name == name; }; };
  const auto found = std::find_if(geometry.faces.begin(), geometry.faces.end(), named(face));
  if (found == geometry.faces.end()) return nullptr;
  const auto body = std::find_if(geometry.bodies.begin(), geometry.bodies.end(), named(found->body));
  return body == geometry.bodies.end() ? nullptr : &*body;
}

bool exactly_one_of_solids(const Entry& entry, std::initializer_list<std::string_view> names,
                           std::initializer_list<std::string_view> of_plane, Issues& issues) {
  const auto given = [&](auto name) { return entry.given(name); };
  if (std::any_of(of_plane.begin(), of_plane.end(), given) && std::none_of(names.begin(), names.end(), given))
    return false;
  return exactly_one(entry, names, issues);
}

base::Vec3 direction_of(const Entry& entry, std::string_view key, Issues& issues) {
  const base::Vec3 vector = entry.triple(key).value_or(base::Vec3::Zero());
  const double length = vector.stableNorm();
  if (entry.triple(key) && length == 0.0) issues.push_back({entry.key(key), entry.written(key), "must not be zero"});
  if (!(length > 0.0) || !std::isfinite(length)) return base::Vec3::Zero();
  return (vector / length).normalized();
}

}  // namespace reye::scene
