#include "solver/newton.hpp"

#include <cmath>
#include <limits>

#include "algebra/factor.hpp"
#include "base/errors.hpp"

namespace reye::solver {

using contact::ContactStatus;

namespace {

/// Largest diagonal entry of the bodies' tangents [N/mm].
double stiffness_scale(const System& system, const Vector& q) {
  double largest = 0.0;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const Vector part = system.part(q, static_cast<int>(b));
    std::visit([&](const auto& o) { if (o.dofs() > 0) largest = std::max(largest, o.tangent(part).diagonal().maxCoeff()); },
               system.bodies[b]);
  }
  return largest;
}

}  // namespace

void Newton::begin(const System& system, const SolverState& before, const Controls& controls) {
  const auto n = system.contacts.size();
  interfaces_.resize(n);
  linearised_.resize(n);
  elimination_.resize(n);
  nodes_.resize(n);
  lambda_.resize(n);
  for (std::size_t c = 0; c < n; ++c) {
    const auto& setup = system.contacts[c];
    auto sides = positions(system, setup, before.q);
    interfaces_[c].begin(setup, before.contacts[c], std::move(sides.secondary), std::move(sides.primary), controls.contacts[c]);
    lambda_[c] = before.contacts[c].lambda;
  }
}

/// Positions of all surface nodes with their derivatives, and the mortar integrals there.
void Newton::place(const System& system, const Vector& q) {
  std::vector<Vector> parts;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) parts.emplace_back(system.part(q, static_cast<int>(b)));
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    auto& nodes = nodes_[c];
    nodes.clear();
    Sides sides;
    const auto add = [&](const contact::SurfaceNode& node, Points& x) {
      nodes.push_back({std::visit([&](const auto& b) { return b.position(node.contact_node, parts[node.body]); },
                                  system.bodies[node.body]),
                       system.offset[node.body]});
      x.push_back(nodes.back().position.x);
    };
    for (const auto& node : setup.secondary_nodes) add(node, sides.secondary);
    for (const auto& node : setup.primary_nodes) add(node, sides.primary);
    interfaces_[c].integrate(sides.secondary, sides.primary);
  }
}

/// Evaluates conditions and balance at (q, lambda); structural_ is left as the bodies' residual without contact.
Iteration Newton::measure(const System& system, const Controls& controls, const Vector& q) {
  Iteration row;
  structural_.setZero(system.dofs);
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const Vector part = system.part(q, static_cast<int>(b));
    structural_.segment(system.offset[b], part.size()) =
        std::visit([&](const auto& o) { return o.residual(part, controls.load_factors[b]); }, system.bodies[b]);
  }
  for (const auto& [column, force] : controls.forces) structural_[column] -= force;
  const double stiffness = stiffness_scale(system, q);
  Vector balance = structural_;
  double largest = structural_.lpNorm<Eigen::Infinity>(), multiplier = 0.0, unmet = 0.0;
  for (std::size_t c = 0; c < interfaces_.size(); ++c) {
    auto& face = interfaces_[c];
    face.evaluate(lambda_[c]);
    const Vector f = face.forces(lambda_[c]);
    for (std::size_t k = 0; k < nodes_[c].size(); ++k)
      for (int t = 0; t < nodes_[c][k].position.count; ++t) {
        const auto& term = nodes_[c][k].position.terms[t];
        balance[nodes_[c][k].shift + term.column] += term.direction.dot(f.segment<2>(2 * static_cast<int>(k)));
      }
    if (f.size() > 0) largest = std::max(largest, f.lpNorm<Eigen::Infinity>());
    for (std::size_t j = 0; j < lambda_[c].size(); ++j) {
      if (!face.active(static_cast<int>(j))) continue;
      const int node = static_cast<int>(j);
      multiplier = std::max(multiplier, lambda_[c][j].norm());
      const double traction = face.setup().stiffness[j] / face.rows()[j].D;
      // What rounding of positions leaves of a gap can not be asked to vanish.
      const double floor = 64.0 * std::numeric_limits<double>::epsilon() * nodes_[c][j].position.x.norm() * face.rows()[j].D;
      const auto excess = [floor](double residual) { return std::max(0.0, std::abs(residual) - floor); };
      const bool traction_row = face.status()[j] == ContactStatus::slip || controls.contacts[c].held;
      unmet = std::max(unmet, traction * excess(face.residual_normal(node)));
      if (face.setup().freedom[j].free == 2)
        unmet = std::max(unmet, traction_row ? std::abs(face.residual_tangential(node))
                                             : traction * excess(face.residual_tangential(node)));
    }
  }
  for (const auto& [column, value] : controls.prescribed) balance[column] = 0.0;
  const double tiny = std::numeric_limits<double>::min();
  const double unbalanced = balance.size() ? balance.lpNorm<Eigen::Infinity>() : 0.0;
  // Rounding of S q under rigid motion is no force.
  const double rounding = 1e-13 * stiffness * (q.size() ? q.lpNorm<Eigen::Infinity>() : 0.0);
  row.force = std::max(0.0, unbalanced - rounding) / std::max(largest, tiny);
  row.condition = unmet / std::max(multiplier, tiny);
  if (multiplier == 0.0 && unmet == 0.0) row.condition = 0.0;
  return row;
}

