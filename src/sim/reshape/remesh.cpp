#include "sim/reshape/remesh.hpp"

#include <algorithm>
#include <cmath>

#include "adapt/redraw/remesh.hpp"
#include "adapt/transfer/gauss_transfer.hpp"
#include "adapt/transfer/transfer.hpp"
#include "body/turning.hpp"
#include "fem/finite.hpp"
#include "mesh/quality.hpp"
#include "sim/measure/displacements.hpp"
#include "sim/measure/renewable.hpp"
#include "sim/measure/zones.hpp"
#include "sim/problem/drive.hpp"
#include "sim/problem/timer.hpp"
#include "sim/reshape/carry.hpp"

namespace reye::sim {

namespace {

bool in_contact(const Problem& problem, int body) { return !problem.inputs[body].contact_boundaries.empty(); }

/// A body as it was before its remesh.
struct Displaced {
  body::ShapePtr on;  ///< X that all of this is counted on
  base::Points u;     ///< of all nodes, in the frame of a linear body
  Vector q;
  double angle = 0.0;  ///< of that frame
  std::vector<body::SupportColumn> supports;
  fem::ElasticStates elastic;
  fem::Prestrain F0;
};

/// The longest facet. No node of a sound remesh lies farther outside than half of it: chords of coarse facets cut off
/// less.
double longest_facet(const mesh::Mesh& mesh) {
  double longest = 0.0;
  for (const auto& loop : mesh.outline)
    for (std::size_t k = 1; k < loop.size(); ++k)
      longest = std::max(longest, (mesh.X[loop[k]] - mesh.X[loop[k - 1]]).norm());
  return longest;
}

/// Displacements of nodes at X, interpolated in the old mesh. Returns why this fails, or nothing.
std::string carry_displacement(const mesh::Mesh& old, const base::Points& u, const base::Points& X,
                               base::Points& carried, double& projection) {
  adapt::Field field{"displacement", 2, {}};
  for (const Vec2& v : u) field.values.insert(field.values.end(), {v.x(), v.y()});
  mesh::Mesh nodes;
  nodes.X = X;
  const auto result = adapt::transfer(old, {std::move(field)}, nodes, 0.5 * longest_facet(old));
  if (!result.failure.empty()) return result.failure;
  projection = result.largest_distance;
  const auto& values = result.fields.front().values;
  for (std::size_t k = 0; k < X.size(); ++k) carried.emplace_back(values[2 * k], values[2 * k + 1]);
  return {};
}

fem::Prestrain carry_prestrain(const mesh::Mesh& old, const fem::Prestrain& F0, const mesh::Mesh& fresh,
                               const adapt::GaussOptions& gauss) {
  base::Matrix rows(static_cast<Eigen::Index>(F0.size()), 5);
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    for (int k = 0; k < 5; ++k) rows(i, k) = F0[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
  rows = adapt::transfer_deformation(old, rows, fresh, gauss);
  fem::Prestrain carried;
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    carried.push_back({rows(i, 0), rows(i, 1), rows(i, 2), rows(i, 3), rows(i, 4)});
  return carried;
}

/// The body on the shape before the wear step; or, when the current shape becomes X, undisplaced on that.
Displaced displaced_body(const Problem& problem, const State& state, const solver::System& system, int b, bool renew,
                         const body::ShapePtr& current) {
  const auto& interior = state.solution.interiors[b];
  const Vector q = system.part(state.solution.q.high, b);
  Displaced body{state.shapes[b], {}, q, turned_by(system.bodies[b], q), body::support_columns(system.bodies[b]), {},
                 interior.F0};
  const auto* nonlinear = std::get_if<body::NonlinearBody>(&system.bodies[b]);
  if (nonlinear) body.elastic = nonlinear->elastic_states(interior, q);
  body.u = recovered_in_frame(problem, state, system, b);
  if (!renew) return body;
  body.on = current;
  body.u.assign(body.u.size(), Vec2::Zero());
  body.q.setZero();
  body.F0 = nonlinear->deformation(interior, q);
  return body;
}

/// Start values of q on a fresh mesh: supports as they were, nodes displaced as the old mesh is at their place. A
/// linear body has no other state, a nonlinear one its interior.
std::string start_values(const Displaced& before, const mesh::Mesh& fresh, const body::Operator& op,
                         const adapt::GaussOptions& gauss, Vector& q, body::Interior& interior, double& projection) {
  const mesh::Mesh& old = before.on->mesh;
  for (const auto& now : body::support_columns(op))
    for (const auto& then : before.supports)
      if (then.support == now.support && then.motion == now.motion) q[now.column] = before.q[then.column];
  base::Points u;
  if (const auto* linear = std::get_if<body::LinearBody>(&op)) {
    base::Points contact;
    for (int node : linear->contact_nodes()) contact.push_back(fresh.X[node]);
    if (const auto* turning = linear->turning()) q[turning->angle] = before.angle;
    const std::string failure = carry_displacement(old, before.u, contact, u, projection);
    if (failure.empty()) body::seat(*linear, u, q);
    return failure;
  }
  const auto& nonlinear = std::get<body::NonlinearBody>(op);
  interior = nonlinear.start();
  const std::string failure = carry_displacement(old, before.u, fresh.X, u, projection);
  if (!failure.empty()) return failure;
  nonlinear.seat(u, q, interior.y);
  if (!before.F0.empty()) interior.F0 = carry_prestrain(old, before.F0, fresh, gauss);
  if (!before.elastic.empty())
    interior.history = nonlinear.compatible(interior, q, adapt::transfer_elastic(old, before.elastic, fresh, gauss));
  return {};
}

/// Displacement of the nodes of a fresh mesh since the start: that before earlier renewals, and in a renewal the
/// present one, too. Returns why it cannot be carried, or nothing.
std::string carry_displaced(const State& state, int b, const Displaced& before, const base::Points& u, bool renew,
                            const mesh::Mesh& fresh, State& next) {
  base::Points all = state.displaced.empty() ? base::Points() : state.displaced[b];
  if (all.empty() && !renew) return {};
  all.resize(u.size(), Vec2::Zero());
  for (std::size_t i = 0; renew && i < u.size(); ++i) all[i] += u[i];
  next.displaced.resize(state.shapes.size());
  next.displaced[b].clear();
  double projection = 0.0;
  return carry_displacement(before.on->mesh, all, fresh.X, next.displaced[b], projection);
}

/// Computes D and M on the fresh meshes, from which the next equilibrium starts.
void renew_displaced(const Problem& problem, const solver::System& system, State& next) {
  auto& solution = next.solution;
  for (std::size_t c = problem.contacts.size(); c < system.contacts.size(); ++c)
    solution.contacts[c] = contact::fresh_state(system.contacts[c]);  // the tractions of a bond follow from equilibrium
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    contact::IncrementOptions held;
    held.held = true;
    held.inset = inset_at(problem.contacts[c], next.factors);
    const auto at = solver::positions(system, system.contacts[c], solution.q.high);
    contact::Interface face;
    const contact::ContactState before = solution.contacts[c];
    face.begin(system.contacts[c], before, at.secondary, at.primary, held);
    face.integrate(at.secondary, at.primary);
    face.renew_reference(solution.contacts[c]);
  }
}

RemeshRecord record_of(const Problem& problem, const State& next, int body, const std::string& reason,
                       const mesh::Mesh& old, const adapt::RemeshResult& made) {
  RemeshRecord r;
  r.cycle = next.cycle;
  r.body = problem.inputs[body].name;
  r.reason = reason;
  r.nodes_before = old.node_count();
  r.nodes_after = made.shape->mesh.node_count();
  r.scaled_jacobian_before = mesh::poorest_cell(old).scaled_jacobian;
  r.scaled_jacobian_after = mesh::poorest_cell(made.shape->mesh).scaled_jacobian;
  r.area_residue = made.area_residue;
  r.mesh_seconds = made.mesh_seconds;
  return r;
}

}  // namespace

std::vector<RemeshReason> remesh_reasons(const Problem& problem, const State& state, const solver::System& system,
                                         const std::vector<Moved>& moved) {
  const auto& options = problem.scene.remesh;
  std::vector<RemeshReason> reasons(moved.size());
  bool worn = false;  // without wear a fine zone stays as the user gave it
  for (int b = 0; b < problem.body_count(); ++b) worn = worn || moved[b].shape != state.shapes[b];
  const bool due = options.every_blocks > 0 && (state.counts.blocks + 1) % options.every_blocks == 0;
  for (int b = 0; b < problem.body_count(); ++b) {
    if (problem.rigid[b] || !in_contact(problem, b)) continue;
    const auto& [shape, poor] = moved[b];
    auto& reason = reasons[b];
    if (options.automatic && worn) {
      reason = {leaves_zone(problem, state, b, *shape), true};
      if (!reason.text.empty()) continue;
      reason = {poor, false};
    }
    if (options.automatic && shape != state.shapes[b]) {
      base::Points x = recovered(problem, state, system, b);
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += shape->mesh.X[i];
      reason.divide = adapt::measure(*shape, x).size_ratio.value > options.triggers.size_ratio;
      if (reason.text.empty())
        reason.text = adapt::why_remesh(*shape, can_renew(problem, b) ? nullptr : &x, options.triggers);
    }
    if (due && reason.text.empty())
      reason = {"every " + std::to_string(options.every_blocks) + " blocks, as asked for", false};
  }
  return reasons;
}

std::string remesh_bodies(const Problem& problem, const State& state, Change& change, Cache& cache,
                          std::vector<RemeshRecord>& records) {
  auto& [next, reasons, held] = change;
  const auto& old = cache.system;
  auto shapes = next.shapes;
  std::map<int, Displaced> displaced;
  std::vector<Vector> parts;
  for (int b = 0; b < problem.body_count(); ++b) {
    parts.emplace_back(old.part(state.solution.q.high, b));
    if (reasons[b].text.empty()) continue;
    Timer timer(cache, "adapt");
    auto options = problem.scene.remesh.options;
    options.keep_nodes = !reasons[b].divide;
    const auto made = adapt::remesh(next.shapes[b], problem.scene.analysis,
                                    followed_zones(problem, state, b, *next.shapes[b]), options);
    if (!made.failure.empty())
      return "remeshing body " + problem.inputs[b].name + " (" + reasons[b].text + "): " + made.failure;
    displaced[b] = displaced_body(problem, state, old, b, reasons[b].renew, next.shapes[b]);
    const std::string lost = carry_displaced(state, b, displaced[b], recovered(problem, state, old, b),
                                             reasons[b].renew, made.shape->mesh, next);
    if (!lost.empty()) return "remeshing body " + problem.inputs[b].name + ": " + lost;
    records.push_back(record_of(problem, next, b, reasons[b].text, next.shapes[b]->mesh, made));
    shapes[b] = made.shape;
    ++next.counts.remeshes;
  }
  {
    Timer timer(cache, "adapt");
    for (std::size_t c = 0; c < problem.contacts.size(); ++c)
      carry_contact(problem.contacts[c], problem.scene.analysis, next.shapes, shapes, next.solution.contacts[c],
                    held[c]);
  }
  next.shapes = std::move(shapes);
  const auto& system = timed_system(problem, next, cache);
  next.solution.q = Vector::Zero(system.dofs);
  std::size_t r = 0;
  for (int b = 0; b < problem.body_count(); ++b) {
    if (const auto found = displaced.find(b); found != displaced.end()) {
      parts[b] = Vector::Zero(body::dofs(system.bodies[b]));
      const auto& fresh = next.shapes[b]->mesh;
      const adapt::GaussOptions gauss{problem.scene.remesh.state_transfer, problem.scene.analysis};
      const std::string failure = start_values(found->second, fresh, system.bodies[b], gauss, parts[b],
                                               next.solution.interiors[b], records[r++].projection_mm);
      if (!failure.empty()) return "remeshing body " + problem.inputs[b].name + ": " + failure;
    }
    next.solution.q.high.segment(system.offset[b], parts[b].size()) = parts[b];
  }
  renew_displaced(problem, system, next);
  return {};
}

}  // namespace reye::sim
