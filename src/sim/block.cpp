#include "sim/block.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "adapt/shape_step.hpp"
#include "fem/stiffness.hpp"
#include "sim/measure.hpp"

namespace reye::sim {

namespace {

/// Adds the wall time of a scope to one room's account.
class Timer {
 public:
  Timer(Cache& cache, const char* room) : seconds_(cache.seconds[room]), start_(clock::now()) {}
  ~Timer() { seconds_ += std::chrono::duration<double>(clock::now() - start_).count(); }
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

 private:
  using clock = std::chrono::steady_clock;
  double& seconds_;
  clock::time_point start_;
};

const solver::System& timed_system(const Problem& problem, const State& state, Cache& cache) {
  Timer timer(cache, "body");
  return system_of(problem, state, cache);
}

IncrementRecord record_of(const Problem& problem, const State& state, const solver::System& system,
                          const solver::Controls& controls, const BlockSpan& span, double progress, int newton) {
  IncrementRecord r;
  r.step = span.step->name;
  r.cycle = state.cycle + (span.cycles ? span.jump * progress : 0.0);
  r.progress = progress;
  r.newton = newton;
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    const auto& contact = state.solution.contacts[c];
    const auto surfaces = surface_records(setup, contact, state.shapes, problem.contacts[c]);
    const auto largest = [](const std::vector<double>& v) { return v.empty() ? 0.0 : *std::max_element(v.begin(), v.end()); };
    r.pressure_max_MPa = std::max(r.pressure_max_MPa, largest(surfaces[0].pressure_MPa));
    r.depth_max_secondary_mm = std::max(r.depth_max_secondary_mm, largest(surfaces[0].wear_depth_mm));
    r.depth_max_primary_mm = std::max(r.depth_max_primary_mm, largest(surfaces[1].wear_depth_mm));
    r.energy_mJ += setup.options.wear.wears() ? contact.worn_work : contact.frictional_work;
  }
  r.support_forces = support_forces(problem, system, solver::reactions(system, state.solution, controls));
  return r;
}

/// True where a history that the step plays has a corner: motion does not go on as before.
bool corner_at(const scene::Scene& scene, const scene::Step& step, double progress) {
  for (const auto& name : step.play)
    for (const auto& corner : scene.histories.at(name))
      if (std::abs(corner[0] - progress) < 1e-9) return true;
  return false;
}

/// The block being played: where it started from, and how long its last increment was (0: none to go on from).
struct Playing {
  const BlockSpan& span;
  const Observer& observer;
  std::map<std::string, double> held;
  double last_length = 0.0;
};

/// One increment from progress `from` to `to`; on failure it is halved, up to `depth` times.
std::string play(const Problem& problem, State& state, Cache& cache, Playing& block, double from, double to, int depth) {
  const auto& [span, observer, held, last_length] = block;
  const auto& system = timed_system(problem, state, cache);
  const auto factors = factors_at(problem.scene, *span.step, to, held);
  auto controls = controls_at(problem, system, factors, *span.step, from, to, span.jump);
  if (last_length > 0.0 && !corner_at(problem.scene, *span.step, from)) controls.continues = (to - from) / last_length;
  solver::SolveResult result;
  {
    Timer timer(cache, "solver");
    result = cache.newton.solve(system, state.solution, controls);
  }
  state.counts.newton_iterations += result.report.solves;
  if (!result.report.converged) {
    const std::string where = "step \"" + span.step->name + "\", cycle " + std::to_string(state.cycle) + ", progress " +
                              std::to_string(from) + " to " + std::to_string(to) + ": " + result.report.reason;
    if (depth == 0) return where;
    ++state.counts.cutbacks;
    state.cutback_reasons.push_back(where);
    if (observer.log) observer.log("cut back: " + where);
    const double middle = 0.5 * (from + to);
    block.last_length = 0.0;
    const std::string first = play(problem, state, cache, block, from, middle, depth - 1);
    return first.empty() ? play(problem, state, cache, block, middle, to, depth - 1) : first;
  }
  Timer timer(cache, "sim");
  state.solution = std::move(result.state);
  state.factors = factors;
  block.last_length = to - from;
  ++state.counts.increments;
  if (observer.increment)
    observer.increment(record_of(problem, state, system, controls, span, to, result.report.solves));
  return {};
}

double deepest(const solver::System& system, const State& state) {
  double depth = 0.0;
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    for (double d : depths(system.contacts[c].secondary, state.solution.contacts[c].removed_secondary)) depth = std::max(depth, d);
    for (double d : depths(system.contacts[c].primary, state.solution.contacts[c].removed_primary)) depth = std::max(depth, d);
  }
  return depth;
}

