#include "solver/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.hpp"

namespace reye::solver {

using contact::ContactStatus;

namespace {

constexpr int reach_margin = 6;  ///< nodes beyond the contact that are kept
constexpr double tiny = std::numeric_limits<double>::min();
constexpr int most_on_one_tangent = 15;  ///< iterations of contact before nonlinear bodies are linearised anew

double largest_of(const Vector& v) { return v.size() ? v.lpNorm<Eigen::Infinity>() : 0.0; }

/// Nodes just out of reach go along with their neighbour in reach. Left behind, a slide of more than a facet in one
/// increment would turn the facet at the rim round, and with it the averaged normal beside it.
void carry_rim(const mortar::Surface& surface, const std::vector<char>& near, const std::vector<Vec2>& before,
               std::vector<Vec2>& x) {
  for (const auto& facet : surface.facets)
    for (int in : facet)
      for (int out : facet)
        if (in >= 0 && out >= 0 && near[in] && !near[out]) x[out] = before[out] + x[in] - before[in];
}

}  // namespace

void Newton::reset() {
  reach_chosen_ = false;
  last_step_.resize(0);
  nonlinear_.forget();
}

void Newton::choose_reach(const System& system, const SolverState& before, bool everything) {
  if (reach_chosen_ && !everything) return;
  reach_ = everything || !options_.limit_reach ? Reach::all(system) : Reach::round_contact(system, before.contacts, reach_margin);
  reduction_ = Reduction(system, reach_);
  // Before anything touches, or where contact outran its reach, the next increment chooses anew.
  reach_chosen_ = !(reach_ == Reach::all(system)) || !options_.limit_reach;
}

void Newton::begin(const System& system, const SolverState& before, const Controls& controls) {
  const auto n = system.contacts.size();
  interfaces_.resize(n);
  nodes_.resize(n);
  lambda_.resize(n);
  sides_.resize(n);
  start_.resize(n);
  for (std::size_t c = 0; c < n; ++c) {
    const auto& setup = system.contacts[c];
    start_[c] = sides_[c] = positions(system, setup, before.q);
    interfaces_[c].begin(setup, before.contacts[c], sides_[c].secondary, sides_[c].primary, controls.contacts[c]);
    interfaces_[c].limit_to(reach_.secondary[c], reach_.primary[c]);
    lambda_[c] = before.contacts[c].lambda;
  }
  arm_ = reduction_.restrict_to(system.arm);
  loads_ = reduction_.loads(system, controls.load_factors);
  for (const auto& [column, force] : controls.forces) loads_[reduction_.index(column)] += force;
}

/// Moves the surface nodes in reach (or all) to where the full vector q puts them, and integrates.
void Newton::place(const System& system, const Vector& q, bool everything) {
  std::vector<Vector> parts;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) parts.emplace_back(system.part(q, static_cast<int>(b)));
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    auto& nodes = nodes_[c];
    nodes.assign(setup.secondary_nodes.size() + setup.primary_nodes.size(), {});
    const auto put = [&](const contact::SurfaceNode& node, char near, PlacedNode& placed, Vec2& x) {
      if (!near && !everything) return;
      std::visit([&](const auto& b) {
        placed.position = b.position(node.contact_node, parts[node.body]);
        placed.free = b.freedom(node.contact_node).free;
      }, system.bodies[node.body]);
      for (int t = 0; t < placed.position.count; ++t)
        placed.column[t] = reduction_.index(system.offset[node.body] + placed.position.terms[t].column);
      x = placed.position.x;
    };
    const auto ns = setup.secondary_nodes.size();
    for (std::size_t j = 0; j < ns; ++j) put(setup.secondary_nodes[j], reach_.secondary[c][j], nodes[j], sides_[c].secondary[j]);
    for (std::size_t l = 0; l < setup.primary_nodes.size(); ++l)
      put(setup.primary_nodes[l], reach_.primary[c][l], nodes[ns + l], sides_[c].primary[l]);
    if (everything) {
      interfaces_[c].limit_to({}, {});
    } else {
      carry_rim(setup.secondary, reach_.secondary[c], start_[c].secondary, sides_[c].secondary);
      carry_rim(setup.primary, reach_.primary[c], start_[c].primary, sides_[c].primary);
    }
    interfaces_[c].integrate(sides_[c].secondary, sides_[c].primary);
  }
}

