#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/linalg.hpp"
#include "output/picture/ticks.hpp"
#include "output/solid/solid_vtk.hpp"

/// A side of a contact as a map: seen along its mean normal.
namespace reye::output {

/// Points are those of the rows, then the middles of quadrilaterals; axes ascend with the axes of space that they are
/// nearest to.
struct SkinMap {
  base::Vec3 across = base::Vec3::UnitX(), up = base::Vec3::UnitY(), normal = base::Vec3::UnitZ();
  base::Points x;                             ///< across, up [mm]
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise in the map; those that are seen
  std::vector<std::array<int, 4>> middles;    ///< of each point beyond the rows: the rows about it
  std::vector<char> active;                   ///< of the rows: what the map is of, as those in contact
  Range x_seen, y_seen;                       ///< about active rows, else about all of it
  double spacing_mm = 0.0;                    ///< root of the mean area of an active row; 0 where none is

  /// Values of rows, continued to the middles by their means.
  std::vector<double> at_points(std::vector<double> rows) const;
  /// A vector of space in the map.
  base::Vec2 flat(const base::Vec3& v) const { return {across.dot(v), up.dot(v)}; }
};

/// The map of a side about its rows in contact; without triangles where it has no facets that are seen along the mean
/// normal.
SkinMap skin_map(const DrawnSkin& skin);

/// The map of a side about other rows.
SkinMap skin_map(const DrawnSkin& skin, std::vector<char> active);

/// A straight line on a map, and where along it values are known [mm].
struct MapLine {
  base::Vec2 through{0.0, 0.0}, along{1.0, 0.0};
};

/// The lines along the two principal directions of the contact (of pressure times area), the longer first, through the
/// place of the largest pressure; those of the map's axes where the contact is as wide as long, or nothing presses.
std::array<MapLine, 2> principal_lines(const SkinMap& map, const DrawnSkin& skin);

struct LineSamples {
  std::vector<double> position, value;  ///< NaN beyond the facets
};

/// Values of points, linear on triangles, along the part of a line that is seen; positions from `through`.
LineSamples sampled(const SkinMap& map, const std::vector<double>& values, const MapLine& line);

/// "x", or "along (0.6, 0.8, 0)": what an axis of the map is called.
std::string axis_label(const base::Vec3& direction);

}  // namespace reye::output
