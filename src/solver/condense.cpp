#include "solver/condense.hpp"

#include "algebra/factor.hpp"

namespace reye::solver {

using contact::ContactStatus;

void Condenser::start(const System& system, const Vector& rhs) {
  linearised_.resize(system.contacts.size());
  elimination_.resize(system.contacts.size());
  At_.setZero(rhs.size(), rhs.size());
  b_ = rhs;
}

/// What turns with q turns the arms of its forces, too: second derivatives of positions in the tangent.
void Condenser::turn(const System& system, const contact::Setup& setup, const Vector& force, const Reduction& reduction,
                     const Vector& q) {
  turned_.resize(system.bodies.size());
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const bool turns = !std::holds_alternative<body::LinearBody>(system.bodies[b]);
    const auto count = turns ? std::visit([](const auto& o) { return o.contact_nodes().size(); }, system.bodies[b]) : 0;
    turned_[b].assign(count, Vec2::Zero());
  }
  Eigen::Index k = 0;
  for (const auto* nodes : {&setup.secondary_nodes, &setup.primary_nodes})
    for (const auto& node : *nodes) {
      if (!turned_[node.body].empty()) turned_[node.body][node.contact_node] += force.segment<2>(k);
      k += 2;
    }
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const int at = reduction.first(static_cast<int>(b));
    if (const auto* rigid = std::get_if<body::RigidBody>(&system.bodies[b]))
      At_(at + 2, at + 2) += rigid->geometric(q.segment(at, rigid->dofs()), turned_[b]);
    else if (const auto* nonlinear = std::get_if<body::NonlinearBody>(&system.bodies[b]))
      At_.diagonal().segment(at, nonlinear->dofs()) += nonlinear->geometric(q.segment(at, nonlinear->dofs()), turned_[b]);
  }
}

void Condenser::add_contact(const System& system, int contact, contact::Interface& face, const std::vector<PlacedNode>& nodes,
                            const std::vector<Vec2>& lambda, const Reduction& reduction, const Vector& q) {
  auto& linearised = linearised_[contact];
  face.linearise(lambda, linearised);
  for (const auto& e : linearised.force) {
    const auto &row = nodes[e.row / 2], &col = nodes[e.col / 2];
    for (int r = 0; r < row.position.count; ++r)
      for (int k = 0; k < col.position.count; ++k)
        At_(col.column[k], row.column[r]) +=
            e.value * row.position.terms[r].direction[e.row % 2] * col.position.terms[k].direction[e.col % 2];
  }
  turn(system, system.contacts[contact], face.forces(lambda), reduction, q);
}

/// lambda = constant + slope dq from the balance of each active node.
void Condenser::express(const contact::Interface& face, const std::vector<PlacedNode>& nodes, Elimination& elim) const {
  const int ns = face.setup().secondary_count();
  elim.place.assign(ns, -1);
  int count = 0;
  for (int j = 0; j < ns; ++j)
    if (face.active(j)) {
      elim.place[j] = count;
      count += 2;
    }
  elim.slope.setZero(At_.rows(), count);
  elim.constant.setZero(count);
  for (int j = 0; j < ns; ++j) {
    if (elim.place[j] < 0) continue;
    const double D = face.rows()[j].D;
    const auto& p = nodes[j].position;
    for (int t = p.count - nodes[j].free; t < p.count; ++t)
      for (int c = 0; c < 2; ++c) {
        const double share = p.terms[t].direction[c] / D;
        if (share == 0.0) continue;
        elim.slope.col(elim.place[j] + c) -= share * At_.col(nodes[j].column[t]);
        elim.constant[elim.place[j] + c] += share * b_[nodes[j].column[t]];
      }
  }
}

/// Adds factor * lambda to the rows of a node.
void Condenser::load(const PlacedNode& node, const Elimination& elim, int from, double factor) {
  for (int t = 0; t < node.position.count; ++t)
    for (int c = 0; c < 2; ++c) {
      const double weight = factor * node.position.terms[t].direction[c];
      if (weight == 0.0) continue;
      At_.col(node.column[t]) += weight * elim.slope.col(from + c);
      b_[node.column[t]] -= weight * elim.constant[from + c];
    }
}

void Condenser::eliminate(int contact, const contact::Interface& face, const std::vector<PlacedNode>& nodes,
                          const std::vector<Vec2>& lambda) {
  auto& elim = elimination_[contact];
  express(face, nodes, elim);
  const int ns = face.setup().secondary_count();
  for (int j = 0; j < ns; ++j) {
    if (elim.place[j] < 0) continue;
    const auto& row = face.rows()[j];
    for (const auto& [k, share] : row.off) load(nodes[k], elim, elim.place[j], share);
    for (const auto& [l, M] : row.M) load(nodes[ns + l], elim, elim.place[j], -M);
  }
  conditions(face, nodes, lambda, elim, linearised_[contact]);
}

/// Conditions replace the rows of a node's free columns, scaled to the stiffness of their surroundings.
void Condenser::conditions(const contact::Interface& face, const std::vector<PlacedNode>& nodes, const std::vector<Vec2>& lambda,
                           const Elimination& elim, const contact::Linearised& linearised) {
  const auto ns = elim.place.size();
  std::vector<int> target(2 * ns, -1);
  std::vector<double> scale(2 * ns, 0.0);
  for (std::size_t j = 0; j < ns; ++j) {
    if (elim.place[j] < 0) continue;
    const int node = static_cast<int>(j), first = nodes[j].position.count - nodes[j].free;
    const bool traction = face.status()[j] == ContactStatus::slip || face.held();
    for (int t = 0; t < nodes[j].free; ++t) {
      const int row = nodes[j].column[first + t];
      target[2 * j + t] = row;
      scale[2 * j + t] = t == 1 && traction ? face.rows()[j].D : face.setup().stiffness[j];
      At_.col(row).setZero();
      b_[row] = -scale[2 * j + t] * (t == 0 ? face.residual_normal(node) : face.residual_tangential(node));
    }
  }
  const int multipliers = face.dofs();
  for (const auto& e : linearised.rows) {
    const int row = target[e.row];
    if (row < 0) continue;
    const double value = scale[e.row] * e.value;
    if (e.col >= multipliers) {
      const int j = (e.col - multipliers) / 2, c = (e.col - multipliers) % 2;
      At_.col(row) += value * elim.slope.col(elim.place[j] + c);
      b_[row] -= value * (elim.constant[elim.place[j] + c] - lambda[j][c]);
      continue;
    }
    const auto& node = nodes[e.col / 2];
    for (int t = 0; t < node.position.count; ++t)
      At_(node.column[t], row) += value * node.position.terms[t].direction[e.col % 2];
  }
}

void Condenser::fix(int column, double by) {
  At_.col(column).setZero();
  At_(column, column) = 1.0;
  b_[column] = by;
}

Vector Condenser::solve() { return algebra::solve_dense_transposed(At_, b_); }

void Condenser::recover(int contact, const Vector& dq, std::vector<Vec2>& lambda) const {
  const auto& elim = elimination_[contact];
  const Vector step = elim.constant + elim.slope.transpose() * dq;
  for (std::size_t j = 0; j < lambda.size(); ++j)
    lambda[j] = elim.place[j] < 0 ? Vec2::Zero() : Vec2(step.segment<2>(elim.place[j]));
}

}  // namespace reye::solver
