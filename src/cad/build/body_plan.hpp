#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "cad/part/options.hpp"
#include "cad/part/select.hpp"
#include "cad/part/zone.hpp"

namespace reye::cad {

/// The data of one body before it is meshed. It points into the parts and options it was made from.
struct BodyPlan {
  const Part* part = nullptr;
  const BodyOptions* options = nullptr;
  std::map<std::string, EdgeChoice> boundaries;
  std::vector<ZoneOutline> zones;
  bool halved = false;              ///< the file has a section through the axis, of which this is the half x >= 0
  std::set<std::string> cut_off{};  ///< physical curves that name edges at x < 0 and not their mirror images
};

/// The bodies of a scene with the parts they point into.
struct Plans {
  std::vector<Part> parts;
  std::vector<BodyPlan> bodies;
};

}  // namespace reye::cad