void tell_progress(const Observer& observer, const State& state, const solver::System& system, const BlockSpan& span,
                   int increment, int increments, double progress) {
  if (!observer.progress) return;
  Progress p;
  p.step = span.step->name;
  p.cycle = state.cycle + (span.cycles ? span.jump * progress : 0.0);
  p.cycles = span.step->cycles;
  p.increment = increment;
  p.increments = increments;
  p.depth_max_mm = deepest(system, state);
  p.fraction = span.cycles ? (static_cast<double>(state.block) * span.step->jump + span.jump * progress) / span.step->cycles : progress;
  observer.progress(p);
}

/// Removed volumes per boundary of one body; several contacts may wear the same boundary.
std::vector<adapt::WornBoundary> worn_boundaries(const Problem& problem, const State& state, int body, double& total) {
  std::map<std::string, std::vector<double>> sums;
  const auto add = [&](const contact::BoundaryRef& ref, auto first, std::size_t count) {
    auto& sum = sums[ref.boundary];
    sum.resize(count, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
      sum[i] += *(first + static_cast<std::ptrdiff_t>(i));
      total += *(first + static_cast<std::ptrdiff_t>(i));
    }
  };
  const auto size = [&](const contact::BoundaryRef& ref) {
    return mesh::nodes_of(state.shapes[ref.body]->mesh.boundaries.at(ref.boundary)).size();
  };
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const auto& placed = problem.contacts[c];
    const auto& contact = state.solution.contacts[c];
    if (placed.secondary.body == body) add(placed.secondary, contact.pending_secondary.begin(), size(placed.secondary));
    auto first = contact.pending_primary.begin();
    for (const auto& ref : placed.primary) {
      const auto count = size(ref);
      if (ref.body == body) add(ref, first, count);
      first += static_cast<std::ptrdiff_t>(count);
    }
  }
  std::vector<adapt::WornBoundary> worn;
  for (auto& [name, removed] : sums) worn.push_back({name, std::move(removed)});
  return worn;
}

/// What waited in the gap is now gone from the body: books the strip, share by share.
void book_strips(const Problem& problem, State& state, const std::vector<double>& ratio) {
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const auto& placed = problem.contacts[c];
    auto& contact = state.solution.contacts[c];
    for (double& v : contact.pending_secondary) {
      contact.strip_secondary += v * ratio[placed.secondary.body];
      v = 0.0;
    }
    std::size_t l = 0;
    for (const auto& ref : placed.primary)
      for (std::size_t k = mesh::nodes_of(state.shapes[ref.body]->mesh.boundaries.at(ref.boundary)).size(); k > 0; --k, ++l) {
        contact.strip_primary += contact.pending_primary[l] * ratio[ref.body];
        contact.pending_primary[l] = 0.0;
      }
  }
}

/// Tractions of the secondary nodes before the shape moves, as forces: times A_j.
struct HeldTraction {
  std::vector<double> normal, tangential;
};