/// Tangent of a deformable body on its reduced columns; empty for a rigid one.
const Matrix& Newton::stiffness(std::size_t body) const {
  const auto* tangent = nonlinear_.tangent(static_cast<int>(body));
  return tangent ? *tangent : reduction_.stiffness(static_cast<int>(body));
}

/// S' q - f' of all bodies on the reduced columns; of nonlinear ones r + S (q - q_anchor).
Vector Newton::residual(const System& system, const Controls& controls, const Vector& q) const {
  Vector r = -loads_;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const int at = reduction_.first(static_cast<int>(b));
    if (const auto* rigid = std::get_if<body::RigidBody>(&system.bodies[b])) {
      const Vector part = q.segment(at, rigid->dofs());
      r.segment(at, part.size()) += rigid->residual(part, controls.load_factors[b]);
    } else if (nonlinear_.tangent(static_cast<int>(b))) {
      nonlinear_.add_residual(static_cast<int>(b), q, r);
    } else {
      const Matrix& S = reduction_.stiffness(static_cast<int>(b));
      r.segment(at, S.rows()).noalias() += S * q.segment(at, S.rows());
    }
  }
  return r;
}

/// Balance and conditions at (q, lambda); balance_ keeps the unbalanced forces.
Iteration Newton::measure(const System& system, const Controls& controls, const Vector& q, bool fresh) {
  Iteration row;
  balance_ = residual(system, controls, q);
  double largest = largest_of(balance_.cwiseQuotient(arm_)), multiplier = 0.0, unmet = 0.0, stiffness = 0.0;
  suspects_.unmet = {};
  for (std::size_t c = 0; c < interfaces_.size(); ++c) {
    auto& face = interfaces_[c];
    face.evaluate(lambda_[c]);
    const Vector f = face.forces(lambda_[c]);
    largest = std::max(largest, largest_of(f));
    for (std::size_t k = 0; k < nodes_[c].size(); ++k)
      for (int t = 0; t < nodes_[c][k].position.count; ++t)
        balance_[nodes_[c][k].column[t]] += nodes_[c][k].position.terms[t].direction.dot(f.segment<2>(2 * static_cast<int>(k)));
    for (std::size_t j = 0; j < lambda_[c].size(); ++j) {
      const int node = static_cast<int>(j);
      if (!face.active(node)) continue;
      multiplier = std::max(multiplier, lambda_[c][j].norm());
      const double D = face.rows()[j].D, traction = face.setup().stiffness[j] / D;
      // What rounding of positions leaves of a gap can not be asked to vanish.
      const double rounding = 64.0 * std::numeric_limits<double>::epsilon() * nodes_[c][j].position.x.norm() * D;
      const auto overlap = [&](double r) { return traction * std::max(0.0, std::abs(r) - rounding); };
      const auto count = [&](double r) {
        if (r > unmet) suspects_.unmet = {static_cast<int>(c), node};
        unmet = std::max(unmet, r);
      };
      count(overlap(face.residual_normal(node)));
      if (nodes_[c][j].free < 2) continue;
      const double r = face.residual_tangential(node);
      count(face.status()[j] == ContactStatus::slip || face.held() ? std::abs(r) : overlap(r));
    }
  }
  for (const auto& [column, value] : controls.prescribed) balance_[reduction_.index(column)] = 0.0;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const Matrix& S = this->stiffness(b);
    const auto arm = arm_.segment(reduction_.first(static_cast<int>(b)), S.rows());
    if (S.size() > 0) stiffness = std::max(stiffness, S.diagonal().cwiseQuotient(arm.cwiseAbs2()).maxCoeff());
  }
  largest = std::max(largest, nonlinear_.force_scale());
  const double inside = fresh ? nonlinear_.inside_imbalance() : 0.0;
  const double rounding = 1e-13 * stiffness * largest_of(q.cwiseProduct(arm_));  // of S q under rigid motion: no force
  Eigen::Index column = -1;
  const double outside = balance_.size() ? balance_.cwiseQuotient(arm_).cwiseAbs().maxCoeff(&column) : 0.0;
  suspects_.unbalanced = inside > outside ? -1 : static_cast<int>(column);
  row.force = std::max(0.0, std::max(outside, inside) - rounding) / std::max(largest, tiny);
  // Nodes that have just closed carry no multiplier yet: an overlap without one is unmet, not infinite.
  row.condition = unmet == 0.0 ? 0.0 : unmet / std::max(multiplier, 1e-6 * unmet);
  return row;
}

