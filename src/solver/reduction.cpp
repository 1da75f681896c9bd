#include "solver/reduction.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace reye::solver {

using contact::ContactStatus;

Reach Reach::all(const System& system) {
  Reach reach;
  for (const auto& setup : system.contacts) {
    reach.secondary.emplace_back(setup.secondary.X.size(), 1);
    reach.primary.emplace_back(setup.primary.X.size(), 1);
  }
  return reach;
}

namespace {

/// Marks everything within `margin` facets of a marked node.
void widen(const mortar::Surface& surface, std::vector<char>& mark, int margin) {
  for (int round = 0; round < margin; ++round) {
    const auto old = mark;
    for (const auto& [a, b, c] : surface.facets) {
      if (!old[a] && !old[b] && !(c >= 0 && old[c])) continue;
      mark[a] = mark[b] = 1;
      if (c >= 0) mark[c] = 1;
    }
  }
}

}  // namespace

Reach Reach::round_contact(const System& system, const std::vector<contact::ContactState>& contacts, int margin) {
  Reach reach;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    const auto& state = contacts[c];
    std::vector<char> secondary(setup.secondary.X.size(), 0), primary(setup.primary.X.size(), 0);
    int active = 0;
    for (std::size_t j = 0; j < secondary.size(); ++j) {
      if (state.status[j] == ContactStatus::inactive) continue;
      ++active;
      secondary[j] = 1;
      for (const auto& [l, M] : state.reference[j].M) primary[l] = 1;
    }
    if (active == 0) return all(system);
    widen(setup.secondary, secondary, margin + active / 4);
    for (std::size_t j = 0; j < secondary.size(); ++j)
      if (secondary[j])
        for (const auto& [l, M] : state.reference[j].M) primary[l] = 1;
    widen(setup.primary, primary, margin + active / 4);
    reach.secondary.push_back(std::move(secondary));
    reach.primary.push_back(std::move(primary));
  }
  return reach;
}

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
    part.f_far = Vector::Zero(static_cast<Eigen::Index>(part.far.size()));
    if (part.far.empty()) continue;
    const Matrix coupling = S(part.far, part.near);
    const Eigen::LLT<Matrix> factor(S(part.far, part.far));
    part.inverse = factor.solve(Matrix::Identity(part.f_far.size(), part.f_far.size()));
    part.G = factor.solve(coupling);
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
    part.f_far = full(part.far);
    Vector near = full(part.near);
    if (!part.far.empty()) near -= part.G.transpose() * part.f_far;
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
    const Vector far = part.inverse * part.f_far - part.G * reduced.segment(first_[b], static_cast<Eigen::Index>(part.near.size()));
    for (std::size_t i = 0; i < part.far.size(); ++i) q[offset_[b] + part.far[i]] = far[static_cast<Eigen::Index>(i)];
  }
  return q;
}

}  // namespace reye::solver
