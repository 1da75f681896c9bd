#include "solver/window.hpp"

namespace reye::solver {

constexpr int spare = 1;  ///< nodes beyond what is needed, for a contact that goes on: to choose anew costs half a matrix

void Window::choose(const System& system, const Reduction& reduction, const Reach& needed) {
  if (chosen_ && reach_.holds(needed)) return;
  chosen_ = true;
  reach_ = needed.widened(system, spare);
  const auto out = reach_.columns_out(system);
  columns_ = {};
  first_reduced_.clear();
  parts_.assign(system.bodies.size(), {});
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const int body = static_cast<int>(b), from = reduction.first(body);
    const int to = b + 1 < system.bodies.size() ? reduction.first(body + 1) : reduction.size();
    first_reduced_.push_back(from);
    auto [near, far] = columns_.add(to - from, [&](int i) { return out[reduction.column(i)]; });
    if (reduction.stiffness(body).size() > 0) parts_[b] = Condensed(reduction.stiffness(body), std::move(near), std::move(far));
  }
}

Vector Window::load(const Vector& b) {
  Vector inside = b(columns_.column);
  for (std::size_t k = 0; k < parts_.size(); ++k)
    if (parts_[k].size() > 0)
      inside.segment(columns_.first[k], parts_[k].size()) = parts_[k].load(b.segment(first_reduced_[k], parts_[k].full()));
  return inside;
}

Vector Window::expand(const Vector& inside) const {
  Vector all = Vector::Zero(static_cast<Eigen::Index>(columns_.index.size()));
  all(columns_.column) = inside;
  for (std::size_t k = 0; k < parts_.size(); ++k)
    if (parts_[k].size() > 0)
      all.segment(first_reduced_[k], parts_[k].full()) = parts_[k].expand(inside.segment(columns_.first[k], parts_[k].size()));
  return all;
}

}  // namespace reye::solver
