#pragma once
#include <map>
#include <memory>
#include <mutex>

#include "mesh/mesh.hpp"

namespace reye::adapt {

using base::Points;

/// Carries a motion of the outline into the interior of the mesh a shape was born on.
/// Energy: sum over cells of 1/area int |Grad v|^2, an elastic body that is stiff where its cells are small, so
/// that small cells move nearly rigidly and large ones give way; both components share one factor.
/// In second order it is that of the vertices, and inner middle nodes follow the ends of their edges by halves.
/// (README, 4)
class InteriorMotion {
 public:
  explicit InteriorMotion(const mesh::Mesh& born);
  ~InteriorMotion();

  /// Displacement of every node for displacements given on the outline and at the vertices of points (values at other
  /// inner nodes are not read).
  /// The result is linear in them and has no memory: the places of inner nodes depend on the outline alone.
  Points extend(Points displacement) const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

/// Factors kept between shape steps, one for each living mesh of birth. Throwing it away changes no bit.
/// Safe to share between threads.
class RelocationCache {
 public:
  std::shared_ptr<const InteriorMotion> of(const std::shared_ptr<const mesh::Mesh>& born);

 private:
  struct Entry {
    std::weak_ptr<const mesh::Mesh> born;
    std::shared_ptr<const InteriorMotion> motion;
  };
  std::mutex mutex_;
  std::map<const mesh::Mesh*, Entry> entries_;
};

/// Moves the inner nodes after the outline, with displacements counted from the mesh of birth. Without `cache` the
/// result is the same to the last bit.
void relocate(mesh::Mesh& mesh, const std::shared_ptr<const mesh::Mesh>& born, RelocationCache* cache);

}  // namespace reye::adapt
