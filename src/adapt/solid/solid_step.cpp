#include "adapt/solid/solid_step.hpp"

#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "adapt/solid/move_skin.hpp"
#include "adapt/solid/plane_faces.hpp"
#include "adapt/solid/skin_crossing.hpp"
#include "adapt/solid/solid_relocation.hpp"
#include "adapt/solid/solid_wear.hpp"
#include "base/formatted.hpp"

namespace reye::adapt {

namespace {

std::set<int> worn_groups(const mesh::SolidMesh& mesh, const WornSkin& worn) {
  std::set<int> groups;
  for (const WornSkinNode& node : worn.nodes)
    for (const FaceLoss& loss : node.losses)
      for (int f : loss.facets) groups.insert(mesh.skin[f].group);
  return groups;
}

/// Facets with a node that is not where it was.
std::vector<int> changed_facets(const mesh::SolidMesh& before, const mesh::SolidMesh& now) {
  std::vector<int> changed;
  for (int f = 0; f < static_cast<int>(now.skin.size()); ++f)
    for (int a = 0; a < now.skin[f].count(); ++a)
      if (const int node = now.skin[f].nodes[a]; now.X[node] != before.X[node]) {
        changed.push_back(f);
        break;
      }
  return changed;
}

double strip_of(const mesh::SolidMesh& before, const mesh::SolidMesh& now, const std::vector<int>& changed) {
  std::vector<mesh::Facet> facets;
  for (int f : changed) facets.push_back(now.skin[f]);
  return strip_between(before.X, now.X, facets);
}

std::string crossing_report(const mesh::SolidMesh& now, const mesh::SolidMesh& born, const SkinCrossing& crossing) {
  const auto& at = crossing.at;
  return meaning(crossing, now, born) +
         base::formatted(" at (%.6g, %.6g, %.6g) mm, facet %d with facet %d", at.x(), at.y(), at.z(), crossing.first,
                         crossing.second) +
         cause(now, born, at);
}

void judge_cells(SolidStepResult& result, const mesh::SolidMesh& now, const mesh::SolidMesh& born,
                 double least_quality) {
  const WornCells cells = worn_cells(now, born, least_quality);
  result.min_quality = cells.least;
  if (cells.unfit.cell >= 0) result.poor = poor_cell_report(now, born, cells.unfit, least_quality);
}

/// Faces beside the worn ones follow. Where they sweep volume of their own, at the straight edge of a curved face, the
/// motion of worn nodes is scaled until the strip is exact again. Returns the strip.
double let_faces_follow(mesh::SolidMesh& now, const mesh::SolidMesh& before, const mesh::SolidMesh& born,
                        const WornSkin& worn) {
  constexpr int most_passes = 8;
  const std::set<int> groups = worn_groups(before, worn);
  double removed = 0.0, last = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < most_passes; ++pass) {
    slide_plane_faces(now, born, groups);
    removed = strip_of(before, now, changed_facets(before, now));
    const double missing = worn.volume - removed;
    if (std::abs(missing) <= 1e-14 * worn.volume || !(std::abs(missing) < 0.5 * last)) break;
    last = std::abs(missing);
    const auto scale = [&](int node) { now.X[node] += missing / worn.volume * (now.X[node] - before.X[node]); };
    for (const WornSkinNode& node : worn.nodes)
      if (!node.middle) scale(node.node);
    for (const MovingMiddle& middle : worn.middles) scale(middle.node);
  }
  return removed;
}

void let_inside_follow(mesh::SolidMesh& mesh, const mesh::SolidMesh& born, SolidRelocationCache* cache) {
  if (mesh.cells.empty()) return;
  SolidRelocationCache own;
  (cache ? *cache : own).of(born)->follow(mesh, born);
}

}  // namespace

SolidStepResult evolve_solid(const std::shared_ptr<const mesh::SolidMesh>& mesh, const mesh::SolidMesh& born,
                             const std::vector<WornFace>& worn, double least_quality, SolidRelocationCache* cache) {
  SolidStepResult result;
  if (result.failure = bad_loss(worn); !result.failure.empty()) return result;
  const FacetsAtNodes facets_at(mesh->node_count(), mesh->skin);
  const WornSkin skin = worn_skin(*mesh, facets_at, worn);
  if (skin.nodes.empty()) {
    result.mesh = mesh;
    judge_cells(result, *mesh, born, least_quality);
    return result;
  }
  MovedSkin moved = move_skin(*mesh, facets_at, skin);
  result.theta = moved.theta;
  result.parts = moved.parts;
  if (result.failure = moved.failure; !result.failure.empty()) return result;
  auto next = std::make_shared<mesh::SolidMesh>(*mesh);
  next->X = std::move(moved.X);
  result.removed = let_faces_follow(*next, *mesh, born, skin);
  const std::vector<int> changed = changed_facets(*mesh, *next);
  auto crossing = find_fold(mesh->X, *next, changed);
  if (!crossing) crossing = find_crossing(*next, changed);
  if (crossing) {
    result.failure = crossing_report(*next, born, *crossing);
    return result;
  }
  let_inside_follow(*next, born, cache);
  judge_cells(result, *next, born, least_quality);
  result.mesh = std::move(next);
  return result;
}

}  // namespace reye::adapt
