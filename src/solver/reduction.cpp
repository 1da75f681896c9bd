#include "solver/reduction.hpp"

namespace reye::solver {

Reduction::Reduction(const System& system, const Reach& reach) : offset_(system.offset) {
  const auto out = reach.columns_out(system);
  index_.assign(system.dofs, -1);
  parts_.resize(system.bodies.size());
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const int n = std::visit([](const auto& o) { return o.dofs(); }, system.bodies[b]);
    std::vector<int> near, far;
    first_.push_back(size());
    for (int i = 0; i < n; ++i) {
      const int column = system.offset[b] + i;
      if (out[column]) {
        far.push_back(i);
        continue;
      }
      index_[column] = size();
      kept_.push_back(column);
      near.push_back(i);
    }
    if (const auto* linear = std::get_if<body::LinearBody>(&system.bodies[b]))
      parts_[b] = Condensed(linear->tangent({}), std::move(near), std::move(far));
  }
}

Vector Reduction::restrict_to(const Vector& q) const { return q(kept_); }

Vector Reduction::loads(const System& system, const std::vector<Vector>& load_factors) {
  Vector f = Vector::Zero(size());
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const auto* linear = std::get_if<body::LinearBody>(&system.bodies[b]);
    if (!linear || load_factors[b].size() == 0) continue;
    const Vector near = parts_[b].load(-linear->residual(Vector::Zero(linear->dofs()), load_factors[b]));
    f.segment(first_[b], near.size()) = near;
  }
  return f;
}

Vector Reduction::scatter(const Vector& reduced) const {
  Vector q = Vector::Zero(static_cast<Eigen::Index>(index_.size()));
  for (int i = 0; i < size(); ++i) q[kept_[i]] = reduced[i];
  return q;
}

Vector Reduction::expand(const Vector& reduced) const {
  Vector q = scatter(reduced);
  for (std::size_t b = 0; b < parts_.size(); ++b) {
    const auto& part = parts_[b];
    if (part.size() == 0) continue;
    const Vector full = part.expand(reduced.segment(first_[b], part.size()));
    q.segment(offset_[b], full.size()) = full;
  }
  return q;
}

}  // namespace reye::solver
