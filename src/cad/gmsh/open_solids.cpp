#include "cad/gmsh/open_solids.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "cad/gmsh/level_heap.hpp"
#include "cad/gmsh/model.hpp"
#include "cad/gmsh/session.hpp"
#include "cad/solid/solid_kernel.hpp"

namespace reye::cad {

namespace {

namespace occ = gmsh::model::occ;

bool known_to_occ(int dim, int tag) {
  gmsh::vectorpair known;
  occ::getEntities(known, dim);
  return std::find(known.begin(), known.end(), std::pair<int, int>(dim, tag)) != known.end();
}

/// Volume or area by OpenCASCADE; none of entities of other kernels.
std::optional<double> exact_mass(int dim, int tag) {
  if (!known_to_occ(dim, tag)) return std::nullopt;
  double mass = 0.0;
  occ::getMass(dim, tag, mass);
  return std::abs(mass);  // of a solid that is inside out it is negative
}

void enlarge(SolidBox& box, const base::Vec3& p) {
  for (int i = 0; i < 3; ++i) {
    box[i] = std::min(box[i], p[i]);
    box[i + 3] = std::max(box[i + 3], p[i]);
  }
}

SolidBox box_of_points(const std::vector<Triangle>& surface) {
  const base::Vec3& p = surface.front()[0];
  SolidBox box{p.x(), p.y(), p.z(), p.x(), p.y(), p.z()};
  for (const Triangle& t : surface)
    for (const base::Vec3& vertex : t) enlarge(box, vertex);
  return box;
}

double longest_edge(const std::vector<Triangle>& surface) {
  double longest = 0.0;
  for (const Triangle& t : surface)
    for (int k = 0; k < 3; ++k) longest = std::max(longest, (t[(k + 1) % 3] - t[k]).norm());
  return longest;
}

/// The point of the CAD's surface that is nearest to p; none where gmsh knows no projection.
std::optional<base::Vec3> projected(int face, const base::Vec3& p) {
  std::vector<double> closest, parameters;
  try {
    gmsh::model::getClosestPoint(2, face, {p.x(), p.y(), p.z()}, closest, parameters);
  } catch (const std::string&) {
    return std::nullopt;
  }
  if (closest.size() != 3) return std::nullopt;
  return base::Vec3(closest[0], closest[1], closest[2]);
}

/// Of p from a face. The projection on the surface counts where it lies beside a triangle, within the face; else the
/// nearest triangle does, at its edge.
double distance_from_face(int face, const std::vector<Triangle>& surface, const base::Vec3& p) {
  const double by_triangles = (nearest_on(surface, p) - p).norm();
  const auto on_surface = projected(face, p);
  if (!on_surface) return by_triangles;
  const double beside = 0.1 * longest_edge(surface);  // 0.067 of a chord is the sagitta of 30 degrees
  const double from_face = (nearest_on(surface, *on_surface) - *on_surface).norm();
  return from_face <= beside ? std::min(by_triangles, (*on_surface - p).norm()) : by_triangles;
}

/// The box of a face: by the CAD where that is tight, as of trimmed splines it is not, else by its triangles.
SolidBox box_of_face(int face, const std::vector<Triangle>& surface) {
  constexpr double padding = 1e-7;  // of OpenCASCADE
  const double tight = 0.05 * longest_edge(surface);
  SolidBox box = box_of_points(surface), by_cad;
  gmsh::model::getBoundingBox(2, face, by_cad[0], by_cad[1], by_cad[2], by_cad[3], by_cad[4], by_cad[5]);
  for (int i = 0; i < 6; ++i) {
    const double beyond = (i < 3 ? box[i] - by_cad[i] : by_cad[i] - box[i]) - padding;
    if (beyond > 0.0 && beyond <= tight) box[i] = by_cad[i] + (i < 3 ? padding : -padding);
  }
  return box;
}

RawFace read_face(int tag, const std::vector<Triangle>& surface, const Points3& probes) {
  RawFace face;
  face.tag = tag;
  face.type = type_of_face(tag);
  face.box_mm = box_of_face(tag, surface);
  face.area_mm2 = exact_mass(2, tag).value_or(area_of(surface));
  face.names = physical_names(2, tag);
  for (const base::Vec3& p : probes) face.distance_mm.push_back(distance_from_face(tag, surface, p));
  return face;
}

/// Whether OpenCASCADE leaves anything of a point that it intersects with the volume.
bool holds_exactly(int volume, const base::Vec3& p) {
  const int point = occ::addPoint(p.x(), p.y(), p.z());
  gmsh::vectorpair left;
  std::vector<gmsh::vectorpair> origins;
  occ::intersect({{0, point}}, {{3, volume}}, left, origins, -1, false, false);
  for (const auto& entity : left)
    if (entity != std::pair<int, int>(0, point)) occ::remove({entity});
  occ::remove({{0, point}});
  return !left.empty();
}

bool within(const SolidBox& box, const base::Vec3& p, double slack) {
  for (int i = 0; i < 3; ++i)
    if (p[i] < box[i] - slack || p[i] > box[i + 3] + slack) return false;
  return true;
}

/// Whether p lies in one of the volumes: by OpenCASCADE, or for other kernels by an odd number of faces on one side.
bool holds(const RawSolid& solid, const std::vector<Triangle>& skin, const base::Vec3& p) {
  const double slack = 0.1 * longest_edge(skin);
  if (!within(solid.box_mm, p, slack)) return false;
  return std::any_of(solid.volumes.begin(), solid.volumes.end(), [&](int volume) {
    return known_to_occ(3, volume) ? holds_exactly(volume, p) : std::abs(winding_number(skin, p)) > 0.5;
  });
}

void read_shape(RawSolid& solid, const Points3& probes) {
  std::vector<Triangle> skin;
  for (int tag : outer_faces(solid.volumes)) {
    const std::vector<Triangle> surface = triangles_of(tag);
    if (surface.empty()) throw std::string("face " + std::to_string(tag) + " cannot be divided into triangles");
    solid.faces.push_back(read_face(tag, surface, probes));
    kept_radii()[tag] = radii_of(tag);
    skin.insert(skin.end(), surface.begin(), surface.end());
  }
  if (skin.empty()) throw std::string("a solid has no faces");
  solid.box_mm = box_of_points(skin);
  for (const RawFace& face : solid.faces) {
    enlarge(solid.box_mm, {face.box_mm[0], face.box_mm[1], face.box_mm[2]});
    enlarge(solid.box_mm, {face.box_mm[3], face.box_mm[4], face.box_mm[5]});
  }
  for (int volume : solid.volumes) solid.volume_mm3 += exact_mass(3, volume).value_or(0.0);
  for (const base::Vec3& p : probes) solid.inside.push_back(holds(solid, skin, p));
}

}  // namespace

std::vector<RawSolid> labelled_volumes() {
  gmsh::vectorpair volumes;
  gmsh::model::getEntities(volumes, 3);
  std::vector<RawSolid> solids;
  for (const auto& [dim, tag] : volumes) {
    const std::set<std::string> names = physical_names(dim, tag);
    const std::string label = names.empty() ? imported_label(dim, tag) : *names.begin();
    const auto same = std::find_if(solids.begin(), solids.end(), [&](const RawSolid& solid) {
      return !names.empty() && solid.group && solid.label == label;
    });
    RawSolid& solid = same == solids.end() ? solids.emplace_back() : *same;
    solid.label = label;
    solid.group = !names.empty();
    solid.volumes.push_back(tag);
  }
  return solids;
}

std::vector<int> outer_faces(const std::vector<int>& volumes) {
  std::map<int, int> times;
  std::vector<int> faces;
  for (int volume : volumes) {
    gmsh::vectorpair boundary;
    gmsh::model::getBoundary({{3, volume}}, boundary, false, false, false);
    for (const auto& [dim, tag] : boundary)
      if (dim == 2 && ++times[tag] == 1) faces.push_back(tag);
  }
  std::erase_if(faces, [&](int tag) { return times[tag] > 1; });
  return faces;
}

std::vector<RawSolid> solids_of_shapes(const Points3& probes) {
  std::vector<RawSolid> solids = labelled_volumes();
  for (RawSolid& solid : solids) read_shape(solid, probes);
  return solids;
}

std::vector<RawSolid> open_by_gmsh(const std::string& path, Format format, const Points3& probes) {
  static std::optional<Session> session;
  session.emplace();
  level_heap();
  try {
    gmsh::model::add("solids");
    const bool loose = extension(path).starts_with(".ig");  // most IGES files hold a solid's faces, not the solid
    gmsh::option::setNumber("Geometry.OCCSewFaces", loose ? 1 : 0);
    gmsh::option::setNumber("Geometry.OCCMakeSolids", loose ? 1 : 0);
    load_model(path, format);
    gmsh::vectorpair volumes, surfaces;
    gmsh::model::getEntities(volumes, 3);
    gmsh::model::getEntities(surfaces, 2);
    if (volumes.empty() && !surfaces.empty())
      refuse(path,
             "holds faces but no solid: a body must be closed; export it as a solid and not as a surface or shell");
    if (volumes.empty()) refuse(path, "holds no solid");
    if (format == Format::mesh) return solids_of_mesh(path);
    if (has_cells())
      refuse(path, "makes a mesh of its own; a script must leave meshing to Reye, or be meshed to a .msh");
    const Silence silence;  // OpenCASCADE prints what it intersects
    triangulate();
    if (has_quadrilaterals())
      refuse(path, "asks for quadrilaterals (Recombine); Reye makes tetrahedra: take it out, or mesh it to a .msh");
    return solids_of_shapes(probes);
  } catch (const std::string& message) {
    refuse(path, "gmsh cannot read it: " + message);
  }
}

}  // namespace reye::cad
