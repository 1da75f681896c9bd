#include "adapt/solid/solid_remesh.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <map>

#include "adapt/solid/keep_content.hpp"
#include "adapt/solid/skin_crossing.hpp"
#include "adapt/solid/solid_middles.hpp"
#include "adapt/solid/solid_wear.hpp"
#include "base/errors.hpp"
#include "cad/solid/skin_filling.hpp"
#include "mesh/solid/solid_quality.hpp"

namespace reye::adapt {

namespace {

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double mean_edge_of(const Points3& X, const mesh::SolidCell& cell) {
  double sum = 0.0;
  for (int a = 0; a < 4; ++a)
    for (int b = a + 1; b < 4; ++b) sum += (X[cell[a]] - X[cell[b]]).norm();
  return sum / 6.0;
}

double far_size_of(const mesh::SolidMesh& born, const SolidRemeshOptions& options) {
  double largest = options.far_size_mm;
  for (const mesh::SolidCell& cell : born.cells)
    if (options.far_size_mm == 0.0) largest = std::max(largest, mean_edge_of(born.X, cell));
  return largest > 0.0 ? largest : std::numeric_limits<double>::infinity();
}

/// The skin alone, of first order, with groups and names of the facets it is like.
mesh::SolidMesh skin_mesh(const DrawnSkin& drawn, const mesh::SolidMesh& worn) {
  mesh::SolidMesh mesh;
  mesh.X = drawn.X;
  std::vector<std::vector<std::string>> names(worn.skin.size());
  for (const auto& [name, facets] : worn.faces)
    for (int f : facets) names[f].push_back(name);
  for (const DrawnFacet& facet : drawn.facets) {
    const auto& [a, b, c] = facet.corners;
    for (const std::string& name : names[facet.like]) mesh.faces[name].push_back(static_cast<int>(mesh.skin.size()));
    mesh.skin.push_back({mesh::FacetKind::tri3, {a, b, c, -1, -1, -1}, worn.skin[facet.like].group});
  }
  return mesh;
}

std::vector<int> fresh_facets(const DrawnSkin& drawn) {
  std::vector<int> fresh;
  for (std::size_t f = 0; f < drawn.facets.size(); ++f)
    if (drawn.facets[f].fresh) fresh.push_back(static_cast<int>(f));
  return fresh;
}

void fill(mesh::SolidMesh& mesh, double far_size, const SolidRemeshOptions& options) {
  cad::SkinFilling filling{mesh.X, {}, far_size, options.growth, options.zones, {}};
  for (const mesh::Facet& facet : mesh.skin) {
    const auto t = corners_of(facet);
    const Vec3 &a = mesh.X[t[0]], &b = mesh.X[t[1]], &c = mesh.X[t[2]];
    filling.triangles.push_back(t);
    filling.points.push_back({(a + b + c) / 3.0, ((b - a).norm() + (c - b).norm() + (a - c).norm()) / 3.0});
  }
  cad::RawSolidMesh filled = cad::fill_skin(filling);
  mesh.X = std::move(filled.nodes);
  mesh.cells = std::move(filled.cells);
}

/// Nodes inside the scar, whose facets are all of one group that is not plane there, and are fresh or have moved.
std::vector<char> scar_nodes(const mesh::SolidMesh& mesh, const DrawnSkin& drawn, const std::vector<char>& moved) {
  std::vector<char> in_scar(mesh.skin.size());
  std::map<int, std::vector<int>> by_group;
  for (std::size_t f = 0; f < in_scar.size(); ++f) {
    in_scar[f] = drawn.facets[f].fresh || moved[drawn.facets[f].like];
    if (in_scar[f]) by_group[mesh.skin[f].group].push_back(static_cast<int>(f));
  }
  std::erase_if(by_group, [&](const auto& entry) { return plane_of(mesh, entry.second).has_value(); });
  constexpr int unseen = -1, beside = -2;
  std::vector<int> group(mesh.X.size(), unseen);
  for (std::size_t f = 0; f < mesh.skin.size(); ++f) {
    const int own = mesh.skin[f].group;
    for (int a = 0; a < mesh.skin[f].count(); ++a) {
      int& known = group[mesh.skin[f].nodes[a]];
      known = in_scar[f] && by_group.contains(own) && (known == unseen || known == own) ? own : beside;
    }
  }
  std::vector<char> inside(group.size());
  for (std::size_t node = 0; node < group.size(); ++node) inside[node] = group[node] >= 0;
  return inside;
}

/// Gives the mesh the volume of the worn one.
void keep_volume(mesh::SolidMesh& mesh, const DrawnSkin& drawn, const mesh::SolidMesh& worn,
                 const mesh::SolidMesh& born, SolidRemeshResult& result) {
  if (result.fresh_facets == 0 && result.straightened == 0) return;
  const long double content = content_of(worn.X, worn.skin);
  result.volume_residue = static_cast<double>(content - content_of(mesh.X, mesh.skin));
  result.correction_mm = restore_content(mesh.X, mesh.skin, scar_nodes(mesh, drawn, moved_facets(worn, born)), content);
}

/// A mesh in a drawn skin. Throws base::MeshError.
SolidRemeshResult meshed(const DrawnSkin& drawn, const mesh::SolidMesh& worn, const mesh::SolidMesh& born,
                         const SolidRemeshOptions& options) {
  SolidRemeshResult result;
  mesh::SolidMesh mesh = skin_mesh(drawn, worn);
  const auto fresh = fresh_facets(drawn);
  result.fresh_facets = static_cast<int>(fresh.size());
  if (!fresh.empty() && find_crossing(mesh, fresh)) throw base::MeshError("the fresh surface crosses itself");
  if (!worn.cells.empty()) fill(mesh, far_size_of(born, options), options);
  std::vector<char> is_fresh(drawn.facets.size(), 0);
  for (int f : fresh) is_fresh[f] = 1;
  if (worn.skin.front().kind == mesh::FacetKind::tri6) add_middles(mesh, drawn, worn);
  result.straightened = straighten_skin(mesh, is_fresh);
  keep_volume(mesh, drawn, worn, born, result);
  mesh::check(mesh);
  for (int cell = 0; cell < mesh.cell_count(); ++cell)
    result.quality = std::min(result.quality, worn_quality(mesh, cell));
  result.mesh = std::make_shared<const mesh::SolidMesh>(std::move(mesh));
  return result;
}

SolidRemeshResult meshed_or_failure(const std::vector<ScarPart>& parts, const mesh::SolidMesh& worn,
                                    const mesh::SolidMesh& born, const SolidRemeshOptions& options) {
  try {
    return meshed(draw_skin(worn, parts), worn, born, options);
  } catch (const base::MeshError& error) {
    SolidRemeshResult failed;
    failed.failure = error.what();
    return failed;
  }
}

}  // namespace

bool can_be_remeshed(const mesh::SolidMesh& mesh) {
  return std::none_of(mesh.skin.begin(), mesh.skin.end(),
                      [](const mesh::Facet& facet) { return facet.kind == mesh::FacetKind::quad4; });
}

SolidRemeshResult remesh_solid(const mesh::SolidMesh& worn, const mesh::SolidMesh& born,
                               const SolidRemeshOptions& options) {
  SolidRemeshResult result;
  if (!can_be_remeshed(worn)) {
    result.failure = "hexahedra are not remeshed; mesh the body with tetrahedra";
    return result;
  }
  const double start = now_s();
  std::vector<ScarPart> parts;
  if (options.scar != ScarRoute::keep)
    parts = scar_parts(worn, born, cad::SolidSize(far_size_of(born, options), options.growth, options.zones, {}),
                       options.scar == ScarRoute::redraw);
  result = meshed_or_failure(parts, worn, born, options);
  if (!result.mesh && !parts.empty()) result = meshed_or_failure({}, worn, born, options);
  result.mesh_seconds = now_s() - start;
  return result;
}

}  // namespace reye::adapt