/// Number of nodes that ask for another status; those that are allowed to get it.
int Newton::decide(int iteration, bool predicted, Allowed allowed) {
  int changes = 0;
  for (std::size_t c = 0; c < interfaces_.size(); ++c) {
    const auto last = interfaces_[c].status();
    interfaces_[c].decide(lambda_[c], iteration, predicted);
    for (std::size_t j = 0; j < last.size(); ++j) {
      const int node = static_cast<int>(j);
      const bool asks = last[j] != interfaces_[c].status()[j];
      if (asks && (allowed == Allowed::none || (allowed == Allowed::one && changes > 0))) interfaces_[c].keep(node);
      if (asks && changes++ == 0) suspects_.asking = {static_cast<int>(c), node};
      if (!interfaces_[c].active(node)) lambda_[c][j].setZero();
    }
  }
  return changes;
}

ActiveSetWatch::Set Newton::active_set() const {
  ActiveSetWatch::Set set;
  for (const auto& face : interfaces_) set.insert(set.end(), face.status().begin(), face.status().end());
  return set;
}

/// Whether a node of some contact is active.
bool Newton::touching() const {
  return std::any_of(interfaces_.begin(), interfaces_.end(), [](const auto& face) {
    return std::any_of(face.status().begin(), face.status().end(), [](auto s) { return s != ContactStatus::inactive; });
  });
}

/// Solves back what was out of reach, looks whether contact stayed inside, and takes the state over.
Newton::Fit Newton::accept(const System& system, const Vector& q, SolveResult& result) {
  result.state.q = reduction_.expand(q);
  place(system, result.state.q, true);
  result.state.contacts.clear();
  for (std::size_t c = 0; c < interfaces_.size(); ++c) {
    if (!reach_.encloses(static_cast<int>(c), interfaces_[c])) return Fit::too_narrow;
    interfaces_[c].evaluate(lambda_[c]);
    result.state.contacts.push_back(interfaces_[c].accepted(lambda_[c]));
  }
  result.state.interiors = nonlinear_.accepted(result.state.q);
  return Fit::good;
}

/// One semi-smooth Newton step about (q, lambda), or on a `chord`: with the matrix of the last one. Returns dq and takes
/// lambda along. Throws base::SolveError when the matrix is singular.
Vector Newton::step(const System& system, const Controls& controls, const Vector& q, bool chord) {
  if (chord) {
    condenser_.again(-balance_);
  } else {
    condenser_.start(system, -balance_);
    for (std::size_t b = 0; b < system.bodies.size(); ++b) {
      const int at = reduction_.first(static_cast<int>(b));
      if (const auto* rigid = std::get_if<body::RigidBody>(&system.bodies[b]))
        condenser_.add_body(at, rigid->tangent(q.segment(at, rigid->dofs()), controls.load_factors[b]));
      else
        condenser_.add_body(at, stiffness(b));
    }
    for (std::size_t c = 0; c < interfaces_.size(); ++c)
      condenser_.add_contact(system, static_cast<int>(c), interfaces_[c], nodes_[c], lambda_[c], reduction_, q);
  }
  for (int c : system.elimination) condenser_.eliminate(c, interfaces_[c], nodes_[c]);
  for (const auto& [column, value] : controls.prescribed) {
    const int at = reduction_.index(column);
    condenser_.fix(at, value - q[at]);
  }
  const Vector dq = condenser_.solve();
  for (std::size_t c = 0; c < interfaces_.size(); ++c) condenser_.advance(static_cast<int>(c), dq, lambda_[c]);
  return dq;
}

