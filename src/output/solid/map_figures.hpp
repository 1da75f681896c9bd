#pragma once
#include <optional>
#include <string>
#include <vector>

#include "output/report/plot.hpp"
#include "output/solid/skin_map.hpp"

namespace reye::output {

/// What a set of maps is called.
struct MapWords {
  std::string id;      ///< part of the names of its figures
  std::string before;  ///< of titles: "pad: ", or nothing where there is one contact
  std::string when;    ///< "cycle 3"
  std::optional<double> friction{};
};

/// The pressure on a side, in bands, with the lines of its profiles.
Figure pressure_map(const SkinMap& map, const DrawnSkin& skin, const MapWords& words);

/// The amount of the shear, with arrows of its direction on the secondary side.
Figure shear_map(const SkinMap& map, const DrawnSkin& skin, const MapWords& words);

/// The amount of the slip of the last increment, with arrows of its path.
Figure slip_map(const SkinMap& map, const DrawnSkin& skin, const MapWords& words);

/// Where the contact sticks and where it slips.
Figure status_map(const SkinMap& map, const DrawnSkin& skin, const MapWords& words);

/// The rows of a side that have worn, but for a thousandth of its largest depth.
std::vector<char> worn_rows(const DrawnSkin& skin);

/// The worn depth of a side about `worn_rows`.
Figure depth_map(const SkinMap& map, const DrawnSkin& skin, const MapWords& words);

/// A value on one side of a contact over the frames of a run.
struct MovingMap {
  SkinMap map;
  std::vector<double> rows;
  std::string caption;
};

/// The frames one after the other, seen as the last one is, with one scale.
Figure moving_map(const std::vector<MovingMap>& frames, const std::string& unit, const std::string& id,
                  const std::string& title);

/// Pressure, shear and what friction allows along the principal lines.
std::vector<Figure> line_profiles(const SkinMap& map, const DrawnSkin& skin, const MapWords& words);

}  // namespace reye::output
