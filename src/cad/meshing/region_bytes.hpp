#pragma once
#include <string>
#include <string_view>

#include "cad/meshing/region.hpp"

/// What passes between this program and the process in which gmsh fills regions, as bytes.
namespace reye::cad {

struct RegionToFill {
  Region region;
  SizeField size{1.0, 1.0};
};

/// The region filled, or why it cannot be.
struct FilledRegion {
  Region region;
  std::string failure;
};

std::string bytes_of(const RegionToFill& request);
std::string bytes_of(const FilledRegion& answer);

/// Throws std::runtime_error where the bytes end early.
RegionToFill region_to_fill_of(std::string_view bytes);

/// The answer in these untrusted bytes, checked: finite coordinates, the nodes that the region had where they were,
/// cells of its kind and of nodes that there are. Throws std::runtime_error naming the check that fails.
FilledRegion filled_region_of(std::string_view bytes, const Region& asked);

}  // namespace reye::cad
