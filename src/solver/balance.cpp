#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/increment.hpp"

/// The unbalanced forces of an increment, and the part of them that is rounding.
namespace reye::solver {

namespace {

constexpr double tiny = std::numeric_limits<double>::min();
constexpr double nothing = 1e-30;  ///< of a stiffness times a length: imbalance that is ignored where nothing acts
constexpr double digits = 64.0 * std::numeric_limits<double>::epsilon();  ///< relative, of sums of many terms

double largest_of(const Vector& v) { return v.size() ? v.lpNorm<Eigen::Infinity>() : 0.0; }

/// The largest length in the sum that gives the position of a node, to which its rounding is relative. An angle loses
/// digits over many turns.
double extent_of(const PlacedNode& node, const Vector& q) {
  const double turned = node.angle < 0 ? 0.0 : std::abs(q[node.angle]) * node.position.swing.norm();
  return std::max(node.position.x.norm(), turned);
}

}  // namespace

/// Tangent of a deformable body on its reduced columns; empty for a rigid one.
const Matrix& Increment::stiffness(std::size_t body) const {
  const auto* tangent = nonlinear_.tangent(static_cast<int>(body));
  return tangent ? *tangent : reduction().stiffness(static_cast<int>(body));
}

/// Per deformable body its deformation v on the reduced columns, without the rounding of its rigid translation; of
/// nonlinear ones since the anchor.
std::vector<Vector> Increment::deformations(const System& system, const base::TwoPart& q) const {
  std::vector<Vector> v(system.bodies.size());
  for (std::size_t b = 0; b < v.size(); ++b) {
    const int body = static_cast<int>(b);
    if (std::holds_alternative<body::LinearBody>(system.bodies[b])) v[b] = reduction().deformation(body, q);
    if (nonlinear_.tangent(body)) v[b] = nonlinear_.deformation(body, q);
  }
  return v;
}

/// S' v - f' of all bodies on the reduced columns; of nonlinear ones r + S v.
Vector Increment::residual(const System& system, const Controls& controls, const base::TwoPart& q,
                           const std::vector<Vector>& v) const {
  Vector r = -loads_.forces;
  for (const auto& [column, stiffness, rest] : controls.springs) {
    const int at = reduction().index(column);
    r[at] += stiffness * (q.high[at] - rest + q.low[at]);
  }
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const int body = static_cast<int>(b), at = reduction().first(body);
    if (const auto* rigid = std::get_if<body::RigidBody>(&system.bodies[b])) {
      const Vector part = q.high.segment(at, rigid->dofs());
      r.segment(at, part.size()) += rigid->residual(part, controls.load_factors[b]);
    } else if (nonlinear_.tangent(body)) {
      nonlinear_.add_residual(body, v[b], r);
    } else if (const auto* turning = reduction().turning(body)) {
      const double angle = q.high[at + turning->angle];
      Vector own = reduction().stiffness(body) * v[b] - loads_.turning[b].at(angle);
      turning->to_axes(angle, own);
      r.segment(at, own.size()) += own;
    } else {
      r.segment(at, v[b].size()).noalias() += reduction().stiffness(body) * v[b];
    }
  }
  return r;
}

/// For a linear body S v is rounded, not S q, so that rigid motion adds no error; for a nonlinear one the stress of v
/// is.
Increment::Rounding Increment::rounding(const System& system, const base::TwoPart& q,
                                        const std::vector<Vector>& v) const {
  Rounding result;
  const double way = this->way(q.high);
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const int body = static_cast<int>(b);
    const Matrix& S = this->stiffness(b);
    if (S.size() == 0) continue;
    const auto arm = arm_.segment(reduction().first(body), S.rows());
    const double stiffness = S.diagonal().cwiseQuotient(arm.cwiseAbs2()).maxCoeff();
    double moved = largest_of(v[b].cwiseProduct(arm));
    if (nonlinear_.tangent(body)) moved = std::max(moved, nonlinear_.deformation(body));
    result.inside = std::max(result.inside, digits * stiffness * moved);
    result.scale = std::max({result.scale, digits * stiffness * way, nothing * stiffness * system.extent});
  }
  return result;
}

/// Balance and conditions at (q, lambda); balance_ keeps the unbalanced forces.
Iteration Increment::measure(const System& system, const Controls& controls, const base::TwoPart& q, bool fresh) {
  Iteration row;
  const auto v = deformations(system, q);
  balance_ = residual(system, controls, q, v);
  double largest = largest_of(balance_.cwiseQuotient(arm_)), multiplier = 0.0, unmet = 0.0;
  suspects_.unmet = {};
  for (std::size_t c = 0; c < lambda_.size(); ++c) {
    auto& face = contacts_.faces()[c];
    const auto& nodes = contacts_.nodes()[c];
    face.evaluate(lambda_[c]);
    const Vector f = face.forces(lambda_[c]);
    largest = std::max(largest, largest_of(f));
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (int t = 0; t < nodes[k].position.count; ++t)
        balance_[nodes[k].column[t]] += nodes[k].position.terms[t].direction.dot(f.segment<2>(2 * static_cast<int>(k)));
    for (std::size_t j = 0; j < lambda_[c].size(); ++j) {
      const int node = static_cast<int>(j);
      if (!face.active(node)) continue;
      multiplier = std::max({multiplier, lambda_[c][j].norm(), face.setup().faint});
      const double D = face.rows()[j].D, traction = face.setup().stiffness[j] / D;
      // The rounding error of positions in a gap cannot be required to vanish.
      const double rounding = digits * extent_of(nodes[j], q.high) * D;
      const auto overlap = [&](double r) { return traction * std::max(0.0, std::abs(r) - rounding); };
      const auto count = [&](double r) {
        if (r > unmet) suspects_.unmet = {static_cast<int>(c), node};
        unmet = std::max(unmet, r);
      };
      count(overlap(face.residual_normal(node)));
      const double r = face.residual_tangential(node);
      count(face.shear_is_given(node) ? std::abs(r) : overlap(r));
    }
  }
  for (const auto& [column, value] : controls.prescribed) balance_[reduction().index(column)] = 0.0;
  for (std::size_t b = 0; b < system.bodies.size(); ++b)
    if (const auto* turning = reduction().turning(static_cast<int>(b)); turning && !turning->chord.empty())
      balance_[reduction().first(static_cast<int>(b)) + turning->angle] =
          0.0;  // its balance is in that of the other columns
  const Rounding rounding = this->rounding(system, q, v);
  largest = std::max({largest, nonlinear_.force_scale(), rounding.scale});
  const double inside = fresh ? nonlinear_.inside_imbalance() : 0.0;
  Eigen::Index column = -1;
  const double outside = balance_.size() ? balance_.cwiseQuotient(arm_).cwiseAbs().maxCoeff(&column) : 0.0;
  suspects_.unbalanced = inside > outside ? -1 : static_cast<int>(column);
  row.force = std::max(0.0, std::max(outside, inside) - rounding.inside) / std::max(largest, tiny);
  // Nodes that have just closed carry no multiplier yet: an overlap without one is unmet, not infinite.
  row.condition = unmet == 0.0 ? 0.0 : unmet / std::max(multiplier, 1e-6 * unmet);
  return row;
}

}  // namespace reye::solver
