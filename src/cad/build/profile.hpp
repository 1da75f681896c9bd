#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cad/part/options.hpp"
#include "cad/part/part.hpp"
#include "cad/part/select.hpp"

namespace reye::cad {

/// A profile from the text of a CSV file: the line `arc_length_mm,height_mm`, then at least two rows of numbers with
/// increasing arc length. Throws base::InputError with one issue, whose rule names the line of the file.
Profile parse_profile(const std::string& csv);

/// The part with the chosen edges displaced along their outward normals by the profile of the boundary; as many edges
/// as before, the displaced ones splines. At an end of the boundary the height is zero, or a straight edge that
/// continues there at a right angle is made longer or shorter. Nothing (and an issue) where the profile does not fit.
std::optional<Part> with_profile(const Part& part, const EdgeChoice& edges, const BoundaryOptions& boundary,
                                 std::vector<base::Issue>& issues);

}  // namespace reye::cad
