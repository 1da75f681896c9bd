#pragma once
#include <vector>

#include "mortar/kernel.hpp"
#include "mortar/surface.hpp"

namespace reye::mortar {

/// The positions of the two sides of a contact. Surface dofs: 2 * node + component of the secondary side, then the
/// primary side after all secondary ones.
struct Placement {
  const Surface* secondary = nullptr;
  const Surface* primary = nullptr;
  Points xs, xm;                                   ///< current positions, of control points too
  Points xs_before, xm_before;                     ///< at the start of the increment
  std::vector<char> cut;                           ///< per secondary node: carries no multiplier
  std::vector<char> secondary_near, primary_near;  ///< per node: takes part; facets of others are skipped; empty: all
  Analysis analysis = Analysis::plane_strain;
  Kinematics measure = Kinematics::small;  ///< strain measure of the secondary body: integrals over length on X or on x
  double search = 0.0;

  bool near(const std::vector<char>& marks, const LineFacet& facet) const {
    return marks.empty() || (marks[facet[0]] && marks[facet[1]] && (facet[2] < 0 || marks[facet[2]]));
  }
  int secondary_dofs() const { return 2 * secondary->node_count(); }
  int dofs() const { return secondary_dofs() + 2 * primary->node_count(); }
};

/// The integrals of one covered facet and, once differentiated, their derivatives.
struct FacetRecord {
  int facet = 0;
  int count = 2;                 ///< its nodes
  std::vector<int> primaries;    ///< primary surface node of each local one
  std::vector<LineFacet> pairs;  ///< primary facets in local numbers
  FacetIntegrals<double> value;
  std::vector<int> dofs;      ///< surface dofs the integrals depend on
  std::vector<double> slope;  ///< one row of dofs.size() per output

  /// Rows of `slope` for node j = 0 .. count - 1.
  int D(int j) const { return (count + 5) * j; }
  int off(int j, int k) const { return D(j) + 1 + (k < j ? k : k - 1); }  ///< k != j
  int gap(int j) const { return D(j) + count; }
  int offset(int j) const { return D(j) + count + 1; }  ///< and + 1 for y
  int drift(int j) const { return D(j) + count + 3; }   ///< and + 1 for y
  int M(int j, int l) const { return D(count) + j * static_cast<int>(primaries.size()) + l; }
  int cover(int j, int l) const { return M(count + j, l); }
  int outputs() const { return M(2 * count, 0); }
  const double* row(int output) const { return slope.data() + output * dofs.size(); }
};

/// Unit normal of a secondary node: averaged over the tangents of its facets there (corners: the facet `at_corner`,
/// 0 before, 1 after); of a control point: that of its facet at xi = 0. Depends on up to three nodes.
struct NormalStencil {
  std::array<int, 3> nodes{-1, -1, -1};  ///< before, self, after; -1 where it does not depend on one
};
NormalStencil normal_stencil(const Surface& surface, int node, int at_corner);

/// `x`: positions of the nodes of the stencil.
template <class T>
Pair<T> nodal_normal(const NormalStencil& stencil, const std::array<Pair<T>, 3>& x) {
  if (stencil.nodes[1] < 0) return facet_normal(x[0], x[2]);
  if (stencil.nodes[0] < 0) return facet_normal(x[1], x[2]);
  if (stencil.nodes[2] < 0) return facet_normal(x[0], x[1]);
  return averaged(facet_normal(x[0], x[1]), facet_normal(x[1], x[2]));
}

/// Pairs, integrates and differentiates; keeps its work space between calls.
class Integrator {
 public:
  /// Values of all facets that meet a primary facet. The records stay valid until the next call.
  std::vector<FacetRecord>& values(const Placement& placement);
  /// Recomputes the values of one record after its nodes' `cut` changed in the placement.
  void renew(const Placement& placement, FacetRecord& record);
  /// Fills dofs and slope of one record, with the same placement.
  void differentiate(const Placement& placement, FacetRecord& record);

 private:
  static constexpr int width = 16;
  /// A circle.
  struct Circle {
    Vec2 middle;
    double radius = 0.0;
  };
  /// A primary facet that takes part, and a circle round it.
  struct Opposite {
    LineFacet nodes;
    Circle round;
  };
  void list_opposites(const Placement& placement);
  FacetRecord& next_record();
  bool pair_up(const Placement& placement, int facet, FacetRecord& record);
  void add_pair(const LineFacet& opposite, FacetRecord& record);
  void store(FacetRecord& record, int from) const;

  std::vector<FacetRecord> records_, spare_;  ///< of the last call, and others that keep their memory
  Workspace<double> plain_;
  Workspace<base::Dual<width>> dual_;
  std::vector<Opposite> opposites_;
  std::vector<Circle> bundles_;  ///< round every `bundle` opposites, one after the other
  std::vector<int> local_;       ///< primary surface node -> local number, -1
};

}  // namespace reye::mortar
