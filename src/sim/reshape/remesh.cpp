#include "sim/reshape/remesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "adapt/redraw/remesh.hpp"
#include "adapt/transfer/gauss_transfer.hpp"
#include "adapt/transfer/transfer.hpp"
#include "body/turning.hpp"
#include "fem/finite.hpp"
#include "mesh/quality.hpp"
#include "sim/measure/displacements.hpp"
#include "sim/measure/zones.hpp"
#include "sim/problem/drive.hpp"
#include "sim/problem/timer.hpp"
#include "sim/reshape/carry.hpp"

namespace reye::sim {

namespace {

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

/// Where the equilibrium on a fresh mesh starts.
struct FreshStart {
  Vector q;
  body::Interior interior;
  double projection = 0.0;  ///< the farthest that a node lay outside the old mesh
};

std::string start_linear(const Displaced& before, const mesh::Mesh& fresh, const body::LinearBody& linear,
                         FreshStart& start) {
  base::Points contact, u;
  for (int node : linear.contact_nodes()) contact.push_back(fresh.X[node]);
  if (const auto* turning = linear.turning()) start.q[turning->angle] = before.angle;
  const std::string failure = carry_displacement(before.on->mesh, before.u, contact, u, start.projection);
  if (failure.empty()) body::seat(linear, u, start.q);
  return failure;
}

std::string start_nonlinear(const Displaced& before, const mesh::Mesh& fresh, const body::NonlinearBody& nonlinear,
                            const adapt::GaussOptions& gauss, FreshStart& start) {
  const mesh::Mesh& old = before.on->mesh;
  auto& interior = start.interior;
  interior = nonlinear.start();
  base::Points u;
  const std::string failure = carry_displacement(old, before.u, fresh.X, u, start.projection);
  if (!failure.empty()) return failure;
  nonlinear.seat(u, start.q, interior.y);
  if (!before.F0.empty()) interior.F0 = carry_prestrain(old, before.F0, fresh, gauss);
  if (!before.elastic.empty())
    interior.history =
        nonlinear.compatible(interior, start.q, adapt::transfer_elastic(old, before.elastic, fresh, gauss));
  return {};
}

/// Start values of q on a fresh mesh: supports as they were, nodes displaced as the old mesh is at their place. A
/// linear body has no other state, a nonlinear one its interior.
std::string start_values(const Displaced& before, const mesh::Mesh& fresh, const body::Operator& op,
                         const adapt::GaussOptions& gauss, FreshStart& start) {
  for (const auto& now : body::support_columns(op))
    for (const auto& then : before.supports)
      if (then.support == now.support && then.motion == now.motion) start.q[now.column] = before.q[then.column];
  if (const auto* linear = std::get_if<body::LinearBody>(&op)) return start_linear(before, fresh, *linear, start);
  return start_nonlinear(before, fresh, std::get<body::NonlinearBody>(op), gauss, start);
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

/// A body that is being remeshed: as it was, its fresh shape and the record of it.
struct FreshBody {
  Displaced before;
  body::ShapePtr shape;
  RemeshRecord record;
};

/// Remeshes one body. Returns why that fails, or nothing.
std::string remesh_body(const Problem& problem, const State& state, const solver::System& old, int b, Change& change,
                        FreshBody& fresh) {
  auto& next = change.next;
  const auto& reason = change.reasons[b];
  const std::string about = "remeshing body " + problem.inputs[b].name;
  auto options = problem.scene.remesh.options;
  options.keep_nodes = !reason.divide;
  const auto made = adapt::remesh(next.shapes[b], problem.scene.analysis,
                                  followed_zones(problem, state, b, *next.shapes[b]), options);
  if (!made.failure.empty()) return about + " (" + reason.text + "): " + made.failure;
  fresh.before = displaced_body(problem, state, old, b, reason.renew, next.shapes[b]);
  const std::string lost =
      carry_displaced(state, b, fresh.before, recovered(problem, state, old, b), reason.renew, made.shape->mesh, next);
  if (!lost.empty()) return about + ": " + lost;
  fresh.record = record_of(problem, next, b, reason.text, next.shapes[b]->mesh, made);
  fresh.shape = made.shape;
  ++next.counts.remeshes;
  return {};
}

void carry_contacts(const Problem& problem, const std::vector<body::ShapePtr>& to, Change& change, Cache& cache) {
  Timer timer(cache, "adapt");
  auto& next = change.next;
  for (std::size_t c = 0; c < problem.contacts.size(); ++c)
    carry_contact(problem.contacts[c], problem.scene.analysis, next.shapes, to, next.solution.contacts[c],
                  change.held[c]);
}

/// Start values of a remeshed body in `next`. Returns why there are none, or nothing.
std::string start_fresh(const Problem& problem, const solver::System& system, int b, FreshBody& fresh, State& next) {
  const auto& op = system.bodies[b];
  const adapt::GaussOptions gauss{problem.scene.remesh.state_transfer, problem.scene.analysis};
  FreshStart start{Vector::Zero(body::dofs(op)), std::move(next.solution.interiors[b])};
  const std::string failure = start_values(fresh.before, fresh.shape->mesh, op, gauss, start);
  if (!failure.empty()) return "remeshing body " + problem.inputs[b].name + ": " + failure;
  next.solution.q.high.segment(system.offset[b], start.q.size()) = start.q;
  next.solution.interiors[b] = std::move(start.interior);
  fresh.record.projection_mm = start.projection;
  return {};
}

/// Start values on the fresh meshes; `parts`: q of each body before. Returns why there are none, or nothing.
std::string start_on_meshes(const Problem& problem, const solver::System& system, const std::vector<Vector>& parts,
                            std::map<int, FreshBody>& fresh, State& next) {
  next.solution.q = Vector::Zero(system.dofs);
  for (int b = 0; b < problem.body_count(); ++b) {
    if (!fresh.contains(b))
      next.solution.q.high.segment(system.offset[b], parts[b].size()) = parts[b];
    else if (std::string failure = start_fresh(problem, system, b, fresh[b], next); !failure.empty())
      return failure;
  }
  renew_displaced(problem, system, next);
  return {};
}

}  // namespace

std::string remesh_bodies(const Problem& problem, const State& state, Change& change, Cache& cache,
                          std::vector<RemeshRecord>& records) {
  std::map<int, FreshBody> fresh;
  std::vector<Vector> parts;
  auto shapes = change.next.shapes;
  for (int b = 0; b < problem.body_count(); ++b) {
    parts.emplace_back(cache.system->part(state.solution.q.high, b));
    if (change.reasons[b].text.empty()) continue;
    Timer timer(cache, "adapt");
    if (auto why = remesh_body(problem, state, *cache.system, b, change, fresh[b]); !why.empty()) return why;
    shapes[b] = fresh[b].shape;
  }
  carry_contacts(problem, shapes, change, cache);
  change.next.shapes = std::move(shapes);
  const auto kept = timed_system(problem, change.next, cache);
  const auto& system = *kept;
  if (auto why = start_on_meshes(problem, system, parts, fresh, change.next); !why.empty()) return why;
  for (auto& [b, body] : fresh) records.push_back(std::move(body.record));
  return {};
}

}  // namespace reye::sim
