#include "solver/increment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reye::solver {

using contact::ContactStatus;

namespace {

constexpr Reach::Margin reach_margin{.nodes = 6, .active_per_node = 16};
constexpr double worth_narrowing = 0.9;  ///< of the nodes in reach; condensing costs a fifth of a matrix
constexpr double tiny = std::numeric_limits<double>::min();
constexpr double digits = 64.0 * std::numeric_limits<double>::epsilon();  ///< relative, of what is summed up from many terms

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

void Increment::forget() {
  reach_chosen_ = false;
  last_step_.resize(0);
  nonlinear_.forget();
}

void Increment::remember(const SolverState& before, const SolverState& accepted) {
  last_step_ = accepted.q - before.q;
  nonlinear_.remember(accepted);
}

void Increment::choose_reach(const System& system, const SolverState& before, bool everything, bool limited) {
  if (reach_chosen_ && !everything) return;
  limited_ = limited;
  reach_ = everything || !limited ? Reach::all(system) : Reach::round_contact(system, before.contacts, reach_margin);
  reduction_ = Reduction(system, reach_);
  window_.forget();
  // Before anything touches, or where contact outran its reach, the next increment chooses anew.
  reach_chosen_ = !(reach_ == Reach::all(system)) || !limited;
}

base::TwoPart Increment::begin(const System& system, const SolverState& before, const Controls& controls, double continues) {
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
    lambda_[c] = before.contacts[c].lambda;
  }
  look_at_reach(system, controls);
  suspects_ = {};
  nonlinear_.begin(system, before, controls, reduction_, continues);
  base::TwoPart q{reduction_.restrict_to(before.q), reduction_.restrict_to(before.q_low)};
  if (continues > 0.0) advance(q, continues * reduction_.restrict_to(last_step_));
  // A nonlinear body is led to what is imposed by its tangent, not torn there.
  for (const auto& [column, value] : controls.prescribed)
    if (!nonlinear_.own(column)) {
      q.high[reduction_.index(column)] = value;
      q.low[reduction_.index(column)] = 0.0;
    }
  nonlinear_.linearise(q.high, lambda_);
  return q;
}

/// What is kept of contacts, loads and arms is of the columns in reach.
void Increment::look_at_reach(const System& system, const Controls& controls) {
  for (std::size_t c = 0; c < interfaces_.size(); ++c) interfaces_[c].limit_to(reach_.secondary[c], reach_.primary[c]);
  arm_ = reduction_.restrict_to(system.arm);
  loads_ = reduction_.loads(system, controls.load_factors);
  for (const auto& [column, force] : controls.forces) loads_[reduction_.index(column)] += force;
}

void Increment::change_reach(const System& system, const Controls& controls, Reach reach, base::TwoPart& q) {
  const auto all = reduction_.expand(q);
  reach_ = std::move(reach);
  reduction_ = Reduction(system, reach_);
  window_.forget();
  look_at_reach(system, controls);
  q = {reduction_.restrict_to(all.high), reduction_.restrict_to(all.low)};
}

bool Increment::narrow(const System& system, const Controls& controls, base::TwoPart& q) {
  if (nonlinear() || reach_chosen_) return false;
  Reach reach = Reach::round_contact(system, interfaces_, reach_margin);
  if (reach.nodes() > worth_narrowing * reach_.nodes()) return false;
  change_reach(system, controls, std::move(reach), q);
  return true;
}

bool Increment::enclosed_by(const Reach& reach) const {
  for (std::size_t c = 0; c < interfaces_.size(); ++c)
    if (!reach.encloses(static_cast<int>(c), interfaces_[c])) return false;
  return true;
}

bool Increment::follow(const System& system, const Controls& controls, base::TwoPart& q) {
  if (nonlinear()) return false;
  Reach reach = Reach::round_contact(system, interfaces_, reach_margin);
  if (!enclosed_by(reach)) reach = Reach::all(system);
  reach_chosen_ = !(reach == Reach::all(system));
  change_reach(system, controls, std::move(reach), q);
  return true;
}