std::vector<HeldTraction> held_tractions(const solver::System& system, const State& state) {
  std::vector<HeldTraction> tractions;
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    const auto& contact = state.solution.contacts[c];
    contact::Interface face;
    auto sides = solver::positions(system, setup, state.solution.q);
    face.begin(setup, contact, sides.secondary, sides.primary, {});
    face.integrate(sides.secondary, sides.primary);
    auto& held = tractions.emplace_back();
    for (int j = 0; j < setup.secondary_count(); ++j) {
      const Vec2 n = face.normal()[j], force = contact.lambda[j] * setup.secondary.area[j];
      held.normal.push_back(force.dot(n));
      held.tangential.push_back(-n.y() * force.x() + n.x() * force.y());
    }
  }
  return tractions;
}

/// The shear as given load; the node of largest pressure is offered as anchor.
void hold_shear(const contact::Setup& setup, const contact::ContactState& contact, const HeldTraction& held,
                contact::IncrementOptions& o) {
  for (std::size_t j = 0; j < held.normal.size(); ++j) {
    o.held_shear.push_back(held.tangential[j] / setup.secondary.area[j]);
    o.held_pressure.push_back(held.normal[j] / setup.secondary.area[j]);
    const bool active = contact.status[j] != contact::ContactStatus::inactive;
    if (active && (o.anchor < 0 || o.held_pressure[j] > o.held_pressure[o.anchor])) o.anchor = static_cast<int>(j);
  }
}

/// True when a body of the contact is free to move along it but for friction.
bool driven_only_by_friction(const Problem& problem, const solver::System& system, int contact) {
  const auto& s = system.contacts[contact].secondary;
  const auto [a, b] = s.facets[s.facets.size() / 2];
  const Vec2 along = (s.X[b] - s.X[a]).normalized();
  const auto& placed = problem.contacts[contact];
  if (placed.options.friction == 0.0 || placed.options.imposed) return false;
  bool free = !held_along(problem, system, placed.secondary.body, along);
  for (const auto& ref : placed.primary) free = free || !held_along(problem, system, ref.body, along);
  return free;
}

/// Equilibrium on the moved shape with the shear as given load, its nodal resultant kept.
std::string re_equilibrate(const Problem& problem, State& state, Cache& cache, const BlockSpan& span,
                           const std::vector<HeldTraction>& held) {
  const auto& system = timed_system(problem, state, cache);
  auto controls = controls_at(problem, system, state.factors, *span.step, 1.0, 1.0, 1.0);
  std::vector<std::vector<contact::ContactStatus>> status;
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    auto& o = controls.contacts[c];
    o.held = true;
    o.wear = false;
    hold_shear(system.contacts[c], state.solution.contacts[c], held[c], o);
    if (!driven_only_by_friction(problem, system, static_cast<int>(c))) o.anchor = -1;
    status.push_back(state.solution.contacts[c].status);
  }
  Timer timer(cache, "solver");
  auto result = cache.newton.solve(system, state.solution, controls);
  state.counts.newton_iterations += result.report.solves;
  if (!result.report.converged) return "re-equilibration after the shape moved: " + result.report.reason;
  state.solution = std::move(result.state);
  for (std::size_t c = 0; c < status.size(); ++c)
    for (std::size_t j = 0; j < status[c].size(); ++j)
      if (auto& s = state.solution.contacts[c].status[j];
          s != contact::ContactStatus::inactive && status[c][j] != contact::ContactStatus::inactive)
        s = status[c][j];
  return {};
}

}  // namespace

void begin_state(const Problem& problem, State& state, Cache& cache) {
  const auto& system = timed_system(problem, state, cache);
  state.solution.q = Vector::Zero(system.dofs);
  state.solution.contacts.clear();
  for (const auto& setup : system.contacts) state.solution.contacts.push_back(contact::fresh_state(setup));
  approach(problem, state, system);
  state.approached = true;
  for (char rigid : problem.rigid) state.counts.factorisations += rigid ? 0 : 1;
}

