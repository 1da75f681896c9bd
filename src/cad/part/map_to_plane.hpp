#pragma once
#include <optional>
#include <vector>

#include "cad/part/part.hpp"
#include "cad/part/raw.hpp"

namespace reye::cad {

/// All parts of a scene, mapped by the plane of the section or, without one, of the first part. Throws base::InputError
/// (key "geometry", value the file) naming each part that is not planar, that lies in a plane not parallel to it, or
/// whose outline does not close.
std::vector<Part> map_to_plane(const std::vector<RawPart>& raw, const std::optional<Section>& section = {});

}  // namespace reye::cad