void Increment::widen(const System& system, const Controls& controls, base::TwoPart& q) {
  change_reach(system, controls, Reach::all(system), q);
}

/// Moves the surface nodes in reach (or all) to where the full vector q puts them, and integrates.
void Increment::integrate(const System& system, const Vector& q, bool everything) {
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
const Matrix& Increment::stiffness(std::size_t body) const {
  const auto* tangent = nonlinear_.tangent(static_cast<int>(body));
  return tangent ? *tangent : reduction_.stiffness(static_cast<int>(body));
}

/// S' v - f' of all bodies on the reduced columns, v the deformation; of nonlinear ones r + S (q - q_anchor).
Vector Increment::residual(const System& system, const Controls& controls, const base::TwoPart& q) const {
  Vector r = -loads_;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const int at = reduction_.first(static_cast<int>(b));
    if (const auto* rigid = std::get_if<body::RigidBody>(&system.bodies[b])) {
      const Vector part = q.high.segment(at, rigid->dofs());
      r.segment(at, part.size()) += rigid->residual(part, controls.load_factors[b]);
    } else if (nonlinear_.tangent(static_cast<int>(b))) {
      nonlinear_.add_residual(static_cast<int>(b), q.high, r);
    } else {
      const Matrix& S = reduction_.stiffness(static_cast<int>(b));
      r.segment(at, S.rows()).noalias() += S * reduction_.deformation(static_cast<int>(b), q);
    }
  }
  return r;
}

/// Of a linear body S v is rounded, not S q: rigid motion leaves nothing. The stress of a nonlinear one is that of F(q).
Increment::Rounding Increment::rounding(const System& system, const base::TwoPart& q) const {
  Rounding result;
  const double way = largest_of(q.high.cwiseProduct(arm_));
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const int body = static_cast<int>(b);
    const Matrix& S = this->stiffness(b);
    if (S.size() == 0) continue;
    const auto arm = arm_.segment(reduction_.first(body), S.rows());
    const double stiffness = S.diagonal().cwiseQuotient(arm.cwiseAbs2()).maxCoeff();
    const double lost = nonlinear_.tangent(body)
                            ? 1e-13 * way
                            : digits * largest_of(reduction_.deformation(body, q).cwiseProduct(arm));
    result.inside = std::max(result.inside, stiffness * lost);
    result.scale = std::max(result.scale, digits * stiffness * way);
  }
  return result;
}

/// Balance and conditions at (q, lambda); balance_ keeps the unbalanced forces.
Iteration Increment::measure(const System& system, const Controls& controls, const base::TwoPart& q, bool fresh) {
  Iteration row;
  balance_ = residual(system, controls, q);
  double largest = largest_of(balance_.cwiseQuotient(arm_)), multiplier = 0.0, unmet = 0.0;
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
      const double rounding = digits * nodes_[c][j].position.x.norm() * D;
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
  const Rounding rounding = this->rounding(system, q);
  largest = std::max({largest, nonlinear_.force_scale(), rounding.scale});
  const double inside = fresh ? nonlinear_.inside_imbalance() : 0.0;
  Eigen::Index column = -1;
  const double outside = balance_.size() ? balance_.cwiseQuotient(arm_).cwiseAbs().maxCoeff(&column) : 0.0;
  suspects_.unbalanced = inside > outside ? -1 : static_cast<int>(column);
  row.force = std::max(0.0, std::max(outside, inside) - rounding.inside) / std::max(largest, tiny);
  // Nodes that have just closed carry no multiplier yet: an overlap without one is unmet, not infinite.
  row.condition = unmet == 0.0 ? 0.0 : unmet / std::max(multiplier, 1e-6 * unmet);
  return row;
}

