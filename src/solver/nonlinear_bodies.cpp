#include "solver/nonlinear_bodies.hpp"

#include <algorithm>

#include "base/cores.hpp"
#include "base/errors.hpp"

namespace reye::solver {

namespace {

constexpr int most_halvings = 5;    ///< of a step that turns an element inside out
constexpr int most_shortened = 3;   ///< of one that makes the imbalance grow
constexpr double unbalanced = 0.1;  ///< of the forces: a smaller imbalance does not show that a step is too long
/// Share of the imbalance that is due to a symmetric part, and share of that before which is left, from which on
/// tangents are exact.
constexpr double asymmetric = 0.8, slow = 0.03;

}  // namespace

void NonlinearBodies::begin(const System& system, const SolverState& before, const Controls& controls,
                            const Reduction& reduction, const Guess* guess, double share) {
  system_ = &system;
  before_ = &before;
  controls_ = &controls;
  reduction_ = &reduction;
  any_ = false;
  interior_.assign(system.bodies.size(), {});
  linearised_.resize(system.bodies.size());
  linearised_of_.assign(system.bodies.size(), 0.0);
  for (std::size_t b = 0; b < interior_.size(); ++b) {
    if (!body(b)) continue;
    any_ = true;
    interior_[b] = before.interiors[b].y;
    if (guess) interior_[b] += guess->inside[b];
    if (share > 0.0) interior_[b] += share * last_step_[b];
  }
}

void NonlinearBodies::forget() {
  last_step_.clear();
  for (auto& at : linearised_) body::NonlinearBody::forget(at);
}

template <class Work>
void NonlinearBodies::for_each(Work work) const {
  base::side_by_side(static_cast<int>(interior_.size()), [&](int b) {
    if (const auto* own = body(static_cast<std::size_t>(b))) work(static_cast<std::size_t>(b), *own);
  });
}

bool NonlinearBodies::own(int column) const {
  const auto next = std::upper_bound(system_->offset.begin(), system_->offset.end(), column);
  return body(static_cast<std::size_t>(next - system_->offset.begin()) - 1) != nullptr;
}

void NonlinearBodies::linearise(const base::TwoPart& q, const Multipliers& lambda, body::Tangent tangent) {
  for_each([&](std::size_t b, const body::NonlinearBody& own) {
    own.linearise(before_->interiors[b], interior_[b], part(own, b, q), controls_->load_factors[b], linearised_[b],
                  tangent);
    linearised_of_[b] = linearised_[b].interior_residual;
  });
  anchor_ = q;
  anchor_lambda_ = lambda;
}

void NonlinearBodies::linearise_again(const base::TwoPart& q, const Multipliers& lambda, body::Tangent tangent) {
  for_each([&](std::size_t b, const body::NonlinearBody& own) {
    auto& at = linearised_[b];
    const double imbalance = at.interior_residual;
    const bool exact = tangent == body::Tangent::exact ||
                       (imbalance > slow * linearised_of_[b] && own.left_out(at) > asymmetric * imbalance);
    linearised_of_[b] = imbalance;
    own.linearise_again(before_->interiors[b], at, exact ? body::Tangent::exact : tangent);
  });
  anchor_ = q;
  anchor_lambda_ = lambda;
}

void NonlinearBodies::measure(const base::TwoPart& q, const Multipliers& lambda) {
  for_each([&](std::size_t b, const body::NonlinearBody& own) {
    own.measure(before_->interiors[b], interior_[b], part(own, b, q), controls_->load_factors[b], linearised_[b]);
  });
  anchor_ = q;
  anchor_lambda_ = lambda;
}

std::string NonlinearBodies::renew(base::TwoPart& q, Multipliers& lambda) {
  Vector way = (q - anchor_).high;
  std::vector<Vector> inside(interior_.size());
  for_each([&](std::size_t b, const body::NonlinearBody& own) {
    inside[b] = own.interior_step(linearised_[b], part(own, b, way));
    interior_[b] += inside[b];
  });
  const Multipliers start = anchor_lambda_;
  const double imbalance = inside_imbalance();
  for (int halvings = 0;; ++halvings) {
    try {
      measure(q, lambda);
      // This guard is for steps that leave the reach of their tangent. A first step, from balance, leaves some
      // imbalance behind.
      if (halvings == most_shortened || inside_imbalance() < std::max(2.0 * imbalance, unbalanced * force_scale()))
        return {};
    } catch (const base::SolveError& error) {
      if (halvings == most_halvings) return error.what();
    }
    way *= 0.5;
    q += -way;
    for (std::size_t b = 0; b < inside.size(); ++b)
      if (inside[b].size() > 0) interior_[b] += -(inside[b] *= 0.5);
    for (std::size_t c = 0; c < lambda.size(); ++c)
      for (std::size_t j = 0; j < lambda[c].size(); ++j) lambda[c][j] = 0.5 * (lambda[c][j] + start[c][j]);
  }
}

const Matrix* NonlinearBodies::tangent(int b) const {
  return body(static_cast<std::size_t>(b)) ? &linearised_[static_cast<std::size_t>(b)].S : nullptr;
}

Vector NonlinearBodies::deformation(int b, const base::TwoPart& q) const {
  const auto body = static_cast<std::size_t>(b);
  const auto& own = *this->body(body);
  return own.translation().without(part(own, body, q) - part(own, body, anchor_));
}

void NonlinearBodies::add_residual(int b, const Vector& v, Vector& r) const {
  const auto& at = linearised_[static_cast<std::size_t>(b)];
  auto own = r.segment(reduction_->first(b), at.r.size());
  own += at.r;
  own.noalias() += at.S * v;
}

double NonlinearBodies::inside_imbalance() const {
  double largest = 0.0;
  for (const auto& at : linearised_) largest = std::max(largest, at.interior_residual);
  return largest;
}

std::string NonlinearBodies::least_balanced() const {
  const double largest = inside_imbalance();
  for (std::size_t b = 0; b < linearised_.size(); ++b)
    if (const auto* own = body(b); own && linearised_[b].interior_residual == largest)
      return own->least_balanced(linearised_[b]);
  return {};
}

double NonlinearBodies::force_scale() const {
  double largest = 0.0;
  for (const auto& at : linearised_) largest = std::max(largest, at.force_scale);
  return largest;
}

std::vector<body::Interior> NonlinearBodies::accepted(const base::TwoPart& q) const {
  std::vector<body::Interior> interiors(interior_.size());
  for_each([&](std::size_t b, const body::NonlinearBody& own) {
    interiors[b] = own.accepted(before_->interiors[b], interior_[b], q.segment(system_->offset[b], own.dofs()));
  });
  return interiors;
}

void NonlinearBodies::remember(const SolverState& after) {
  last_step_.assign(interior_.size(), {});
  for (std::size_t b = 0; b < last_step_.size(); ++b)
    if (body(b)) last_step_[b] = (after.interiors[b].y - before_->interiors[b].y).high;
}

}  // namespace reye::solver
