#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/records.hpp"

/// Bodies that lie inside one another where no contact of the scene keeps them apart.
namespace reye::sim {

struct Overlap {
  int body = 0, other = 0;
  base::Vec2 at{0.0, 0.0};  ///< the node of `body` that lies deepest
  double depth_mm = 0.0;
};

/// The deepest place of each pair of bodies with displacements u (per body and node; an empty list: none). Less than a
/// twentieth of a facet is not counted: outlines of facets do so where drawn curves touch.
std::vector<Overlap> overlaps(const Problem& problem, const std::vector<body::ShapePtr>& shapes,
                              const std::vector<std::vector<base::Vec2>>& u);

/// Overlaps of bodies as warnings.
std::vector<Warning> overlap_warnings(const Problem& problem, const std::vector<body::ShapePtr>& shapes,
                                      const std::vector<std::vector<base::Vec2>>& u);

}  // namespace reye::sim
