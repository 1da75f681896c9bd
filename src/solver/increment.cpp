#include "solver/increment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reye::solver {

using contact::ContactStatus;

namespace {

/// Multipliers whose shear points along imposed sliding: its reversal is known, and frictional work |shear x slip| has
/// no slope through which Newton could find it across zero.
std::vector<Vec2> along_sliding(const contact::ContactState& before, double slip) {
  auto lambda = before.lambda;
  for (std::size_t j = 0; j < lambda.size(); ++j) {
    const Vec2 tangent(-before.normal[j].y(), before.normal[j].x());
    const double shear = lambda[j].dot(tangent);
    if (shear * slip < 0.0) lambda[j] -= 2.0 * shear * tangent;
  }
  return lambda;
}

/// Those that an increment starts with.
Multipliers multipliers(const SolverState& before, const Controls& controls, const Guess* guess) {
  if (guess) return guess->lambda;
  Multipliers lambda;
  for (std::size_t c = 0; c < before.contacts.size(); ++c)
    lambda.push_back(along_sliding(before.contacts[c], controls.contacts[c].imposed_slip));
  return lambda;
}

}  // namespace

void Increment::forget() {
  contacts_.forget();
  last_step_.resize(0);
  nonlinear_.forget();
}

void Increment::remember(const SolverState& before, const SolverState& accepted) {
  last_step_ = accepted.q.high - before.q.high;
  followed_ = false;
  nonlinear_.remember(accepted);
}

void Increment::choose_reach(const System& system, const SolverState& before, const Controls& controls, bool everything,
                             bool limited) {
  if (!contacts_.choose(system, before, controls.ahead, everything, limited)) return;
  forget_columns();
  followed_ = false;
}

/// dq that the guess, or else the last increment, lets expect.
Vector Increment::predicted_motion(const Controls& controls) const {
  return controls.guess ? controls.guess->dq : Vector(controls.continues * last_step_);
}

bool Increment::look_ahead(const System& system, const SolverState& before, const Controls& controls) {
  constexpr double facets = 0.5;  // contact that moves less leaves its reach after many increments, if at all
  const Vector dq = predicted_motion(controls);
  const double way = dq.cwiseProduct(system.arm).lpNorm<Eigen::Infinity>();
  if (std::none_of(system.contacts.begin(), system.contacts.end(),
                   [&](const auto& setup) { return way > facets * facet_length(setup); }))
    return false;
  const auto lambda = multipliers(before, controls, controls.guess);
  if (!contacts_.look_ahead(system, before, controls, lambda, before.q.high + dq)) return false;
  forget_columns();
  return true;
}

base::TwoPart Increment::begin(const System& system, const SolverState& before, const Controls& controls,
                               contact::Start from, body::Tangent tangent) {
  const bool predicted = is_predicted(from);
  const Guess* guess = predicted ? controls.guess : nullptr;
  const double continues = predicted && !guess ? controls.continues : 0.0;
  contacts_.begin(system, before, controls, guess);
  lambda_ = multipliers(before, controls, guess);
  take_columns(system, controls);
  suspects_ = {};
  nonlinear_.begin(system, before, controls, reduction(), guess, continues);
  base::TwoPart q{reduction().restrict_to(before.q.high), reduction().restrict_to(before.q.low)};
  if (guess) q += reduction().restrict_to(guess->dq);
  if (continues > 0.0) q += continues * reduction().restrict_to(last_step_);
  // The tangent leads a nonlinear body to its imposed motion, without distorting the elements beside it.
  for (const auto& [column, value] : controls.prescribed)
    if (guess || !nonlinear_.own(column)) {
      q.high[reduction().index(column)] = value;
      q.low[reduction().index(column)] = 0.0;
    }
  nonlinear_.linearise(q, lambda_, tangent);
  window_.tangents_changed();
  return q;
}

/// Arms and loads on the columns in reach.
void Increment::take_columns(const System& system, const Controls& controls) {
  arm_ = reduction().restrict_to(system.arm);
  loads_ = reduction().loads(system, controls.load_factors);
  for (const auto& [column, force] : controls.forces) loads_.forces[reduction().index(column)] += force;
}

void Increment::change_columns(const System& system, const Controls& controls) {
  forget_columns();
  take_columns(system, controls);
}

void Increment::forget_columns() {
  window_.forget();
  compliance_.forget();
}

