#pragma once
#include <memory>

#include "base/linalg.hpp"
#include "mortar/solid/skin.hpp"

namespace reye::adapt {

using base::Vec2;
using base::Vec3;

/// The place of a surface nearest to a point.
struct SkinFoot {
  int facet = -1;
  Vec2 xi = Vec2::Zero();  ///< on the facet's reference shape
  Vec3 at = Vec3::Zero();
  double distance = 0.0;
};

/// Finds the nearest places of a surface by a tree of its facets: exact on tri3, on warped and curved facets from the
/// nearest of their two, or sixteen, triangles by Gauss and Newton's method within the facet.
class SkinLocator {
 public:
  /// The skin must have a facet, and outlive the locator.
  explicit SkinLocator(const mortar::Skin& skin);
  ~SkinLocator();
  SkinLocator(SkinLocator&&) noexcept;

  SkinFoot nearest(const Vec3& p) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

/// A place of a facet of a skin, whose points are control points on tri6.
Vec3 place_on(const mortar::Skin& skin, int facet, const Vec2& xi);

}  // namespace reye::adapt
