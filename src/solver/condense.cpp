#include "solver/condense.hpp"

#include <stdexcept>

namespace reye::solver {

int inside(int column) {
  if (column < 0) throw std::logic_error("contact acts beyond the window of Newton's matrix");
  return column;
}

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

void Condenser::add_body(int at, const Matrix& tangent) {
  At_.block(at, at, tangent.cols(), tangent.rows()) = tangent.transpose();
}

void Condenser::stiffen(int column, double stiffness) { At_(column, column) += stiffness; }

Eigen::Ref<Matrix> Condenser::tangent(int at, Eigen::Index size) { return At_.block(at, at, size, size); }

/// Nodes that turn with q turn the arms of their forces, too: adds the second derivatives of positions to the tangent.
void Condenser::turn(const System& system, const contact::Setup& setup, const Vector& force, const Reduction& reduction,
                     const Window& window, const Vector& q) {
  turned_.resize(system.bodies.size());
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const bool turns = !std::holds_alternative<body::LinearBody>(system.bodies[b]);
    const auto count = turns ? body::contact_nodes(system.bodies[b]).size() : 0;
    turned_[b].assign(count, Vec2::Zero());
  }
  Eigen::Index k = 0;
  for (const auto* nodes : {&setup.secondary_nodes, &setup.primary_nodes})
    for (const auto& node : *nodes) {
      if (!turned_[node.body].empty())
        turned_[node.body][static_cast<std::size_t>(node.contact_node)] += force.segment<2>(k);
      k += 2;
    }
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const int at = reduction.first(static_cast<int>(b)), column = window.first(static_cast<int>(b));
    if (const auto* rigid = std::get_if<body::RigidBody>(&system.bodies[b]))
      At_(column + 2, column + 2) += rigid->geometric(q.segment(at, rigid->dofs()), turned_[b]);
    const auto* nonlinear = std::get_if<body::NonlinearBody>(&system.bodies[b]);
    if (!nonlinear) continue;
    const Vector diagonal = nonlinear->geometric(q.segment(at, nonlinear->dofs()), turned_[b]);
    for (int k = 0; k < nonlinear->dofs(); ++k) {
      if (diagonal[k] == 0.0) continue;
      const int own = inside(window.index(at + k));  // a column of a support
      At_(own, own) += diagonal[k];
    }
  }
}

/// For linear bodies that turn the columns of the nodes themselves turn.
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

void Condenser::add_contact(const System& system, int contact, const contact::Interface& face,
                            const std::vector<PlacedNode>& nodes, const std::vector<Vec2>& lambda,
                            const Reduction& reduction, const Window& window, const Vector& q) {
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
