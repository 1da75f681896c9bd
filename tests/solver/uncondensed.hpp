#pragma once
#include <Eigen/LU>

#include "algebra/factor.hpp"
#include "solver/mobility.hpp"
#include "solver/newton.hpp"

/// The oracle of the condensed solver: the same semi-smooth Newton on the whole saddle-point system, unknowns
/// all q and all multipliers, written down block by block.
namespace reye::support {

using base::Matrix;
using base::Vec2;
using base::Vector;

class Uncondensed {
 public:
  Uncondensed(const solver::System& system, const solver::SolverState& before, const solver::Controls& controls)
      : q(before.q.high), system_(system), controls_(controls), faces_(system.contacts.size()) {
    for (const auto& [column, value] : controls.prescribed) q[column] = value;
    for (std::size_t c = 0; c < faces_.size(); ++c) {
      const auto sides = solver::positions(system, system.contacts[c], before.q.high);
      faces_[c].begin(system.contacts[c], before.contacts[c], sides.secondary, sides.primary, controls.contacts[c]);
      faces_[c].hold(solver::mobility(system, system.contacts[c], before.q.high, controls));
      lambda.push_back(before.contacts[c].lambda);
      first_.push_back(size_);
      size_ += 2 * static_cast<int>(lambda[c].size());
    }
  }

  /// Decides and takes one Newton step.
  void step(int iteration) {
    decide(iteration);
    assemble();
    const Vector d = algebra::solve_dense(A_, b_);
    q += d.head(system_.dofs);
    for (std::size_t c = 0; c < faces_.size(); ++c)
      for (std::size_t j = 0; j < lambda[c].size(); ++j)
        lambda[c][j] += d.segment<2>(system_.dofs + first_[c] + 2 * static_cast<int>(j));
  }

  /// Active set at the present state; multipliers of inactive nodes vanish.
  void decide(int iteration) {
    for (std::size_t c = 0; c < faces_.size(); ++c) {
      const auto sides = solver::positions(system_, system_.contacts[c], q);
      faces_[c].integrate(sides.secondary, sides.primary);
      faces_[c].decide(lambda[c], iteration);
      for (std::size_t j = 0; j < lambda[c].size(); ++j)
        if (!faces_[c].active(static_cast<int>(j))) lambda[c][j].setZero();
    }
  }

  Vector q;
  std::vector<std::vector<Vec2>> lambda;

 private:
  void assemble() {
    const int n = system_.dofs + size_;
    A_.setZero(n, n);
    b_.setZero(n);
    for (std::size_t b = 0; b < system_.bodies.size(); ++b) add_body(static_cast<int>(b));
    for (const auto& [column, force] : controls_.forces) b_[column] += force;
    for (std::size_t c = 0; c < faces_.size(); ++c) add_contact(static_cast<int>(c));
    for (const auto& [column, value] : controls_.prescribed) {
      A_.row(column).setZero();
      A_(column, column) = 1.0;
      b_[column] = 0.0;
    }
  }

  void add_body(int b) {
    const Vector part = system_.part(q, b);
    const auto n = part.size();
    const int at = system_.offset[b];
    const auto add = [&](const auto& o) {
      A_.block(at, at, n, n) += o.tangent(part, controls_.load_factors[b]);
      b_.segment(at, n) -= o.residual(part, controls_.load_factors[b]);
    };
    if (const auto* rigid = std::get_if<body::RigidBody>(&system_.bodies[b]))
      add(*rigid);
    else
      add(std::get<body::LinearBody>(system_.bodies[b]));
  }

  const contact::SurfaceNode& node(const contact::Setup& setup, int k) const {
    const int ns = setup.secondary_count();
    return k < ns ? setup.secondary_nodes[k] : setup.primary_nodes[k - ns];
  }

