#include "solver/condense.hpp"

#include <stdexcept>
#include <utility>

namespace reye::solver {

namespace {

/// Columns that contact acts on are all in the window.
int inside(int column) {
  if (column < 0) throw std::logic_error("contact acts beyond the window of Newton's matrix");
  return column;
}

}  // namespace

void Condenser::start(const System& system, const Vector& rhs, const std::vector<contact::Interface>& faces,
                      const std::vector<std::vector<PlacedNode>>& nodes) {
  elimination_.resize(system.contacts.size());
  held_ = 0;
  for (std::size_t c = 0; c < faces.size(); ++c)
    for (int j = 0; j < faces[c].setup().secondary_count(); ++j) held_ += faces[c].active(j) && nodes[c][j].free == 1;
  At_.setZero(rhs.size() + held_, rhs.size() + held_);
  next_held_ = static_cast<int>(rhs.size());
  factored_ = false;
  again(rhs);
}

void Condenser::again(const Vector& rhs) {
  b_.setZero(rhs.size() + held_);
  b_.head(rhs.size()) = rhs;
}

/// What turns with q turns the arms of its forces, too: second derivatives of positions in the tangent.
void Condenser::turn(const System& system, const contact::Setup& setup, const Vector& force, const Reduction& reduction,
                     const Window& window, const Vector& q) {
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
    const int at = reduction.first(static_cast<int>(b)), column = window.first(static_cast<int>(b));
    if (const auto* rigid = std::get_if<body::RigidBody>(&system.bodies[b]))
      At_(column + 2, column + 2) += rigid->geometric(q.segment(at, rigid->dofs()), turned_[b]);
    else if (const auto* nonlinear = std::get_if<body::NonlinearBody>(&system.bodies[b]))
      At_.diagonal().segment(column, nonlinear->dofs()) += nonlinear->geometric(q.segment(at, nonlinear->dofs()), turned_[b]);
  }
}

/// Of linear bodies that turn the columns of the nodes themselves turn.
void Condenser::turn(const std::vector<PlacedNode>& nodes, const Vector& force) {
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const auto& p = nodes[k].position;
    if (p.angle < 0) continue;
    const Vec2 f = force.segment<2>(2 * static_cast<Eigen::Index>(k));
    if (f.isZero(0.0)) continue;
    for (int t = p.turned; t < p.count; ++t)
      At_(inside(nodes[k].angle), inside(nodes[k].column[t])) += base::cross(p.terms[t].direction, f);
  }
}

const std::vector<contact::Linearised>& Condenser::linearise(std::vector<contact::Interface>& contacts,
                                                             const std::vector<std::vector<Vec2>>& lambda) {
  linearised_.resize(contacts.size());
  for (std::size_t c = 0; c < contacts.size(); ++c) contacts[c].linearise(lambda[c], linearised_[c]);
  return linearised_;
}

void Condenser::add_contact(const System& system, int contact, const contact::Interface& face, const std::vector<PlacedNode>& nodes,
                            const std::vector<Vec2>& lambda, const Reduction& reduction, const Window& window,
                            const Vector& q) {
  for (const auto& e : linearised_[contact].force) {
    const auto &row = nodes[e.row / 2], &col = nodes[e.col / 2];
    for (int r = 0; r < row.position.count; ++r) {
      const double value = e.value * row.position.terms[r].direction[e.row % 2];
      for (int k = 0; k < col.position.count; ++k)
        At_(inside(col.column[k]), inside(row.column[r])) += value * col.position.terms[k].direction[e.col % 2];
      if (col.angle >= 0) At_(col.angle, inside(row.column[r])) += value * col.position.swing[e.col % 2];
    }
  }
  const Vector force = face.forces(lambda);
  turn(nodes, force);
  turn(system, system.contacts[contact], force, reduction, window, q);
}

/// dlambda = constant + slope dq from the balance of each active node; along a held direction an unknown.
void Condenser::express(const contact::Interface& face, const std::vector<PlacedNode>& nodes, Elimination& elim) {
  const int ns = face.setup().secondary_count();
  elim.place.assign(ns, -1);
  elim.held.assign(ns, -1);
  elim.from.clear();
  int count = 0;
  for (int j = 0; j < ns; ++j)
    if (face.active(j)) {
      elim.place[j] = count;
      count += 2;
    }
  elim.slope.setZero(At_.rows(), count);
  for (int j = 0; j < ns; ++j) {
    if (elim.place[j] < 0) continue;
    const double D = face.rows()[j].D;
    const auto& p = nodes[j].position;
    for (int t = p.count - nodes[j].free; t < p.count; ++t)
      for (int c = 0; c < 2; ++c) {
        const double share = p.terms[t].direction[c] / D;
        if (share == 0.0) continue;
        elim.slope.col(elim.place[j] + c) -= share * At_.col(nodes[j].column[t]);
        elim.from.push_back({nodes[j].column[t], elim.place[j] + c, share});
      }
    if (nodes[j].free == 2) continue;
    elim.held[j] = next_held_++;
    const Vec2& free = p.terms[p.count - 1].direction;
    elim.slope(elim.held[j], elim.place[j]) = -free.y() * face.setup().stiffness[j];
    elim.slope(elim.held[j], elim.place[j] + 1) = free.x() * face.setup().stiffness[j];
  }
}

