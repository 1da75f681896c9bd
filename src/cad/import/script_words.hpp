#pragma once
#include <string_view>

namespace reye::cad {

/// Whether a word is one of those that a geometry script may use: what draws points, curves, faces and solids, groups,
/// moves, cuts and joins them, sizes, loops, branches and arithmetic. Whatever acts on anything but the model is not
/// among them.
bool is_allowed_word(std::string_view word);

/// Whether a script may set `group.option`: all of Mesh and Geometry, of General what is said.
bool is_allowed_option(std::string_view group, std::string_view option);

/// Whether `Field[...].option` may be set.
bool is_allowed_field_option(std::string_view option);

}  // namespace reye::cad
