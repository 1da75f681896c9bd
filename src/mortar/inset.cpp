#include "mortar/inset.hpp"

#include <algorithm>

#include "mesh/measure.hpp"

namespace reye::mortar {

namespace {

/// Step that moves both facets at their common node outwards by one; at a cusp not longer than two.
Vec2 miter(const Vec2& n1, const Vec2& n2) { return (n1 + n2) / std::max(0.5, 1.0 + n1.dot(n2)); }

}  // namespace

Points inset(const Surface& s, const Points& x, double by) {
  Points moved = x;
  for (int k = 0; k < s.node_count(); ++k) {
    Vec2 way;
    if (s.is_control_point(k)) {
      const auto& [a, b, control] = s.facets[s.before[k]];
      way = miter(mesh::outward_normal(x[a], x[k]), mesh::outward_normal(x[k], x[b]));
    } else {
      const auto before = [&] { return mesh::outward_normal(x[s.beside(s.before[k], 1)], x[k]); };
      const auto after = [&] { return mesh::outward_normal(x[k], x[s.beside(s.after[k], 0)]); };
      way = s.before[k] < 0 ? after() : s.after[k] < 0 ? before() : miter(before(), after());
    }
    moved[k] -= by * way;
  }
  return moved;
}

}  // namespace reye::mortar
