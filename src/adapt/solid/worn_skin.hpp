#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include "adapt/solid/worn_face.hpp"
#include "mesh/solid/solid_mesh.hpp"

/// What of a skin wear moves: worn nodes, the facets under them, the mid nodes of their edges.
namespace reye::adapt {

/// Facets of the skin at each node, ascending.
class FacetsAtNodes {
 public:
  FacetsAtNodes(int nodes, const std::vector<mesh::Facet>& skin);
  std::span<const int> operator[](int node) const {
    return {facets_.data() + begin_[node], facets_.data() + begin_[node + 1]};
  }

 private:
  std::vector<int> begin_, facets_;
};

/// What a node loses on one face, and the facets of that face at the node.
struct FaceLoss {
  double volume = 0.0;
  std::vector<int> facets;
};

struct WornSkinNode {
  int node = -1;
  bool middle = false;  ///< a mid node of tri6 facets: what it loses is that of its control point
  std::vector<FaceLoss> losses;
};

/// A mid node that wear moves: on a facet with a worn node, itself worn or at an end that is.
struct MovingMiddle {
  int node = -1;
  std::array<int, 2> ends{};
  std::array<int, 2> facets{};
  int worn = -1;  ///< its place among the worn nodes, -1: none
};

struct WornSkin {
  std::vector<WornSkinNode> nodes;  ///< ascending, those without loss left out
  std::vector<MovingMiddle> middles;
  std::vector<int> touched;  ///< facets with a worn node
  double volume = 0.0;       ///< sum of all losses [mm^3]
};

/// Of losses that are valid (`bad_loss`). Throws base::MeshError where the solid has no such face, std::logic_error
/// where a face has another number of nodes.
WornSkin worn_skin(const mesh::SolidMesh& mesh, const FacetsAtNodes& facets_at, const std::vector<WornFace>& worn);

/// The message for a loss that is negative or not a number; empty when all are valid.
std::string bad_loss(const std::vector<WornFace>& worn);

}  // namespace reye::adapt
