#pragma once
#include <string>
#include <vector>

#include "base/linalg.hpp"
#include "base/space.hpp"

/// Scars and loops as a rig measured them.
namespace reye::scene {

enum class ScarSide { secondary, primary };

/// What a measurement belongs to, and where it stands in its file.
struct ScarPlace {
  std::string contact;
  ScarSide side = ScarSide::secondary;
  double cycles = 0.0;  ///< of the scene when it was measured
  std::string key;      ///< "scar[0]"
};

/// A coordinate of a measured place: one of space, or the length along the outline of the body.
enum class ScarAxis { x, y, z, arc };

/// Depths along a line across the scar (a profile), or over its face (a map).
struct MeasuredScar {
  ScarPlace of;
  std::vector<ScarAxis> axes;  ///< one of a profile, two of a map
  std::vector<base::Vec2> at;  ///< [mm]; of a profile in increasing order, the second number zero
  base::Vector depth_mm;       ///< positive into the body
  base::Vector scatter_mm;     ///< standard deviation of each depth; empty where it is not known
  bool level = true;           ///< offset and tilt of the instrument are unknown
  bool origin_known = false;   ///< places count from the scene's origin
  std::string file;
};

/// `area`: worn, in mm^2 of a plane scene, mm^3 where the scene has volumes. `energy`: dissipated in one cycle of the
/// contact, in mJ, of a plane scene per mm; it belongs to no side.
enum class ScarFigure { depth, width, area, energy };

/// One number of a scar, or of a loop of tangential force over stroke.
struct MeasuredFigure {
  ScarPlace of;
  ScarFigure what = ScarFigure::depth;
  double value = 0.0;
  double scatter = 0.0;  ///< standard deviation over the value; 0: not known
};

struct MeasuredScars {
  std::vector<MeasuredScar> scars;
  std::vector<MeasuredFigure> figures;
  std::vector<std::string> warnings;  ///< values that are possible, and odd
};

/// A contact of the scene, and which of its sides wear.
struct WearingContact {
  std::string name;
  bool secondary = false, primary = false;
};

/// What the scene says of its measurements.
struct ScarContext {
  std::vector<WearingContact> contacts;
  int dimension = 2;     ///< 3: of solids, where scars may be maps
  bool volumes = false;  ///< worn amounts are mm^3: solids and axisymmetric scenes
  // Of measurements that do not name their own:
  double at_cycles = 0.0;  ///< 0: each must
  std::string contact{}, side{};
};

}  // namespace reye::scene