bool Increment::narrow(const System& system, const Controls& controls, base::TwoPart& q) {
  if (nonlinear() || !contacts_.narrow(system, loads_, q)) return false;
  change_columns(system, controls);
  return true;
}

void Increment::follow(const System& system, const Controls& controls, base::TwoPart& q) {
  contacts_.follow(system, loads_, q);
  followed_ = true;
  nonlinear_.columns_changed(q);
  change_columns(system, controls);
}

void Increment::widen(const System& system, const Controls& controls, base::TwoPart& q) {
  contacts_.widen(system, loads_, q);
  change_columns(system, controls);
}

int Increment::decide(int iteration, contact::Start from, Allowed allowed) {
  struct Asking {
    std::size_t contact;
    int node;
    bool closes;
  };
  std::vector<Asking> asking;
  bool opens = false;
  for (std::size_t c = 0; c < lambda_.size(); ++c) {
    auto& face = contacts_.faces()[c];
    const auto last = face.status();
    face.decide(lambda_[c], iteration, from);
    for (std::size_t j = 0; j < last.size(); ++j) {
      if (last[j] == face.status()[j]) continue;
      asking.push_back({c, static_cast<int>(j), last[j] == ContactStatus::inactive});
      opens = opens || face.status()[j] == ContactStatus::inactive;
    }
  }
  for (const auto& node : asking) {
    const bool first = &node == &asking.front();
    const bool may = allowed == Allowed::all || (allowed == Allowed::one && first) ||
                     (allowed == Allowed::opening_first && !(opens && node.closes));
    if (!may) contacts_.faces()[node.contact].keep(node.node);
  }
  for (std::size_t c = 0; c < lambda_.size(); ++c)
    for (std::size_t j = 0; j < lambda_[c].size(); ++j)
      if (!contacts_.faces()[c].active(static_cast<int>(j))) lambda_[c][j].setZero();
  if (!asking.empty()) suspects_.asking = {static_cast<int>(asking.front().contact), asking.front().node};
  return static_cast<int>(asking.size());
}

ActiveSetWatch::Set Increment::active_set() const {
  ActiveSetWatch::Set set;
  for (const auto& face : contacts_.faces()) set.insert(set.end(), face.status().begin(), face.status().end());
  return set;
}

bool Increment::touching() const {
  return std::any_of(contacts_.faces().begin(), contacts_.faces().end(), [](const auto& face) {
    return std::any_of(face.status().begin(), face.status().end(), [](auto s) { return s != ContactStatus::inactive; });
  });
}

bool Increment::keep_nearest() {
  contact::Interface* of = nullptr;
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (auto& face : contacts_.faces())
    for (int j = 0; j < static_cast<int>(face.status().size()); ++j) {
      if (!face.opened(j) || !face.touching(j)) continue;
      const double gap = (face.gap()[j] + face.worn_gap(j)) / face.rows()[j].D;
      if (gap < least) of = &face, nearest = j, least = gap;
    }
  if (of) of->keep(nearest);
  return of != nullptr;
}

bool Increment::accept(const System& system, const base::TwoPart& q, SolverState& state) {
  state.q = reduction().expand(q, loads_);
  contacts_.place_all(system, state.q.high);
  if (!contacts_.enclosed()) return false;
  state.contacts.clear();
  for (std::size_t c = 0; c < lambda_.size(); ++c) {
    auto& face = contacts_.faces()[c];
    face.evaluate(lambda_[c]);
    state.contacts.push_back(face.accepted(lambda_[c]));
  }
  state.interiors = nonlinear_.accepted(state.q);
  return true;
}

double Increment::way(const Vector& dq) const {
  return dq.size() ? dq.cwiseProduct(arm_).lpNorm<Eigen::Infinity>() : 0.0;
}

std::string Increment::renew(base::TwoPart& q) { return nonlinear_.renew(q, lambda_); }

std::string Increment::linearise(const base::TwoPart& q, body::Tangent tangent) {
  try {
    nonlinear_.linearise_again(q, lambda_, tangent);
    window_.tangents_changed();
    return {};
  } catch (const base::SolveError& error) {
    return error.what();
  }
}

std::string Increment::not_found(const System& system, const std::vector<Iteration>& table,
                                 const NewtonOptions& options, bool circles) const {
  Suspects suspects = suspects_;
  suspects.circles = circles;
  if (suspects.unbalanced < 0) suspects.inside = nonlinear_.least_balanced();
  return no_convergence(system, contacts_.nodes(), suspects, table, options);
}

}  // namespace reye::solver
