#include "output/solid/space_view.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace reye::output {

Vec2 SpaceView::pixel(const Vec3& x) const {
  const Vec2 middle = 0.5 * (field.low + field.high);
  return {middle.x() + pixels_per_mm * (right.dot(x) - seen_mid.x()),
          middle.y() - pixels_per_mm * (up.dot(x) - seen_mid.y())};
}

SpaceView space_view(const Vec3& toward, const Vec3& above, const Box& field, const Points3& shown) {
  constexpr double margin = 1.12;
  SpaceView view;
  view.toward = toward.normalized();
  view.field = field;
  view.right = above.cross(view.toward).normalized();
  view.up = view.toward.cross(view.right);
  Points flat;
  for (const Vec3& x : shown) flat.emplace_back(view.right.dot(x), view.up.dot(x));
  if (flat.empty()) return view;
  const Box box = box_of(flat);
  const Vec2 size = (margin * box.size()).cwiseMax(1e-12);
  view.pixels_per_mm = std::min(field.size().x() / size.x(), field.size().y() / size.y());
  view.seen_mid = 0.5 * (box.low + box.high);
  return view;
}

}  // namespace reye::output
