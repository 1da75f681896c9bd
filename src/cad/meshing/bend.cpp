#include "cad/meshing/bend.hpp"

#include <map>
#include <utility>

#include "mesh/quality.hpp"
#include "mesh/second_order.hpp"

namespace reye::cad {

namespace {

/// The outline edges of a cell go back to their chords where bending takes most of the cell's Jacobian.
void straighten(mesh::Mesh& mesh, const std::map<int, Vec2>& chord_middle) {
  constexpr double least = 0.2;  // of the scaled Jacobian of the straight cell
  const int n = mesh::corners(mesh.kind);
  for (const mesh::Cell& cell : mesh.cells) {
    std::map<int, Vec2> bent;
    for (int k = n; k < 2 * n; ++k)
      if (chord_middle.contains(cell[k])) bent[cell[k]] = mesh.X[cell[k]];
    if (bent.empty()) continue;
    const double quality = mesh::scaled_jacobian(mesh.X, mesh.kind, cell);
    for (const auto& [node, place] : bent) mesh.X[node] = chord_middle.at(node);
    if (quality < least * mesh::scaled_jacobian(mesh.X, mesh.kind, cell)) continue;
    for (const auto& [node, place] : bent) mesh.X[node] = place;
  }
}

}  // namespace

mesh::Mesh second_order(const mesh::Mesh& linear, const std::vector<Loop>& loops, const EdgesUnder& under) {
  mesh::Mesh mesh = mesh::to_second_order(linear);
  std::map<int, Vec2> chord_middle;
  for (std::size_t l = 0; l < mesh.outline.size(); ++l)
    for (std::size_t i = 1; i < mesh.outline[l].size(); i += 2) {
      const Edge& edge = loops[l][under[l][i / 2]];
      if (edge.type == EdgeType::line) continue;
      Vec2& mid = mesh.X[mesh.outline[l][i]];
      chord_middle[mesh.outline[l][i]] = mid;
      mid = at(edge, foot_on(edge, mid).s);
    }
  straighten(mesh, chord_middle);
  return mesh;
}

mesh::Mesh second_order(const mesh::Mesh& linear, const mesh::Mesh& outline) {
  mesh::Mesh mesh = mesh::to_second_order(linear);
  std::map<std::pair<double, double>, Vec2> after;  // mid node behind a vertex, known by its place
  for (const mesh::Chain& loop : outline.outline)
    for (std::size_t i = 1; i < loop.size(); i += 2)
      after[{outline.X[loop[i - 1]].x(), outline.X[loop[i - 1]].y()}] = outline.X[loop[i]];
  for (const mesh::Chain& loop : mesh.outline)
    for (std::size_t i = 1; i < loop.size(); i += 2)
      mesh.X[loop[i]] = after.at({mesh.X[loop[i - 1]].x(), mesh.X[loop[i - 1]].y()});
  return mesh;
}

}  // namespace reye::cad
