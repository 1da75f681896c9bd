#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "algebra/factor.hpp"
#include "base/linalg.hpp"
#include "base/space.hpp"
#include "body/solid/point_compliance.hpp"
#include "body/solid/rigid_modes.hpp"

namespace reye::body {

/// A linear body at small strain condensed to the nodes that contact may touch. With forces f on the retained nodes (3
/// each), the driven values s and the motions a that nothing holds (at most six):
///   u = C f + U s + A a,      A^T f + B s = 0  (one equation per free motion)
/// Displacements of retained nodes are those of control points where a tri6 facet is named in `contact_faces`.
/// Support motions that are fixed are driven by zero and not listed; a rigid body has C = 0.
/// The resultants of all supports on the body follow by reciprocity without another solve,
///   r = F f + G s            (six each: force, then moment about the support's centre, in x, y, z)
/// where what a loaded motion applies is included.
class SolidBody {
 public:
  /// Factorises. `retained`: nodes of the mesh, distinct; `spare`: the factor of this body in another shape, whose
  /// analysis and memory serve again where they fit. Throws base::SolveError where the stiffness is not definite.
  SolidBody(SolidInput input, std::vector<int> retained, std::optional<algebra::SchurFactor> spare = {});
  ~SolidBody();
  SolidBody(SolidBody&&) noexcept;
  SolidBody& operator=(SolidBody&&) noexcept;

  const SolidInput& input() const;
  const std::vector<int>& retained() const;
  const std::vector<Driven>& driven() const;

  const PointCompliance& C() const;  ///< 3n x 3n
  const Matrix& U() const;           ///< 3n x driven
  const Matrix& A() const;           ///< 3n x free motions: unit translations and rotations about the centre of the box
  const Matrix& B() const;           ///< free motions x driven: resultants of loads in the free motions [N; N mm]
  const Matrix& F() const;           ///< 6 supports x 3n
  const Matrix& G() const;           ///< 6 supports x driven
  const Vec3& centre() const;        ///< about which the free rotations turn
  /// Force, and moment about `centre`, of each load of the input at factor 1 [N; N mm].
  const std::vector<Mode>& load_resultant() const;
  Vec3 support_centre(int support) const;  ///< about which it turns, and its moments are taken
  std::vector<std::string> free_motions()
      const;  ///< "x", "rotation about z" ... or a direction in numbers, for messages

  /// Displacements of all nodes of the mesh (nodes themselves, not control points): one back-substitution.
  Points3 displacements(const Vector& f, const Vector& s, const Vector& a) const;

  /// Displacements of all nodes in another shape of the cells, which is not factorised as long as it differs little.
  /// Motions that nothing holds turn about the centre of that shape's box.
  Points3 displacements_in(std::shared_ptr<const mesh::SolidMesh> shape, const Vector& f, const Vector& s,
                           const Vector& a) const;

  /// Its factor, if it has one, as `spare` for another body; this one is no longer of use.
  std::optional<algebra::SchurFactor> take_factor();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace reye::body
