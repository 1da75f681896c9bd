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
  double volume = 0.0;    ///< integral of its depths [mm^2 of a profile, mm^3 of a map]; 0 of a number
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

  /// Depths after so many cycles N. Between the ends a and b of blocks a scar grows as one that is similar to itself,
  ///     d(x) = V / W^n ((1 - s) f_a(xi) + s f_b(xi)),  xi = (x - x_m) / W,  f(xi) = W^n / V d(x_m + W xi),
  /// with volume V and middle x_m linear in N, width W by a power of N, s = (N - N_a) / (N_b - N_a) and n directions;
  /// numbers grow by a power of N. Depths that were linear in N would blend a narrow scar with a wide one, which has
  /// another shape. Before the first block depths are in proportion to N. Beyond the last one, which serves for guesses
  /// alone, the volume grows in proportion to N and the width by the power with which it has grown so far; numbers grow
  /// by theirs. What is not worn is linear between blocks and stays as it was at the first one, or the last.
  Vector at(double cycles, std::span<const Vec2> places) const;

  /// The middle of its volume at the end [mm]; zero where nothing has worn, and of a number.
  Vec2 middle() const { return shapes_.empty() ? Vec2(Vec2::Zero()) : shapes_.back().middle; }

 private:
  DepthField after(double cycles) const;
  DepthField between(std::size_t next, double cycles) const;
  DepthField beyond(double growth) const;

  std::vector<double> cycles_;  ///< increasing, all above zero
  std::vector<ScarShape> shapes_;
  double power_ = 0.0;  ///< of the width, or of a number, over the latter half of the cycles
};

}  // namespace reye::sim