Outcome play_increments(const Problem& problem, State state, Cache& cache, const BlockSpan& span, const Observer& observer) {
  Playing block{span, observer, state.factors};
  cache.newton.reset();
  const auto ends = increment_ends(problem.scene, *span.step);
  double from = 0.0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const std::string failure = play(problem, state, cache, block, from, ends[i], problem.scene.max_cutbacks);
    if (!failure.empty()) return {std::move(state), failure, false};
    from = ends[i];
    tell_progress(observer, state, cache.system, span, static_cast<int>(i) + 1, static_cast<int>(ends.size()), from);
    if (problem.scene.output.frames_every_increment && observer.frame && i + 1 < ends.size()) {
      State shown = state;
      shown.cycle += span.cycles ? span.jump * from : 0.0;
      observer.frame(make_frame(problem, shown, cache, span.step->name));
    }
    if (observer.interrupted && observer.interrupted()) {
      if (span.cycles) state.cycle += span.jump * from;
      return {std::move(state), {}, true};
    }
  }
  if (span.cycles) state.cycle += span.jump;
  return {std::move(state), {}, false};
}

Outcome evolve_shape(const Problem& problem, State state, Cache& cache, const BlockSpan& span) {
  const auto& system = timed_system(problem, state, cache);
  const auto held = held_tractions(system, state);
  std::vector<double> ratio(state.shapes.size(), 1.0);
  auto shapes = state.shapes;
  {
    Timer timer(cache, "adapt");
    for (int b = 0; b < problem.body_count(); ++b) {
      double total = 0.0;
      const auto worn = worn_boundaries(problem, state, b, total);
      if (total <= 0.0) continue;
      auto moved = adapt::evolve(state.shapes[b], problem.scene.analysis, worn, {}, &cache.relocation);
      if (!moved.failure.empty()) return {std::move(state), "body " + problem.inputs[b].name + ": " + moved.failure, false};
      ratio[b] = moved.removed / total;
      shapes[b] = std::move(moved.shape);
      ++state.counts.factorisations;
    }
  }
  if (shapes == state.shapes) return {std::move(state), {}, false};
  State next = state;
  next.shapes = std::move(shapes);
  book_strips(problem, next, ratio);
  const std::string failure = re_equilibrate(problem, next, cache, span, held);
  if (!failure.empty()) return {std::move(state), failure, false};
  return {std::move(next), {}, false};
}

Frame make_frame(const Problem& problem, const State& state, Cache& cache, const std::string& step) {
  const auto& system = timed_system(problem, state, cache);
  Timer timer(cache, "frames");
  Frame frame;
  frame.cycle = state.cycle;
  frame.step = step;
  const scene::Step none;
  const auto controls = controls_at(problem, system, state.factors, none, 0.0, 0.0, 1.0);
  for (int b = 0; b < problem.body_count(); ++b) {
    BodyFrame body;
    body.name = problem.inputs[b].name;
    body.mesh = std::shared_ptr<const mesh::Mesh>(state.shapes[b], &state.shapes[b]->mesh);
    const Vector q = system.part(state.solution.q, b);
    body.u = std::visit([&](const auto& o) { return o.recover(q, controls.load_factors[b]); }, system.bodies[b]);
    if (!problem.rigid[b])
      body.stress_MPa = fem::nodal_stress(*body.mesh, problem.inputs[b].material, problem.scene.analysis, problem.inputs[b].b_bar, body.u);
    body.wear_depth_mm.assign(body.u.size(), 0.0);
    frame.bodies.push_back(std::move(body));
  }
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    const auto& contact = state.solution.contacts[c];
    for (auto& surface : surface_records(setup, contact, state.shapes, problem.contacts[c])) frame.surfaces.push_back(std::move(surface));
    const auto paint = [&](const std::vector<contact::SurfaceNode>& nodes, const std::vector<double>& depth) {
      for (std::size_t k = 0; k < nodes.size(); ++k) {
        double& shown = frame.bodies[nodes[k].body].wear_depth_mm[nodes[k].mesh_node];
        shown = std::max(shown, depth[k]);
      }
    };
    paint(setup.secondary_nodes, depths(setup.secondary, contact.removed_secondary));
    paint(setup.primary_nodes, depths(setup.primary, contact.removed_primary));
  }
  return frame;
}

}  // namespace reye::sim
