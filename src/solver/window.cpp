#include "solver/window.hpp"

namespace reye::solver {

constexpr int spare = 1;  ///< nodes beyond what is needed, for a contact that goes on: to choose anew costs half a matrix

void Window::choose(const System& system, const Reduction& reduction, const Reach& needed) {
  if (chosen_ && reach_.holds(needed)) return;
  chosen_ = true;
  reach_ = needed.widened(system, spare);
  const auto out = reach_.columns_out(system);
  const int n = reduction.size();
  inside_.clear();
  first_.clear();
  first_reduced_.clear();
  index_.assign(n, -1);
  parts_.assign(system.bodies.size(), {});
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const int body = static_cast<int>(b), from = reduction.first(body);
    const int to = b + 1 < system.bodies.size() ? reduction.first(body + 1) : n;
    std::vector<int> near, far;
    first_.push_back(static_cast<int>(inside_.size()));
    first_reduced_.push_back(from);
    for (int i = from; i < to; ++i) {
      if (out[reduction.column(i)]) {
        far.push_back(i - from);
        continue;
      }
      index_[i] = static_cast<int>(inside_.size());
      inside_.push_back(i);
      near.push_back(i - from);
    }
    if (reduction.stiffness(body).size() > 0) parts_[b] = Condensed(reduction.stiffness(body), std::move(near), std::move(far));
  }
}

Vector Window::load(const Vector& b) {
  Vector inside = b(inside_);
  for (std::size_t k = 0; k < parts_.size(); ++k)
    if (parts_[k].size() > 0) inside.segment(first_[k], parts_[k].size()) = parts_[k].load(b.segment(first_reduced_[k], parts_[k].full()));
  return inside;
}

Vector Window::expand(const Vector& inside) const {
  Vector all = Vector::Zero(static_cast<Eigen::Index>(index_.size()));
  all(inside_) = inside;
  for (std::size_t k = 0; k < parts_.size(); ++k)
    if (parts_[k].size() > 0)
      all.segment(first_reduced_[k], parts_[k].full()) = parts_[k].expand(inside.segment(first_[k], parts_[k].size()));
  return all;
}

}  // namespace reye::solver