  /// dx/dq of the surface dofs; `forces`: what their forces do work on.
  Matrix motion(const contact::Setup& setup, int dofs, bool forces) const {
    Matrix G = Matrix::Zero(dofs, system_.dofs);
    for (int k = 0; k < dofs / 2; ++k) {
      const auto& at = node(setup, k);
      const auto p =
          std::visit([&](const auto& o) { return o.position(at.contact_node, Vector(system_.part(q, at.body))); },
                     system_.bodies[at.body]);
      for (int t = 0; t < p.count; ++t)
        G.block<2, 1>(2 * k, system_.offset[at.body] + p.terms[t].column) += p.terms[t].direction;
      if (!forces && p.angle >= 0) G.block<2, 1>(2 * k, system_.offset[at.body] + p.angle) += p.swing;
    }
    return G;
  }

  void add_contact(int c) {
    auto& face = faces_[c];
    const auto& setup = system_.contacts[c];
    face.evaluate(lambda[c]);
    contact::Linearised lin;
    face.linearise(lambda[c], lin);
    const Matrix G = motion(setup, face.dofs(), false), L = motion(setup, face.dofs(), true);
    const int first = system_.dofs + first_[c], n = system_.dofs, multipliers = 2 * setup.secondary_count();
    Matrix F = Matrix::Zero(face.dofs(), face.dofs()), C(face.dofs(), multipliers);
    Matrix R = Matrix::Zero(multipliers, face.dofs() + multipliers);
    for (const auto& e : lin.force) F(e.row, e.col) += e.value;
    for (const auto& e : lin.rows) R(e.row, e.col) += e.value;
    for (int i = 0; i < multipliers; ++i) {
      std::vector<Vec2> unit(lambda[c].size(), Vec2::Zero());
      unit[i / 2][i % 2] = 1.0;
      C.col(i) = face.forces(unit);
    }
    const Vector f = face.forces(lambda[c]);
    A_.topLeftCorner(n, n) += L.transpose() * F * G;
    A_.block(0, first, n, multipliers) = L.transpose() * C;
    b_.head(n) -= L.transpose() * f;
    A_.block(first, 0, multipliers, n) = R.leftCols(face.dofs()) * G;
    A_.block(first, first, multipliers, multipliers) = R.rightCols(multipliers);
    for (int j = 0; j < setup.secondary_count(); ++j) close_rows(face, c, j, first + 2 * j);
    for (int k = 0; k < face.dofs() / 2; ++k) turn(node(setup, k), f.segment<2>(2 * k));
  }

  /// Residuals of an active node; else lambda = 0.
  void close_rows(const contact::Interface& face, int c, int j, int row) {
    const auto alone = [&](int r, const Vec2& direction) {
      A_.row(r).setZero();
      A_.block<1, 2>(r, row) = direction.transpose();
      b_[r] = -direction.dot(lambda[c][j]);
    };
    if (!face.active(j)) {
      alone(row, {1, 0});
      alone(row + 1, {0, 1});
      return;
    }
    b_[row] = -face.residual_normal(j);
    b_[row + 1] = -face.residual_tangential(j);
  }

  /// Second derivative of positions of bodies that turn under contact forces.
  void turn(const contact::SurfaceNode& at, const Vec2& force) {
    if (const auto* linear = std::get_if<body::LinearBody>(&system_.bodies[at.body])) {
      const auto p = linear->position(at.contact_node, system_.part(q, at.body));
      const int first = system_.offset[at.body];
      for (int t = p.turned; p.angle >= 0 && t < p.count; ++t)
        A_(first + p.terms[t].column, first + p.angle) +=
            force.dot(Vec2(-p.terms[t].direction.y(), p.terms[t].direction.x()));
    }
    const auto* rigid = std::get_if<body::RigidBody>(&system_.bodies[at.body]);
    if (!rigid) return;
    std::vector<Vec2> forces(rigid->contact_nodes().size(), Vec2::Zero());
    forces[static_cast<std::size_t>(at.contact_node)] = force;
    const int theta = system_.offset[at.body] + 2;
    A_(theta, theta) += rigid->geometric(system_.part(q, at.body), forces);
  }

  const solver::System& system_;
  const solver::Controls& controls_;
  std::vector<contact::Interface> faces_;
  std::vector<int> first_;
  int size_ = 0;
  Matrix A_;
  Vector b_;
};

}  // namespace reye::support
