#include "cad/solid/own_solid.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "base/errors.hpp"
#include "cad/solid/skin_of.hpp"
#include "cad/solid/solid_shape.hpp"
#include "cad/solid/solid_text.hpp"

namespace reye::cad {

namespace {

void turn_inside_out(mesh::SolidKind kind, mesh::SolidCell& cell) {
  if (kind == mesh::SolidKind::hex8) {
    std::swap(cell[1], cell[3]);
    std::swap(cell[5], cell[7]);
    return;
  }
  std::swap(cell[1], cell[2]);
  if (kind != mesh::SolidKind::tet10) return;
  std::swap(cell[4], cell[6]);
  std::swap(cell[8], cell[9]);
}

void check_own_cells(RawSolidMesh& mesh) {
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    mesh::SolidCell& cell = mesh.cells[c];
    if (least_jacobian(mesh.nodes, mesh.kind, cell) > 0.0) continue;
    turn_inside_out(mesh.kind, cell);
    if (!(least_jacobian(mesh.nodes, mesh.kind, cell) > 0.0))
      throw base::MeshError("cell " + std::to_string(c) + " of its mesh, at " + text(mesh.nodes[cell[0]]) +
                            ", has no positive Jacobian");
  }
}

bool is_flat(const std::vector<Triangle>& surface) {
  base::Vec3 normal = base::Vec3::Zero();
  for (const Triangle& t : surface) normal += (t[1] - t[0]).cross(t[2] - t[0]);
  normal.normalize();
  double height = 0.0, extent = 0.0;
  for (const Triangle& t : surface)
    for (const base::Vec3& p : t) {
      height = std::max(height, std::abs(normal.dot(p - surface[0][0])));
      extent = std::max(extent, (p - surface[0][0]).norm());
    }
  return height <= 1e-6 * extent;
}

SolidBox box_round(const std::vector<Triangle>& surface) {
  base::Vec3 low = surface[0][0], high = low;
  for (const Triangle& t : surface)
    for (const base::Vec3& p : t) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return {low.x(), low.y(), low.z(), high.x(), high.y(), high.z()};
}

}  // namespace

void complete_own_solid(RawSolid& solid, const Points3& probes) {
  RawSolidMesh& mesh = solid.mesh;
  check_own_cells(mesh);
  mesh.facets = skin_of_cells(mesh);
  check_closed(mesh.nodes, mesh.facets);
  const std::vector<std::set<std::string>> names = group_by_angle(mesh, mesh.facets);
  solid.volume_mm3 = enclosed_volume(mesh.nodes, mesh.facets);
  std::vector<std::vector<mesh::Facet>> of_faces(names.size());
  for (const mesh::Facet& facet : mesh.facets) of_faces[facet.group].push_back(facet);
  for (std::size_t f = 0; f < names.size(); ++f) {
    const std::vector<Triangle> surface = triangles_of(mesh.nodes, of_faces[f]);
    RawFace& face = solid.faces.emplace_back();
    face.tag = -1;
    face.type = is_flat(surface) ? FaceType::plane : FaceType::spline;
    face.box_mm = box_round(surface);
    face.area_mm2 = area_of(surface);
    face.names = names[f];
    for (const base::Vec3& p : probes) face.distance_mm.push_back((nearest_on(surface, p) - p).norm());
  }
  const std::vector<Triangle> skin = triangles_of(mesh.nodes, mesh.facets);
  solid.box_mm = box_round(skin);
  for (const base::Vec3& p : probes) solid.inside.push_back(winding_number(skin, p) > 0.5);
}

}  // namespace reye::cad
