#pragma once
#include <memory>
#include <vector>

#include "base/linalg.hpp"
#include "base/space.hpp"

namespace reye::adapt {

using base::Points3;

/// A motion given at some nodes, carried to others so that an energy 1/2 v^T k v is smallest. One scalar factor, made
/// when first needed, serves the three components and every further motion. Safe to share between threads.
class HarmonicExtension {
 public:
  /// `free`: per node, whether it is to be moved. `height`: per node, a length [mm]. `k`: rows and columns of nodes,
  /// both triangles; rows of nodes that are not free are not read.
  HarmonicExtension(const std::vector<char>& free, const std::vector<double>& height,
                    const std::vector<base::Triplet>& k);
  ~HarmonicExtension();

  /// How far a motion is from rest: the largest correction of a free node by one step of Jacobi's method, over its
  /// height.
  double unrest(const Points3& motion) const;

  /// Sets the motion of the free nodes by that of the others.
  void extend(Points3& motion) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace reye::adapt
