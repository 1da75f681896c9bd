#pragma once
#include <string>
#include <vector>

#include "output/solid/space_view.hpp"

namespace reye::output {

/// Facets as they cover one another, by the nearest at each dot of a fine raster, then as outlines of one colour.
class DepthPicture {
 public:
  explicit DepthPicture(const SpaceView& view);

  /// Adds a plane or nearly plane polygon.
  void add(const Points3& corners, const std::string& colour);

  /// Whether a point on a facet is not covered by others.
  bool sees(const Vec3& x) const;

  /// The areas of each colour as paths of an SVG picture.
  std::string svg() const;

 private:
  struct Dot {
    float nearness = -3e38f;
    int colour = -1;
  };
  void fill(const Vec3& a, const Vec3& b, const Vec3& c, int colour);
  Vec3 on_raster(const Vec3& x) const;
  int colour_at(int i, int j) const;

  SpaceView view_;
  int wide_ = 0, high_ = 0;
  std::vector<Dot> dots_;
  std::vector<std::string> colours_;
};

}  // namespace reye::output