void Newton::assemble(const System& system, const Controls& controls, const Vector& q) {
  At_.setZero(system.dofs, system.dofs);
  b_ = -structural_;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const Vector part = system.part(q, static_cast<int>(b));
    const int n = static_cast<int>(part.size()), at = system.offset[b];
    std::visit([&](const auto& o) { At_.block(at, at, n, n) = o.tangent(part, controls.load_factors[b]).transpose(); },
               system.bodies[b]);
  }
  for (std::size_t c = 0; c < system.contacts.size(); ++c) add_contact_tangent(system, static_cast<int>(c), q);
  for (int c : system.elimination) eliminate(system, c, q);
}

void Newton::add_contact_tangent(const System& system, int contact, const Vector& q) {
  auto& face = interfaces_[contact];
  auto& lin = linearised_[contact];
  const auto& nodes = nodes_[contact];
  face.linearise(lambda_[contact], lin);
  for (const auto& e : lin.force) {
    const auto &row = nodes[e.row / 2], &col = nodes[e.col / 2];
    for (int r = 0; r < row.position.count; ++r)
      for (int k = 0; k < col.position.count; ++k)
        At_(col.shift + col.position.terms[k].column, row.shift + row.position.terms[r].column) +=
            e.value * row.position.terms[r].direction[e.row % 2] * col.position.terms[k].direction[e.col % 2];
  }
  const Vector f = face.forces(lambda_[contact]);
  const auto& setup = system.contacts[contact];
  const auto turn = [&](const contact::SurfaceNode& node, int k) {
    if (!std::holds_alternative<body::RigidBody>(system.bodies[node.body])) return;
    const auto& rigid = std::get<body::RigidBody>(system.bodies[node.body]);
    std::vector<Vec2> forces(rigid.contact_nodes().size(), Vec2::Zero());
    forces[node.contact_node] = f.segment<2>(2 * k);
    const int theta = system.offset[node.body] + 2;
    At_(theta, theta) += rigid.geometric(system.part(q, node.body), forces);
  };
  for (int j = 0; j < setup.secondary_count(); ++j) turn(setup.secondary_nodes[j], j);
  for (int l = 0; l < setup.primary_count(); ++l) turn(setup.primary_nodes[l], setup.secondary_count() + l);
}

/// lambda = constant + slope dq from the balance of each active secondary node (D is diagonal); into the
/// rows it loads, and the node's own rows become its conditions.
void Newton::eliminate(const System& system, int contact, const Vector&) {
  auto& face = interfaces_[contact];
  auto& elim = elimination_[contact];
  const auto& nodes = nodes_[contact];
  const auto& setup = system.contacts[contact];
  const int ns = setup.secondary_count();
  elim.place.assign(ns, -1);
  int count = 0;
  for (int j = 0; j < ns; ++j)
    if (face.active(j)) {
      elim.place[j] = count;
      count += 2;
    }
  elim.slope.setZero(system.dofs, count);
  elim.constant.setZero(count);
  for (int j = 0; j < ns; ++j) {
    if (elim.place[j] < 0) continue;
    const double D = face.rows()[j].D;
    const int first = nodes[j].position.count - setup.freedom[j].free;  // a node's free columns come last
    for (int t = first; t < nodes[j].position.count; ++t) {
      const auto& term = nodes[j].position.terms[t];
      const int row = nodes[j].shift + term.column;
      for (int c = 0; c < 2; ++c) {
        if (term.direction[c] == 0.0) continue;
        elim.slope.col(elim.place[j] + c) -= term.direction[c] / D * At_.col(row);
        elim.constant[elim.place[j] + c] += term.direction[c] / D * b_[row];
      }
    }
  }
  const auto load = [&](const Node& node, int from, double factor) {
    for (int t = 0; t < node.position.count; ++t)
      for (int c = 0; c < 2; ++c) {
        const double weight = factor * node.position.terms[t].direction[c];
        if (weight == 0.0) continue;
        const int row = node.shift + node.position.terms[t].column;
        At_.col(row) += weight * elim.slope.col(from + c);
        b_[row] -= weight * elim.constant[from + c];
      }
  };
  for (int j = 0; j < ns; ++j) {
    if (elim.place[j] < 0) continue;
    const auto& row = face.rows()[j];
    if (row.off_node >= 0) load(nodes[row.off_node], elim.place[j], row.off);
    for (const auto& [l, M] : row.M) load(nodes[ns + l], elim.place[j], -M);
  }
  // Conditions replace the rows of the node's free columns, scaled to the stiffness of their surroundings.
  std::vector<int> target(2 * static_cast<std::size_t>(ns), -1);
  std::vector<double> scale(2 * static_cast<std::size_t>(ns), 0.0);
  for (int j = 0; j < ns; ++j) {
    if (elim.place[j] < 0) continue;
    const bool traction_row = face.status()[j] == ContactStatus::slip || face.held();
    const int first = nodes[j].position.count - setup.freedom[j].free;
    for (int t = 0; t < setup.freedom[j].free; ++t) {
      const int row = nodes[j].shift + nodes[j].position.terms[first + t].column;
      target[2 * j + t] = row;
      scale[2 * j + t] = t == 1 && traction_row ? face.rows()[j].D : setup.stiffness[j];
      At_.col(row).setZero();
      b_[row] = -scale[2 * j + t] * (t == 0 ? face.residual_normal(j) : face.residual_tangential(j));
    }
  }
  const int multipliers = face.dofs();
  for (const auto& e : linearised_[contact].rows) {
    const int row = target[e.row];
    if (row < 0) continue;
    const double value = scale[e.row] * e.value;
    if (e.col >= multipliers) {
      const int j = (e.col - multipliers) / 2, c = (e.col - multipliers) % 2;
      At_.col(row) += value * elim.slope.col(elim.place[j] + c);
      b_[row] -= value * (elim.constant[elim.place[j] + c] - lambda_[contact][j][c]);
    } else {
      const auto& node = nodes[e.col / 2];
      for (int t = 0; t < node.position.count; ++t)
        At_(node.shift + node.position.terms[t].column, row) += value * node.position.terms[t].direction[e.col % 2];
    }
  }
}

