#include "solver/reduction.hpp"

#include <algorithm>

namespace reye::solver {

Reduction::Reduction(const System& system, const Reach& reach) : offset_(system.offset) {
  std::vector<char> far(system.dofs, 0), near(system.dofs, 0);
  const auto mark = [&](const std::vector<contact::SurfaceNode>& nodes, const std::vector<char>& in_reach) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const int body = nodes[k].body;
      const auto* linear = std::get_if<body::LinearBody>(&system.bodies[body]);
      if (!linear) continue;
      const auto p = linear->position(nodes[k].contact_node, Vector::Zero(linear->dofs()));
      const int free = linear->freedom(nodes[k].contact_node).free;
      for (int t = p.count - free; t < p.count; ++t) (in_reach[k] ? near : far)[system.offset[body] + p.terms[t].column] = 1;
    }
  };
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    mark(system.contacts[c].secondary_nodes, reach.secondary[c]);
    mark(system.contacts[c].primary_nodes, reach.primary[c]);
  }
  index_.assign(system.dofs, -1);
  parts_.resize(system.bodies.size());
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    auto& part = parts_[b];
    const int n = std::visit([](const auto& o) { return o.dofs(); }, system.bodies[b]);
    first_.push_back(size());
    for (int i = 0; i < n; ++i) {
      const int column = system.offset[b] + i;
      if (far[column] && !near[column]) {
        part.far.push_back(i);
        continue;
      }
      index_[column] = size();
      kept_.push_back(column);
      part.near.push_back(i);
    }
    const auto* linear = std::get_if<body::LinearBody>(&system.bodies[b]);
    if (!linear) continue;
    const Matrix& S = linear->tangent({});
    part.S = S(part.near, part.near);
    part.own = Vector::Zero(static_cast<Eigen::Index>(part.far.size()));
    if (part.far.empty()) continue;
    const Matrix coupling = S(part.far, part.near);
    part.factor.compute(S(part.far, part.far));
    part.G = part.factor.solve(coupling);
    part.S.noalias() -= coupling.transpose() * part.G;
    part.S = 0.5 * (part.S + part.S.transpose()).eval();
  }
}

Vector Reduction::restrict_to(const Vector& q) const { return q(kept_); }

Vector Reduction::loads(const System& system, const std::vector<Vector>& load_factors) {
  Vector f = Vector::Zero(size());
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    auto& part = parts_[b];
    const auto* linear = std::get_if<body::LinearBody>(&system.bodies[b]);
    if (!linear || load_factors[b].size() == 0) continue;
    const Vector full = -linear->residual(Vector::Zero(linear->dofs()), load_factors[b]);
    const Vector far = full(part.far);
    Vector near = full(part.near);
    if (!part.far.empty()) {
      near -= part.G.transpose() * far;
      part.own = part.factor.solve(far);
    }
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
    if (part.far.empty()) continue;
    const Vector far = part.own - part.G * reduced.segment(first_[b], static_cast<Eigen::Index>(part.near.size()));
    for (std::size_t i = 0; i < part.far.size(); ++i) q[offset_[b] + part.far[i]] = far[static_cast<Eigen::Index>(i)];
  }
  return q;
}

}  // namespace reye::solver
