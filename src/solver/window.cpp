#include "solver/window.hpp"

#include <algorithm>
#include <memory>

namespace reye::solver {

namespace {

constexpr int spare = 1;  ///< nodes beyond what is needed, for a contact that grows: a new choice costs half a matrix
/// Share of the columns of a nonlinear body from which on it pays to condense them out of each of its tangents.
constexpr double worth_condensing = 0.5;

void keep_where_few_are_out(const System& system, const NonlinearBodies& nonlinear, std::vector<char>& out) {
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    if (!nonlinear.tangent(static_cast<int>(b))) continue;
    const auto first = out.begin() + system.offset[b], last = first + body::dofs(system.bodies[b]);
    const auto count = std::count(first, last, 1);
    const bool few = static_cast<double>(count) < worth_condensing * static_cast<double>(last - first);
    if (few || count == last - first) std::fill(first, last, 0);
  }
}

}  // namespace

void Window::choose(const System& system, const Reduction& reduction, const NonlinearBodies& nonlinear,
                    const Reach& needed) {
  if (chosen_ && reach_.holds(needed)) {
    if (!renewed_) renew(system, nonlinear);
    return;
  }
  chosen_ = renewed_ = false;  // also where what follows throws
  reach_ = needed.widened(system, spare);
  auto out = reach_.columns_out(system, Reach::Bodies::deformable);
  keep_where_few_are_out(system, nonlinear, out);
  columns_ = {};
  split_.clear();
  first_reduced_.clear();
  parts_.assign(system.bodies.size(), {});
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const int body = static_cast<int>(b), from = reduction.first(body);
    const int to = b + 1 < system.bodies.size() ? reduction.first(body + 1) : reduction.size();
    first_reduced_.push_back(from);
    split_.push_back(columns_.add(to - from, [&](int i) { return out[reduction.column(i)]; }));
    if (reduction.stiffness(body).size() == 0) continue;
    const auto& [near, far] = split_.back();
    if (const auto* turning = reduction.turning(body)) {
      parts_[b].whole = *turning;
      parts_[b].turning = turning->part(near);
    }
    static_cast<Condensed&>(parts_[b]) = reduction.part(body, near, far);
  }
  renew(system, nonlinear);
  chosen_ = true;
}

/// Condenses nonlinear bodies by their present tangents.
void Window::renew(const System& system, const NonlinearBodies& nonlinear) {
  for (std::size_t b = 0; b < system.bodies.size(); ++b)
    if (const auto* S = nonlinear.tangent(static_cast<int>(b)))
      static_cast<Condensed&>(parts_[b]) = Condensed::tangent(*S, split_[b].near, split_[b].far);
  renewed_ = true;
}

void Window::turn(int body, const Vector& q, const Vector& forces, const Vector& rate) {
  Part& part = parts_[body];
  part.q = q(part.near());
  part.forces = forces(part.near());
  part.rate = part.Condensed::load(rate);
}

void Window::add_turning(int body, Eigen::Ref<Matrix> transposed) const {
  const Part& part = parts_[body];
  if (part.turning) part.turning->turn(part.q, part.forces, part.rate.near, transposed);
}

Window::Load Window::load(const Vector& b) const {
  Load result{b(columns_.column), std::vector<Vector>(parts_.size())};
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const Part& part = parts_[k];
    if (part.size() == 0) continue;
    Vector forces = b.segment(first_reduced_[k], part.full());
    const double angle = part.turning ? part.turning->angle_of(part.q) : 0.0;
    if (part.turning) part.whole->to_frame(angle, forces);
    auto load = part.Condensed::load(forces);
    if (part.turning) part.turning->to_axes(angle, load.near);
    result.inside.segment(columns_.first[k], part.size()) = load.near;
    result.own[k] = std::move(load.own);
  }
  return result;
}

Vector Window::expand(const Vector& inside, const Load& load) const {
  Vector all = Vector::Zero(static_cast<Eigen::Index>(columns_.index.size()));
  all(columns_.column) = inside;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const Part& part = parts_[k];
    if (part.size() == 0 || part.far().empty()) continue;
    const Vector near = inside.segment(columns_.first[k], part.size());
    const Vector far = part.turning ? part.moved(part.turning->step_in_frame(part.q, near),
                                                 load.own[k] + near[part.turning->angle] * part.rate.own)
                                    : part.moved(near, load.own[k]);
    for (std::size_t i = 0; i < part.far().size(); ++i)
      all[first_reduced_[k] + part.far()[i]] = far[static_cast<Eigen::Index>(i)];
  }
  return all;
}

}  // namespace reye::solver
