#include <Eigen/LU>
#include <algorithm>
#include <unordered_map>

#include "body/columns.hpp"
#include "body/operator.hpp"
#include "body/turning.hpp"

namespace reye::body {

void set_free(const std::vector<Term>& free, const Vec2& rest, Vector& values) {
  if (free.size() == 1) values[free[0].column] = rest.dot(free[0].direction) / free[0].direction.squaredNorm();
  if (free.size() != 2) return;
  Eigen::Matrix2d directions;
  directions << free[0].direction, free[1].direction;
  const Vec2 both = directions.inverse() * rest;
  values[free[0].column] = both.x();
  values[free[1].column] = both.y();
}

namespace {

/// Displacements of the contact nodes, with control points in place of mid nodes.
std::vector<Vec2> seen_by_contact(const LinearBody& body, const std::vector<Vec2>& u) {
  std::unordered_map<int, int> place;
  for (std::size_t k = 0; k < u.size(); ++k) place[body.contact_nodes()[k]] = static_cast<int>(k);
  std::vector<mesh::LineFacet> facets;
  for (const auto& [a, b, mid] : body.curved_edges()) facets.push_back({place[a], place[b], place[mid]});
  return mesh::control_points(facets, u);
}

}  // namespace

void seat(const LinearBody& body, const std::vector<Vec2>& u, Vector& q) {
  const auto& supports = body.support_columns();
  const auto held = [&](int column) {
    return std::any_of(supports.begin(), supports.end(), [&](const auto& s) { return s.column == column; });
  };
  const base::Points seen = seen_by_contact(body, u);
  const Eigen::Matrix2d R = rotation(body.angle(q));
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const NodePosition node = body.position(ContactIndex(k), q);
    Vec2 rest = body.turning() ? Vec2(R * seen[k]) : seen[k];
    std::vector<Term> free;
    for (int t = 0; t < node.count; ++t) {
      const Term& term = node.terms[t];
      if (held(term.column))
        rest -= q[term.column] * term.direction;
      else
        free.push_back(term);
    }
    set_free(free, rest, q);
  }
}

}  // namespace reye::body
