#pragma once
#include <cstdint>
#include <memory>
#include <mutex>

#include "adapt/solid/harmonic.hpp"
#include "mesh/solid/solid_mesh.hpp"

namespace reye::adapt {

/// Carries a motion of the skin into the inside of the mesh it was born with. Energy: sum over cells of 1/volume int
/// |Grad v|^2, so that small cells move nearly rigidly and large ones give way. In second order it is that of the
/// corners, and inner mid nodes move by the mean of the ends of their edges.   (README, 15)
class SolidInterior {
 public:
  explicit SolidInterior(const mesh::SolidMesh& born);

  /// Moves the inner nodes of `mesh`, which differs from `born` in its coordinates alone, after its skin; not at all
  /// where none would move by more than a hundredth of the height of its cells.
  void follow(mesh::SolidMesh& mesh, const mesh::SolidMesh& born) const;

 private:
  struct Middle {
    int node, a, b;
  };
  std::vector<Middle> middles_;  ///< inner ones
  std::vector<int> inner_;       ///< inner corners
  std::unique_ptr<HarmonicExtension> harmonic_;
};

/// The interior of one body between shape steps: that of the mesh of birth it was last asked for, which another
/// replaces. Each body has a cache of its own; throwing it away changes no bit. Safe to share between threads.
class SolidRelocationCache {
 public:
  std::shared_ptr<const SolidInterior> of(const mesh::SolidMesh& born);

 private:
  std::mutex mutex_;
  std::uint64_t born_ = 0;  ///< checksum of its nodes and cells
  std::shared_ptr<const SolidInterior> interior_;
};

}  // namespace reye::adapt
