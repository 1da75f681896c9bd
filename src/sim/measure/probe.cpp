#include "sim/measure/probe.hpp"

#include <limits>

#include "adapt/transfer/transfer.hpp"

namespace reye::sim {

namespace {

std::size_t nearest(const base::Points& X, const Vec2& to) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < X.size(); ++i)
    if ((X[i] - to).squaredNorm() < (X[best] - to).squaredNorm()) best = i;
  return best;
}

/// Displacement since the start: of the node nearest to the probe; once its body has a renewed reference, of the point
/// where that node was at first.
Vec2 probed(const Problem& problem, const State& state, const BodyFrame& body, int b, const Vec2& at) {
  if (state.displaced.empty() || state.displaced[b].empty()) return body.u[nearest(body.mesh->X, at)];
  const auto& first = problem.shapes[b]->mesh.X;
  adapt::Field field{"displacement", 2, {}};
  for (const Vec2& u : body.u) field.values.insert(field.values.end(), {u.x(), u.y()});
  mesh::Mesh point;
  point.X = {first[nearest(first, at)]};
  const auto found = adapt::transfer(*body.mesh, {std::move(field)}, point, std::numeric_limits<double>::infinity());
  const auto& u = found.fields.front().values;
  return {u[0], u[1]};
}

}  // namespace

std::map<std::string, Vec2> probes(const Problem& problem, const State& state, const Frame& frame) {
  std::map<std::string, Vec2> all;
  for (const auto& p : problem.scene.output.probes)
    for (int b = 0; b < problem.body_count(); ++b)
      if (frame.bodies[b].name == p.body) all[p.name] = probed(problem, state, frame.bodies[b], b, p.at_mm);
  return all;
}

}  // namespace reye::sim
