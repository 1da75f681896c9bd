#include "sim/reshape/approach.hpp"

#include <algorithm>
#include <cmath>

#include "sim/measure/sides.hpp"

namespace reye::sim {

namespace {

using body::Drive;

/// Moves the contact nodes and the supports of a body by d, in its q.
void translate(const auto& body, const Vec2& d, Vector& t) {
  const Vector zero = Vector::Zero(t.size());
  for (std::size_t k = 0; k < body.contact_nodes().size(); ++k) {
    const body::ContactIndex node{static_cast<int>(k)};
    const auto p = body.position(node, zero);
    for (int i = p.count - body.freedom(node).free; i < p.count; ++i)
      t[p.terms[i].column] = p.terms[i].direction.dot(d);
  }
  for (const auto& column : body.support_columns()) t[column.column] = column.direction.dot(d);
}

/// q-space image of a unit translation of body b along d.
Vector translation(const Problem& problem, const solver::System& system, int b, const Vec2& d) {
  const auto& op = system.bodies[b];
  Vector t = Vector::Zero(body::dofs(op));
  if (problem.rigid[b])
    t.head<2>() = d;
  else
    std::visit([&](const auto& o) { translate(o, d, t); }, op);
  return t;
}

/// The equations of a nonlinear body before anything has moved.
body::NonlinearBody::Linearised at_start(const body::NonlinearBody& body, const Vector& load_factors) {
  body::NonlinearBody::Linearised out;
  const auto start = body.start();
  body.linearise(start, start.y, Vector::Zero(body.dofs()), load_factors, out);
  return out;
}

/// The largest factor of a history in a step, in size; where the step does not play it, its factor at the start.
double peak_factor(const Problem& problem, const scene::Step& step, const std::string& history) {
  if (history.empty()) return 1.0;
  const auto& corners = problem.scene.histories.at(history);
  double peak = corners.front()[1];
  if (std::find(step.play.begin(), step.play.end(), history) == step.play.end()) return peak;
  for (const auto& corner : corners)
    if (std::abs(corner[1]) > std::abs(peak)) peak = corner[1];
  return step.level * peak;
}

const body::Motion& motion_of(const Problem& problem, int b, const body::SupportColumn& column) {
  return body::motion_of(problem.inputs[b].supports[column.support], column.motion);
}

/// The residual of a body before anything has moved, with its loads at their peaks in a step.
Vector residual_at_rest(const Problem& problem, const scene::Step& step, const body::Operator& op) {
  const auto& loads = body::loads(op);
  Vector factors(static_cast<Eigen::Index>(loads.size()));
  for (std::size_t i = 0; i < loads.size(); ++i)
    factors[static_cast<Eigen::Index>(i)] = peak_factor(problem, step, loads[i].history);
  const Vector zero = Vector::Zero(body::dofs(op));
  const auto at_rest = [&](const auto& o) -> Vector {
    if constexpr (std::is_same_v<std::decay_t<decltype(o)>, body::NonlinearBody>)
      return at_start(o, factors).r;
    else
      return o.residual(zero, factors);
  };
  return std::visit(at_rest, op);
}

/// Force that drives body b along d: loaded support motions and loads at their peaks in a step.
double driving_force(const Problem& problem, const scene::Step& step, const solver::System& system, int b,
                     const Vec2& d) {
  double force = 0.0;
  const auto& op = system.bodies[b];
  for (const auto& column : body::support_columns(op))
    if (const auto& m = motion_of(problem, b, column); m.drive == Drive::loaded)
      for (const auto& part : m.parts)
        force += column.direction.dot(d) * part.value * peak_factor(problem, step, part.history);
  return force - residual_at_rest(problem, step, op).dot(translation(problem, system, b, d));
}

/// The change of the interior of a nonlinear body with t in its q, without load; empty for other bodies.
Vector interior_of(const body::Operator& op, const Vector& t) {
  const auto* body = std::get_if<body::NonlinearBody>(&op);
  if (!body) return {};
  const Vector unloaded = Vector::Zero(static_cast<Eigen::Index>(body->loads().size()));
  return body->interior_step(at_start(*body, unloaded), t);
}

/// Shortens the way along d to that after which the first covered secondary node of a contact meets.
void shorten_to_meeting(const contact::Setup& setup, const contact::Interface& face, const Vec2& d,
                        std::optional<double>& way) {
  for (int j = 0; j < setup.secondary_count(); ++j) {
    if (face.rows()[j].D < 0.5 * setup.secondary.area[j] || setup.cut[j]) continue;
    const double closing = face.normal()[j].dot(d);
    if (closing < 0.2) continue;
    const double distance = face.gap()[j] / face.rows()[j].D / closing;
    if (!way || distance < *way) way = distance;
  }
}

/// Distance that body b can move along d until the first covered secondary node of its contacts meets.
std::optional<double> free_way(const Problem& problem, const solver::System& system, const State& state, int b,
                               const Vec2& d) {
  std::optional<double> way;
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    if (!lies_on(problem.contacts[c], b)) continue;
    contact::Interface face;
    auto sides = solver::positions(system, setup, state.solution.q.high);
    face.begin(setup, state.solution.contacts[c], sides.secondary, sides.primary, {});
    face.integrate(sides.secondary, sides.primary);
    shorten_to_meeting(setup, face, problem.contacts[c].secondary.body == b ? d : Vec2(-d), way);
  }
  return way;
}

}  // namespace

bool held_along(const Problem& problem, const solver::System& system, int b, const Vec2& d) {
  for (const auto& column : body::support_columns(system.bodies[b])) {
    if (std::abs(column.direction.dot(d)) > 1e-6 && holds(motion_of(problem, b, column))) return true;
  }
  return false;
}

namespace {

/// Moves body b along d until its first node meets. The facet that is met changes on the way: repeated until no gap is
/// left.
void close_gap(const Problem& problem, State& state, const solver::System& system, int b, const Vec2& d) {
  const Vector t = translation(problem, system, b, d), inside = interior_of(system.bodies[b], t);
  for (int round = 0; round < 50; ++round) {
    const auto way = free_way(problem, system, state, b, d);
    if (!way || (round == 0 && *way <= 0.0)) break;
    state.solution.q.high.segment(system.offset[b], t.size()) += *way * t;
    if (inside.size() > 0) state.solution.interiors[b].y += *way * inside;
    if (std::abs(*way) < 1e-14) break;
  }
}

}  // namespace

void approach(const Problem& problem, State& state, const solver::System& system) {
  for (int b = 0; b < problem.body_count(); ++b)
    for (const auto& step : problem.scene.steps) {
      bool driven = false;
      for (const Vec2& axis : {Vec2(1.0, 0.0), Vec2(0.0, 1.0)}) {
        if (held_along(problem, system, b, axis)) continue;
        const double force = driving_force(problem, step, system, b, axis);
        if (force == 0.0) continue;
        close_gap(problem, state, system, b, force > 0.0 ? axis : Vec2(-axis));
        driven = true;
      }
      if (driven) break;  // loads of a later step do not matter where this one presses
    }
}

}  // namespace reye::sim
