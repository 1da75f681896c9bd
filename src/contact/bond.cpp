#include <cmath>

#include "contact/interface.hpp"

/// Bonds: each node stays on the point it lies opposite to on X, whose D and M never change.     [README (9)]
namespace reye::contact {

/// The secondary facet with which a node's drawn offset turns.
mortar::LineFacet Interface::carrier(int node) const {
  const auto& s = setup_->secondary;
  return s.facets[s.before[node] >= 0 ? s.before[node] : s.after[node]];
}

/// The offset of a node as drawn, turned like its facet.
Vec2 Interface::turned_offset(int node) const {
  const auto facet = carrier(node);
  const Vec2 before = setup_->secondary.X[facet[1]] - setup_->secondary.X[facet[0]];
  const Vec2 now = placement_.xs[facet[1]] - placement_.xs[facet[0]];
  const double scale = before.norm() * now.norm(), c = before.dot(now) / scale, s = base::cross(before, now) / scale;
  const Vec2& g = drawn_offset_[node];
  return {c * g.x() - s * g.y(), s * g.x() + c * g.y()};
}

/// The directions along which a node stays on the point opposite to it. Where supports hold both along one direction,
/// only across it: along that direction the bond has no force to carry.
std::array<Vec2, 2> Interface::directions(int node) const {
  const Vec2& first = decision_.unmoved[node] ? setup_->freedom[node].direction : at_.normal[node];
  return {first, Vec2(-first.y(), first.x())};
}

void Interface::integrate_bond(const Points& xs, const Points& xm) {
  if (drawn_offset_.empty()) {
    placement_.xs = setup_->secondary.X;
    placement_.xm = setup_->primary.X;
    integrate_here();
    drawn_offset_ = at_.offset;
  }
  placement_.xs = xs;
  placement_.xm = xm;
  for (std::size_t j = 0; j < at_.rows.size(); ++j) {
    at_.offset[j].setZero();
    for (const auto& [k, share] : at_.rows[j].off) at_.offset[j] += share * (xs[k] - xs[j]);
    for (const auto& [l, M] : at_.rows[j].M) at_.offset[j] += M * (xs[j] - xm[l]);
  }
  sum_start_of_increment();
}

void Interface::evaluate_bond(const std::vector<Vec2>& lambda) {
  for (std::size_t j = 0; j < at_.rows.size(); ++j) {
    const int node = static_cast<int>(j);
    auto& c = condition_[j] = {};
    if (!active(node)) continue;
    const Vec2 apart = at_.offset[j] - turned_offset(node), n = at_.normal[j], tangent(-n.y(), n.x());
    const auto [first, second] = directions(node);
    c.normal = apart.dot(first);
    c.tangential = decision_.unmoved[j] ? lambda[j].dot(second) : apart.dot(second);
    c.lambda_n = lambda[j].dot(n);
    c.lambda_t = lambda[j].dot(tangent);
  }
}

void Interface::linearise_bond(Linearised& out) const {
  const int shift = placement_.secondary_dofs();
  for (std::size_t j = 0; j < at_.rows.size(); ++j) {
    const int node = static_cast<int>(j);
    if (!active(node)) continue;
    const auto facet = carrier(node);
    const Vec2 chord = placement_.xs[facet[1]] - placement_.xs[facet[0]], drawn = turned_offset(node);
    const Vec2 turn = Vec2(-chord.y(), chord.x()) / chord.squaredNorm(), swing(-drawn.y(), drawn.x());
    const auto [first, second] = directions(node);
    for (int t = 0; t < 2; ++t) {
      const Vec2& d = t == 0 ? first : second;
      const auto push = [&](int column, const Vec2& slope) {
        for (int i = 0; i < 2; ++i)
          if (slope[i] != 0.0) out.rows.push_back({2 * node + t, column + i, slope[i]});
      };
      if (t == 1 && decision_.unmoved[j]) {
        push(placement_.dofs() + 2 * node, d);
        continue;
      }
      double own = 0.0;
      for (const auto& [k, share] : at_.rows[j].off) {
        own -= share;
        push(2 * k, share * d);
      }
      for (const auto& [l, M] : at_.rows[j].M) {
        own += M;
        push(shift + 2 * l, -M * d);
      }
      push(2 * node, own * d);
      push(2 * facet[1], -d.dot(swing) * turn);
      push(2 * facet[0], d.dot(swing) * turn);
    }
  }
}

}  // namespace reye::contact
