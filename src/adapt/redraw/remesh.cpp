#include "adapt/redraw/remesh.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

#include "adapt/redraw/correct.hpp"
#include "adapt/redraw/redraw.hpp"
#include "adapt/redraw/trace.hpp"
#include "adapt/shape/crossing.hpp"
#include "adapt/shape/relocation.hpp"
#include "base/errors.hpp"
#include "mesh/arc.hpp"
#include "mesh/quality.hpp"

namespace reye::adapt {

namespace {

using base::Points;

std::string lead(const cad::Drawing& drawing) {
  return drawing.options.name.empty() ? "" : "body '" + drawing.options.name + "': ";
}

/// Edges of the drawing, each on the worn outline and on the fresh one.
std::vector<EdgePair> pairs_of(const cad::Drawing& drawing, const mesh::Mesh& worn, const mesh::Mesh& fresh,
                               std::string& failure) {
  const Trace before = trace(drawing.part.loops, worn.outline, worn.X);
  const Trace after = trace(drawing.part.loops, fresh.outline, fresh.X);
  failure = before.failure.empty() ? after.failure : before.failure;
  std::vector<EdgePair> pairs;
  for (std::size_t l = 0; failure.empty() && l < drawing.part.loops.size(); ++l)
    for (std::size_t k = 0; k < drawing.part.loops[l].size(); ++k) {
      const cad::Edge& edge = drawing.part.loops[l][k];
      if (!edge.worn && edge.type != cad::EdgeType::line) continue;
      pairs.push_back(
          {nodes_on(worn.outline[l], before.start[l], k), nodes_on(fresh.outline[l], after.start[l], k), edge.worn});
    }
  return pairs;
}

/// Moves the outline and, where its cells would suffer, the inner nodes after it.
void apply(mesh::Mesh& mesh, const Points& shift) {
  constexpr double allowed_loss = 0.9;
  const double before = mesh::poorest_cell(mesh).scaled_jacobian;
  const auto moved = [&](const Points& by) {
    Points X = mesh.X;
    for (std::size_t j = 0; j < X.size(); ++j) X[j] += by[j];
    return X;
  };
  mesh::Mesh next = mesh;
  next.X = moved(shift);
  if (!mesh.cells.empty() && !(mesh::poorest_cell(next).scaled_jacobian >= allowed_loss * before)) {
    next.X = moved(InteriorMotion(mesh).extend(shift));
    for (const auto& loop : mesh.outline)
      for (int node : loop) next.X[node] = mesh.X[node] + shift[node];
  }
  mesh = std::move(next);
}

std::string unsound(const mesh::Mesh& mesh) {
  std::ostringstream text;
  if (const auto crossing = find_crossing(mesh)) {
    text << "the new outline crosses itself at (" << crossing->at.x() << ", " << crossing->at.y() << ") mm";
    return text.str();
  }
  const auto poorest = mesh::poorest_cell(mesh);
  if (poorest.cell < 0 || poorest.scaled_jacobian > 0.0) return {};
  const base::Vec2& at = mesh.X[mesh.cells[poorest.cell][0]];
  text << "element " << poorest.cell << " of the new mesh, at (" << at.x() << ", " << at.y() << ") mm, is folded over";
  return text.str();
}

/// New cells inside the outline as it is; nothing where their quality is poor, as when its corners have become too
/// sharp for its nodes.
std::optional<mesh::Mesh> refilled(const cad::Drawing& drawing, const mesh::Mesh& worn, double most_nodes) {
  constexpr double good_enough = 0.3;  // scaled Jacobian of the poorest cell
  try {
    mesh::Mesh mesh = cad::refill(drawing, worn, most_nodes);
    if (mesh::poorest_cell(mesh).scaled_jacobian >= good_enough) return mesh;
  } catch (const base::MeshError&) {  // the outline is redivided
  }
  return std::nullopt;
}

/// A fresh mesh of the drawing with the content of the worn one.
std::shared_ptr<const body::Shape> mesh_of(const cad::Drawing& drawing, const mesh::Mesh& worn, base::Analysis analysis,
                                           double most_nodes, bool keep_nodes, RemeshResult& result) {
  const auto shape_of = [&](mesh::Mesh mesh) {
    mesh::follow_arc_origins(mesh, worn);
    return body::make_shape(std::move(mesh), std::make_shared<const cad::Drawing>(drawing));
  };
  if (keep_nodes)
    if (auto kept = refilled(drawing, worn, most_nodes)) return shape_of(std::move(*kept));
  mesh::Mesh fresh = cad::remesh(drawing, most_nodes);
  const auto pairs = pairs_of(drawing, worn, fresh, result.failure);
  if (!result.failure.empty()) return {};
  const auto correction = correct(analysis, worn.X, fresh.X, pairs, mesh::order(fresh.kind));
  result.area_residue = correction.residue;
  result.largest_correction_mm = correction.largest_mm;
  if (correction.largest_mm > 0.0) apply(fresh, correction.shift);
  if (result.failure = unsound(fresh); !result.failure.empty()) return {};
  return shape_of(std::move(fresh));
}

}  // namespace

RemeshResult remesh(const body::ShapePtr& worn, base::Analysis analysis, const std::vector<cad::FineZone>& zones,
                    const RemeshOptions& options) {
  RemeshResult result;
  const auto begin = std::chrono::steady_clock::now();
  auto [drawing, failure] = redraw(*worn, options.fit_tolerance_mm);
  result.failure = std::move(failure);
  if (!zones.empty()) drawing.zones = zones;
  drawing.axisymmetric = analysis == base::Analysis::axisymmetric;
  if (result.failure.empty()) try {
      result.shape = mesh_of(drawing, worn->mesh, analysis, options.most_nodes, options.keep_nodes, result);
    } catch (const base::MeshError& error) {
      result.failure = lead(drawing) + error.what();
    }
  result.mesh_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace reye::adapt
