#include "mesh/place.hpp"

#include <limits>

#include "mesh/measure.hpp"

namespace reye::mesh {

Place place_of(const Mesh& mesh, const Vec2& point) {
  Place place;
  place.distance = std::numeric_limits<double>::infinity();
  for (const auto& loop : mesh.outline)
    for (std::size_t k = 1; k < loop.size(); ++k) {
      const Vec2 &a = mesh.X[loop[k - 1]], &b = mesh.X[loop[k]], e = b - a, r = point - a;
      if ((a.y() > point.y()) != (b.y() > point.y()) && point.x() < a.x() + e.x() * r.y() / e.y())
        place.inside = !place.inside;
      const Vec2 foot = a + nearest_parameter(a, b, point) * e;
      if (const double distance = (point - foot).norm(); distance < place.distance) {
        place.nearest = foot;
        place.distance = distance;
        place.facet = e.norm();
      }
    }
  return place;
}

}  // namespace reye::mesh
