#include "cad/solid/solid_bytes.hpp"

#include <algorithm>
#include <cmath>

#include "cad/part/bytes.hpp"

namespace reye::cad {

template <class Archive>
void pass(Archive& archive, mesh::Facet& facet) {
  archive(facet.kind), archive(facet.nodes), archive(facet.group);
}

template <class Archive>
void pass(Archive& archive, RawFace& face) {
  archive(face.tag), archive(face.type), archive(face.box_mm), archive(face.area_mm2), archive(face.names);
  archive(face.distance_mm);
}

template <class Archive>
void pass(Archive& archive, RawSolidMesh& mesh) {
  archive(mesh.nodes), archive(mesh.kind), archive(mesh.cells), archive(mesh.facets), archive(mesh.names);
}

template <class Archive>
void pass(Archive& archive, RawSolid& solid) {
  archive(solid.label), archive(solid.group), archive(solid.volumes), archive(solid.volume_mm3);
  archive(solid.box_mm), archive(solid.faces), archive(solid.inside), archive(solid.mesh);
}

template <class Archive>
void pass(Archive& archive, SizeZone& zone) {
  archive(zone.centre), archive(zone.radius), archive(zone.half_widths), archive(zone.size);
}

template <class Archive>
void pass(Archive& archive, SolidOrder& order) {
  archive(order.volumes), archive(order.skin_only), archive(order.second_order), archive(order.far_size);
  archive(order.growth), archive(order.zones);
}

template <class Archive>
void pass(Archive& archive, SizePoint& point) {
  archive(point.at), archive(point.size);
}

template <class Archive>
void pass(Archive& archive, SkinFilling& filling) {
  archive(filling.X), archive(filling.triangles), archive(filling.far_size), archive(filling.growth);
  archive(filling.zones), archive(filling.points);
}

template <class Archive>
void pass(Archive& archive, SolidQuery& query) {
  archive(query.probes);
}

template <class Archive>
void pass(Archive& archive, SolidAnswer& answer) {
  archive(answer.solids), archive(answer.issues);
}

template <class Archive>
void pass(Archive& archive, SolidMeshAnswer& answer) {
  archive(answer.mesh), archive(answer.failure);
}

namespace {

constexpr double most_mm = 1e9;  // a thousand kilometres

void check_number(double x) {
  if (!std::isfinite(x)) throw std::runtime_error("holds a number that is not finite");
}

void check_raw_box(const SolidBox& box) {
  for (double x : box)
    if (!(std::abs(x) <= most_mm)) throw std::runtime_error("holds a box beyond 1e9 mm");
}

void check_raw_face(const RawFace& face, std::size_t probes) {
  if (face.type < FaceType::plane || face.type > FaceType::spline)
    throw std::runtime_error("holds a face of no known kind");
  if (face.distance_mm.size() != probes) throw std::runtime_error("holds a face without distances");
  check_raw_box(face.box_mm);
  check_number(face.area_mm2);
  for (double distance : face.distance_mm) check_number(distance);
}

template <std::size_t N>
void check_entries(const std::array<int, N>& nodes, int used, int count) {
  const auto known = [&](int node) { return node >= 0 && node < count; };
  if (!std::all_of(nodes.begin(), nodes.begin() + used, known) ||
      !std::all_of(nodes.begin() + used, nodes.end(), [](int node) { return node == -1; }))
    throw std::runtime_error("holds a cell or facet that refers to a node that does not exist");
}

void check_raw_mesh(const RawSolidMesh& mesh, std::size_t faces) {
  const int count = static_cast<int>(mesh.nodes.size());
  if (mesh.kind < mesh::SolidKind::tet4 || mesh.kind > mesh::SolidKind::hex8)
    throw std::runtime_error("holds cells of no known kind");
  for (const base::Vec3& p : mesh.nodes)
    if (p.cwiseAbs().maxCoeff() > most_mm) throw std::runtime_error("holds a coordinate beyond 1e9 mm");
  for (const mesh::SolidCell& cell : mesh.cells) check_entries(cell, mesh::solid_nodes(mesh.kind), count);
  for (const mesh::Facet& facet : mesh.facets) {
    if (facet.kind != mesh::facet_kind(mesh.kind)) throw std::runtime_error("holds facets of another kind");
    check_entries(facet.nodes, facet.count(), count);
    if (facet.group < 0 || static_cast<std::size_t>(facet.group) >= faces)
      throw std::runtime_error("holds a facet of a face that does not exist");
  }
  for (const auto& [corners, names] : mesh.names)
    if (corners[0] < -1 || corners[1] < 0 || corners[3] >= count || !std::is_sorted(corners.begin(), corners.end()))
      throw std::runtime_error("names a facet with a node that does not exist");
}

}  // namespace

std::string bytes_of(const SolidQuery& query) { return written(query); }
std::string bytes_of(const SolidOrder& order) { return written(order); }
std::string bytes_of(const SkinFilling& filling) { return written(filling); }
std::string bytes_of(const SolidAnswer& answer) { return written(answer); }
std::string bytes_of(const SolidMeshAnswer& answer) { return written(answer); }

SolidQuery solid_query_of(std::string_view bytes) { return read_whole<SolidQuery>(bytes); }
SolidOrder solid_order_of(std::string_view bytes) { return read_whole<SolidOrder>(bytes); }
SkinFilling skin_filling_of(std::string_view bytes) { return read_whole<SkinFilling>(bytes); }

SolidAnswer solid_answer_of(std::string_view bytes, std::size_t probes) {
  SolidAnswer answer = read_whole<SolidAnswer>(bytes);
  for (const RawSolid& solid : answer.solids) {
    const bool own_mesh = !solid.mesh.cells.empty();
    if (own_mesh ? !solid.inside.empty() || !solid.faces.empty() : solid.inside.size() != probes)
      throw std::runtime_error("does not say of each point whether it is inside");
    check_number(solid.volume_mm3);
    check_raw_box(solid.box_mm);
    for (const RawFace& face : solid.faces) check_raw_face(face, probes);
    check_raw_mesh(solid.mesh, 0);
  }
  return answer;
}

SolidMeshAnswer solid_mesh_answer_of(std::string_view bytes, std::size_t faces) {
  SolidMeshAnswer answer = read_whole<SolidMeshAnswer>(bytes);
  check_raw_mesh(answer.mesh, faces);
  if (answer.failure.empty() && answer.mesh.facets.empty()) throw std::runtime_error("is no mesh");
  return answer;
}

}  // namespace reye::cad