void Newton::fix(const Controls& controls) {
  for (const auto& [column, value] : controls.prescribed) {
    At_.col(column).setZero();
    At_(column, column) = 1.0;
    b_[column] = 0.0;
  }
}

void Newton::recover(int contact, const Vector& dq) {
  const auto& elim = elimination_[contact];
  const Vector lambda = elim.constant + elim.slope.transpose() * dq;
  for (std::size_t j = 0; j < lambda_[contact].size(); ++j)
    lambda_[contact][j] = elim.place[j] < 0 ? Vec2::Zero() : Vec2(lambda.segment<2>(elim.place[j]));
}

SolveResult Newton::solve(const System& system, const SolverState& before, const Controls& controls) {
  SolveResult result;
  auto& report = result.report;
  Vector q = before.q;
  for (const auto& [column, value] : controls.prescribed) q[column] = value;
  begin(system, before, controls);
  for (int iteration = 0; iteration <= options_.max_iterations; ++iteration) {
    place(system, q);
    int changes = 0;
    for (std::size_t c = 0; c < interfaces_.size(); ++c) {
      const auto last = interfaces_[c].status();
      interfaces_[c].decide(lambda_[c], iteration);
      for (std::size_t j = 0; j < last.size(); ++j) {
        changes += last[j] != interfaces_[c].status()[j];
        if (!interfaces_[c].active(static_cast<int>(j))) lambda_[c][j].setZero();
      }
    }
    Iteration row = measure(system, controls, q);
    row.changes = changes;
    report.table.push_back(row);
    if (!std::isfinite(row.force) || !std::isfinite(row.condition)) {
      report.reason = "the residual is not finite after " + std::to_string(iteration) + " iterations";
      return result;
    }
    if (iteration > 0 && changes == 0 && row.force < options_.force_tolerance && row.condition < options_.condition_tolerance) {
      report.converged = true;
      result.state.q = q;
      for (std::size_t c = 0; c < interfaces_.size(); ++c) result.state.contacts.push_back(interfaces_[c].accepted(lambda_[c]));
      return result;
    }
    if (iteration == options_.max_iterations) break;
    try {
      assemble(system, controls, q);
      fix(controls);
      const Vector dq = algebra::solve_dense_transposed(At_, b_);
      ++report.solves;
      for (std::size_t c = 0; c < interfaces_.size(); ++c) recover(static_cast<int>(c), dq);
      q += dq;
    } catch (const base::SolveError& error) {
      report.reason = error.what();
      return result;
    }
  }
  const auto& last = report.table.back();
  report.reason = "no convergence in " + std::to_string(options_.max_iterations) + " iterations: unbalanced force " +
                  std::to_string(last.force) + ", unmet condition " + std::to_string(last.condition) + " (relative), " +
                  std::to_string(last.changes) + " nodes still change status";
  return result;
}

}  // namespace reye::solver
