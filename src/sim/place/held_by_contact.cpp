#include "sim/place/held_by_contact.hpp"

#include <algorithm>

#include "mesh/measure.hpp"

namespace reye::sim {

namespace {

constexpr double near_enough = 0.05;  ///< of a facet
constexpr double pressing = 0.05;     ///< of the motion of a node, along its normal

using EdgeEnds = std::array<Vec2, 2>;

/// The facets of one side on one body.
std::vector<EdgeEnds> facet_ends(const Problem& problem, const contact::BoundaryRef& ref) {
  std::vector<EdgeEnds> facets;
  const auto& mesh = problem.shapes[ref.body]->mesh;
  for (const auto& chain : mesh.boundaries.at(ref.boundary))
    for (std::size_t i = 1; i < chain.size(); ++i) facets.push_back({mesh.X[chain[i - 1]], mesh.X[chain[i]]});
  return facets;
}

/// Whether an end x of a facet lies on a facet opposite to it.
bool meets_facet(const EdgeEnds& own, const Vec2& x, const std::vector<EdgeEnds>& opposite) {
  const double length = (own[1] - own[0]).norm();
  return std::any_of(opposite.begin(), opposite.end(), [&](const EdgeEnds& f) {
    return (f[1] - f[0]).dot(own[1] - own[0]) < 0.0 && mesh::distance_to_edge(f[0], f[1], x) <= near_enough * length;
  });
}

/// Unit vector along which a motion of a body takes a point; zero at the centre of a rotation.
Vec2 way_of_motion(const std::string& motion, const Vec2& arm) {
  const Vec2 way = motion == "translation along x"   ? Vec2(1.0, 0.0)
                   : motion == "translation along y" ? Vec2(0.0, 1.0)
                                                     : Vec2(-arm.y(), arm.x());
  return way.norm() > 0.0 ? way.normalized() : way;
}

/// The largest closing (> 0) and opening (< 0) of a touching contact by the motion.
void look(const Problem& problem, const contact::BoundaryRef& own, const contact::BoundaryRef& other,
          const std::string& motion, double& most, double& least) {
  const Vec2 centre = problem.inputs[own.body].centre;
  const auto opposite = facet_ends(problem, other);
  for (const auto& facet : facet_ends(problem, own)) {
    const Vec2 normal = mesh::outward_normal(facet[0], facet[1]);
    for (const Vec2& x : facet) {
      if (!meets_facet(facet, x, opposite)) continue;
      const Vec2 way = way_of_motion(motion, x - centre);
      most = std::max(most, normal.dot(way));
      least = std::min(least, normal.dot(way));
    }
  }
}

}  // namespace

bool held_by_contact(const Problem& problem, int body, const std::string& motion) {
  double most = 0.0, least = 0.0;
  for (const auto& contact : problem.contacts)
    for (const auto& ref : contact.primary) {
      if (contact.secondary.body == body) look(problem, contact.secondary, ref, motion, most, least);
      if (ref.body == body) look(problem, ref, contact.secondary, motion, most, least);
    }
  return most > pressing && least < -pressing;
}

}  // namespace reye::sim
