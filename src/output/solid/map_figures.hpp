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

/// Pressure, shear and what friction allows along the principal lines.
std::vector<Figure> line_profiles(const SkinMap& map, const DrawnSkin& skin, const MapWords& words);

}  // namespace reye::output