SolveResult Newton::iterate(const System& system, const SolverState& before, const Controls& controls, bool predicted) {
  SolveResult result;
  auto& report = result.report;
  begin(system, before, controls);
  Vector q = reduction_.restrict_to(before.q);
  if (predicted) q += controls.continues * reduction_.restrict_to(last_step_);
  nonlinear_.begin(system, before, controls, reduction_, predicted ? controls.continues : 0.0);
  // A nonlinear body is led to what is imposed by its tangent, not torn there.
  for (const auto& [column, value] : controls.prescribed)
    if (!nonlinear_.own(column)) q[reduction_.index(column)] = value;
  try {
    nonlinear_.linearise(q, lambda_);
  } catch (const base::SolveError& error) {
    report.reason = error.what();
    return result;
  }
  /// Of the tolerances.
  const auto error_of = [&](const Iteration& row) {
    return std::max(row.force / options_.force_tolerance, row.condition / options_.condition_tolerance);
  };
  ActiveSetWatch watch;
  ChordRule rule;
  bool late = false, on_chord = false;
  suspects_ = {};
  int renewals = 0, limit = most_on_one_tangent;
  for (int iteration = 0, since = 0; iteration <= options_.max_iterations; ++iteration, ++since) {
    const bool fresh = !nonlinear_.any() || since == 0;  // what is measured is the truth, not a linear body's
    place(system, reduction_.scatter(q), false);
    const bool one_by_one = watch.cycling();
    const int stage = late ? options_.max_iterations : iteration;
    const int changes = decide(stage, predicted, one_by_one ? Allowed::none : Allowed::all);
    Iteration row = measure(system, controls, q, fresh);
    if (one_by_one && changes > 0 && error_of(row) < 1.0) {
      decide(stage, predicted, Allowed::one);
      row = measure(system, controls, q, fresh);
    }
    row.changes = changes;
    watch.add(active_set());
    suspects_.circles = watch.stuck();
    if (watch.cycling() && !one_by_one) limit = since + most_on_one_tangent;
    if (fresh) report.table.push_back(row);
    if (!std::isfinite(row.force) || !std::isfinite(row.condition)) {
      report.reason = "the residual is not finite after " + std::to_string(iteration) + " iterations";
      return result;
    }
    const double off = error_of(row);
    bool chord = options_.chords && rule.allows(off, changes);
    // Newton's last step falls far below the tolerance; a chord goes on until it has, too.
    bool met = iteration > 0 && changes == 0 && off < (on_chord && chord ? 1e-2 : 1.0);
    // Early decisions leave the wear by neighbours out: a node that it opens would be left pulling. They are asked again.
    if (met && !late && decide(options_.max_iterations, predicted, one_by_one ? Allowed::one : Allowed::all) != 0) {
      met = chord = false;
      late = true;
      measure(system, controls, q, fresh);
    }
    if (met && fresh) {
      report.converged = true;
      if (accept(system, q, result) == Fit::good) return result;
      choose_reach(system, before, true);
      return iterate(system, before, controls, predicted);
    }
    // Contact has settled on the bodies as they were linearised: these anew, there.
    if (nonlinear_.any() && (met || since == limit || watch.stuck())) {
      if (renewals++ == options_.max_iterations) break;
      report.reason = nonlinear_.renew(q, lambda_);
      if (!report.reason.empty()) return result;
      watch = {};
      rule = {};
      limit = most_on_one_tangent;
      iteration = 0;
      since = -1;
      continue;
    }
    if (iteration == options_.max_iterations || suspects_.circles) break;
    try {
      const Vector dq = step(system, controls, q, chord);
      on_chord = chord;
      ++report.solves;
      report.matrices += chord ? 0 : 1;
      q += dq;
      // Far out the rounding of S q hides that nothing is in balance any more.
      const double way = largest_of(dq.cwiseProduct(arm_)), bound = 1e3 * system.extent;
      if (!system.contacts.empty() && !(way < bound)) {
        report.reason = "a body moves by " + std::to_string(way) + " in one iteration: it has lost the contact that holds it";
        return result;
      }
    } catch (const base::SolveError& error) {
      report.reason = error.what();
      if (!touching()) report.reason = "nothing is in contact, and a body has lost the contact that holds it; " + report.reason;
      return result;
    }
  }
  if (suspects_.unbalanced < 0) suspects_.inside = nonlinear_.least_balanced();
  report.reason = no_convergence(system, nodes_, suspects_, report.table, options_);
  return result;
}

SolveResult Newton::solve(const System& system, const SolverState& before, const Controls& controls) {
  choose_reach(system, before, false);
  const bool predicted = controls.continues > 0.0 && last_step_.size() == before.q.size();
  SolveResult result = iterate(system, before, controls, predicted);
  if (predicted && !result.report.converged) {
    const int solves = result.report.solves, matrices = result.report.matrices;
    result = iterate(system, before, controls, false);
    result.report.solves += solves;
    result.report.matrices += matrices;
  }
  if (!result.report.converged) return result;
  last_step_ = result.state.q - before.q;
  nonlinear_.remember(result.state);
  return result;
}

}  // namespace reye::solver
