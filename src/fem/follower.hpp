#pragma once
#include <vector>

#include "base/analysis.hpp"
#include "fem/loaded_edges.hpp"
#include "fem/pattern.hpp"

namespace reye::fem {

/// The pressure of a load on the deformed boundary x = X + u, over the part of it that the load covers on X:
///   f = - int p N n da,  n da = right_of(dx/dxi) dxi (times 2 pi r, r of x)
/// In plane stress the thickness stays that on X.
class FollowerPressure {
 public:
  /// Errors as `load_vector`.
  FollowerPressure(const mesh::Mesh& mesh, base::Analysis analysis, const BoundaryLoad& load);

  void add_force(double factor, const mesh::Mesh& mesh, const base::Vector& u, base::Vector& f) const;
  /// factor * df/du into K, made by `pattern`.
  void add_tangent(double factor, const mesh::Mesh& mesh, const base::Vector& u, const Pattern& pattern,
                   base::SparseMatrix& K) const;

 private:
  base::Analysis analysis_;
  double pressure_;
  std::vector<LoadedEdge> edges_;
};

}  // namespace reye::fem
