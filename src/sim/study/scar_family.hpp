#pragma once
#include <functional>
#include <span>
#include <vector>

#include "scene/scars.hpp"
#include "sim/problem/records.hpp"
#include "sim/solid/solid_records.hpp"

/// Worn depths of one side of a contact over the cycles of a run, as an instrument would see them.
namespace reye::sim {

/// The worn depth [mm] at a place in the axes of a measured scar [mm]; zero where nothing has worn.
using DepthField = std::function<double(const Vec2&)>;

/// A scar at one time: its depths, and where its volume lies.
struct ScarShape {
  DepthField depth;
  Vec2 middle{0.0, 0.0};  ///< of its volume [mm]
  double width = 0.0;     ///< root mean square distance of its volume from there [mm]; 0 of a number
  int directions = 0;     ///< in which it can grow wider: 1 of a profile, 2 of a map, 0 of a number
  bool worn = true;       ///< it grows from nothing; false: it is there from the first cycle on, as friction is
};

/// The depth along a surface of the plane. Of an outline that turns back in this axis the part about the deepest row
/// is taken, as far as the axis runs one way.
ScarShape profile_of(const SurfaceRecord& surface, scene::ScarAxis axis);

/// The depth over a face of a solid, seen along the axis that is not among the two. Linear on the facets, kept on a
/// raster of places.
ScarShape map_of(const SkinRecord& skin, const std::vector<scene::ScarAxis>& axes);

/// One number in place of a scar; `worn`: as in ScarShape.
ScarShape number_of(double value, bool worn = true);

/// What was measured of one scar, or one number of it, as the run has it after each block.
class ScarFamily {
 public:
  void add(double cycles, ScarShape shape);

  /// Depths after so many cycles. Between the ends of blocks they are linear in the cycles, and before the first one in
  /// proportion to them. Beyond the last one, which serves for guesses alone, the volume grows in proportion to the
  /// cycles and the width by the power with which it has grown so far; numbers grow by theirs. What is not worn stays
  /// as it was at the first block, or the last.
  Vector at(double cycles, std::span<const Vec2> places) const;

 private:
  double depth(double cycles, const Vec2& place) const;
  double beyond(double growth, const Vec2& place) const;

  std::vector<double> cycles_;  ///< increasing, all above zero
  std::vector<ScarShape> shapes_;
  double power_ = 0.0;  ///< of the width, or of a number, over the latter half of the cycles
};

}  // namespace reye::sim