/// Adds factor * dlambda to the rows of a node.
void Condenser::load(const PlacedNode& node, Elimination& elim, int from, double factor) {
  for (int t = 0; t < node.position.count; ++t)
    for (int c = 0; c < 2; ++c) {
      const double weight = factor * node.position.terms[t].direction[c];
      if (weight == 0.0) continue;
      At_.col(node.column[t]) += weight * elim.slope.col(from + c);
      elim.to.push_back({node.column[t], from + c, weight});
    }
}

void Condenser::eliminate(int contact, const contact::Interface& face, const std::vector<PlacedNode>& nodes) {
  auto& elim = elimination_[contact];
  if (!factored_) {
    express(face, nodes, elim);
    elim.to.clear();
    const int ns = face.setup().secondary_count();
    for (int j = 0; j < ns; ++j) {
      if (elim.place[j] < 0) continue;
      const auto& row = face.rows()[j];
      for (const auto& [k, share] : row.off) load(nodes[k], elim, elim.place[j], share);
      for (const auto& [l, M] : row.M) load(nodes[ns + l], elim, elim.place[j], -M);
    }
    conditions(face, nodes, elim, linearised_[contact]);
  }
  right_hand_side(face, elim);
}

/// Conditions replace the rows of a node's free columns, and give held multipliers theirs, scaled to the stiffness of their surroundings.
void Condenser::conditions(const contact::Interface& face, const std::vector<PlacedNode>& nodes, Elimination& elim,
                           const contact::Linearised& linearised) {
  const auto ns = elim.place.size();
  std::vector<int> of_row(2 * ns, -1);
  elim.conditions.clear();
  for (std::size_t j = 0; j < ns; ++j) {
    if (elim.place[j] < 0) continue;
    const int first = nodes[j].position.count - nodes[j].free;
    const bool traction = face.shear_is_given(static_cast<int>(j));
    for (int t = 0; t < 2; ++t) {
      const int row = 2 * static_cast<int>(j) + t;
      of_row[row] = static_cast<int>(elim.conditions.size());
      const double scale = t == 1 && traction ? face.rows()[j].D : face.setup().stiffness[j];
      elim.conditions.push_back({t < nodes[j].free ? nodes[j].column[first + t] : elim.held[j], row, scale});
      At_.col(elim.conditions.back().column).setZero();
    }
  }
  const int multipliers = face.dofs();
  weight_.setZero(elim.slope.cols(), static_cast<Eigen::Index>(elim.conditions.size()));
  elim.met.clear();
  for (const auto& e : linearised.rows) {
    const int k = of_row[e.row];
    if (k < 0) continue;
    const auto& condition = elim.conditions[k];
    const double value = condition.scale * e.value;
    if (e.col >= multipliers) {
      const int component = elim.place[(e.col - multipliers) / 2] + (e.col - multipliers) % 2;
      double& weight = weight_(component, k);
      if (weight == 0.0) elim.met.push_back({k, component, 0.0});
      weight += value;
      continue;
    }
    const auto& node = nodes[e.col / 2];
    for (int t = 0; t < node.position.count; ++t)
      At_(inside(node.column[t]), condition.column) += value * node.position.terms[t].direction[e.col % 2];
    if (node.angle >= 0) At_(node.angle, condition.column) += value * node.position.swing[e.col % 2];
  }
  for (auto& s : elim.met) {  // a weight that passed through zero is met twice, and counts once
    s.factor = std::exchange(weight_(s.component, s.column), 0.0);
    s.column = elim.conditions[s.column].column;
    At_.col(s.column) += s.factor * elim.slope.col(s.component);
  }
}

/// What elimination makes of the residuals.
void Condenser::right_hand_side(const contact::Interface& face, Elimination& elim) {
  elim.constant.setZero(elim.slope.cols());
  for (const auto& s : elim.from) elim.constant[s.component] += s.factor * b_[s.column];
  for (const auto& s : elim.to) b_[s.column] -= s.factor * elim.constant[s.component];
  for (const auto& c : elim.conditions)
    b_[c.column] = -c.scale * (c.row % 2 == 0 ? face.residual_normal(c.row / 2) : face.residual_tangential(c.row / 2));
  for (const auto& s : elim.met) b_[s.column] -= s.factor * elim.constant[s.component];
}

void Condenser::fix(int column, double by) {
  if (!factored_) {
    At_.col(column).setZero();
    At_(column, column) = 1.0;
  }
  b_[column] = by;
}

void Condenser::tie(int column, const std::vector<std::pair<int, double>>& factors, double value) {
  if (!factored_) {
    At_.col(column).setZero();
    for (const auto& [of, factor] : factors) At_(of, column) = factor;
  }
  b_[column] = value;
}

Vector Condenser::solve() {
  if (!factored_) factor_.factor(At_);
  factored_ = true;
  return factor_.solve_transposed(b_);
}

void Condenser::advance(int contact, const Vector& dq, std::vector<Vec2>& lambda) const {
  const auto& elim = elimination_[contact];
  const Vector step = elim.constant + elim.slope.transpose() * dq;
  for (std::size_t j = 0; j < lambda.size(); ++j)
    lambda[j] = elim.place[j] < 0 ? Vec2::Zero() : Vec2(lambda[j] + step.segment<2>(elim.place[j]));
}

}  // namespace reye::solver