int Increment::decide(int iteration, bool predicted, Allowed allowed) {
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

ActiveSetWatch::Set Increment::active_set() const {
  ActiveSetWatch::Set set;
  for (const auto& face : interfaces_) set.insert(set.end(), face.status().begin(), face.status().end());
  return set;
}

bool Increment::touching() const {
  return std::any_of(interfaces_.begin(), interfaces_.end(), [](const auto& face) {
    return std::any_of(face.status().begin(), face.status().end(), [](auto s) { return s != ContactStatus::inactive; });
  });
}

bool Increment::accept(const System& system, const base::TwoPart& q, SolverState& state) {
  auto expanded = reduction_.expand(q);
  state.q = std::move(expanded.high);
  state.q_low = std::move(expanded.low);
  integrate(system, state.q, true);
  if (!enclosed_by(reach_)) return false;
  state.contacts.clear();
  for (std::size_t c = 0; c < interfaces_.size(); ++c) {
    interfaces_[c].evaluate(lambda_[c]);
    state.contacts.push_back(interfaces_[c].accepted(lambda_[c]));
  }
  state.interiors = nonlinear_.accepted(state.q);
  return true;
}

Vector Increment::step(const System& system, const Controls& controls, const base::TwoPart& q, bool chord) {
  if (!chord) {
    const auto& derivatives = condenser_.linearise(interfaces_, lambda_);
    window_.choose(system, reduction_, limited_ ? Reach::of_derivatives(interfaces_, derivatives) : Reach::all(system));
  }
  const Vector rhs = window_.load(-balance_);
  auto nodes = nodes_;
  for (auto& of_contact : nodes)
    for (auto& node : of_contact)
      for (int t = 0; t < node.position.count; ++t) node.column[t] = node.column[t] < 0 ? -1 : window_.index(node.column[t]);
  if (chord) {
    condenser_.again(rhs);
  } else {
    condenser_.start(system, rhs);
    for (std::size_t b = 0; b < system.bodies.size(); ++b) {
      const int body = static_cast<int>(b), at = reduction_.first(body);
      if (const auto* rigid = std::get_if<body::RigidBody>(&system.bodies[b]))
        condenser_.add_body(window_.first(body), rigid->tangent(q.high.segment(at, rigid->dofs()), controls.load_factors[b]));
      else
        condenser_.add_body(window_.first(body), nonlinear_.tangent(body) ? *nonlinear_.tangent(body) : window_.stiffness(body));
    }
    for (std::size_t c = 0; c < interfaces_.size(); ++c)
      condenser_.add_contact(system, static_cast<int>(c), interfaces_[c], nodes[c], lambda_[c], reduction_, window_, q.high);
  }
  for (int c : system.elimination) condenser_.eliminate(c, interfaces_[c], nodes[c]);
  for (const auto& [column, value] : controls.prescribed) {
    const int at = reduction_.index(column);
    condenser_.fix(window_.index(at), value - q.high[at] - q.low[at]);
  }
  const Vector dq = condenser_.solve();
  for (std::size_t c = 0; c < interfaces_.size(); ++c) condenser_.advance(static_cast<int>(c), dq, lambda_[c]);
  return window_.expand(dq);
}

void Increment::advance(base::TwoPart& q, const Vector& dq) const {
  q += dq;
  nonlinear_.round(q);
}

double Increment::way(const Vector& dq) const { return largest_of(dq.cwiseProduct(arm_)); }

std::string Increment::renew(base::TwoPart& q) { return nonlinear_.renew(q, lambda_); }

std::string Increment::not_found(const System& system, const std::vector<Iteration>& table, const NewtonOptions& options,
                                 bool circles) const {
  Suspects suspects = suspects_;
  suspects.circles = circles;
  if (suspects.unbalanced < 0) suspects.inside = nonlinear_.least_balanced();
  return no_convergence(system, nodes_, suspects, table, options);
}

}  // namespace reye::solver
