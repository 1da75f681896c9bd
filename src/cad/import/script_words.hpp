#pragma once
#include <string_view>

namespace reye::cad {

/// Whether a word is one of those that a geometry script may use: commands that draw points, curves, faces and solids,
/// group, move, cut and join them, sizes, loops, branches and arithmetic. No command that acts outside of the model is
/// among them.
bool is_allowed_word(std::string_view word);

/// Whether a script may set `group.option`: all of Mesh and Geometry, and those of General that control messages.
bool is_allowed_option(std::string_view group, std::string_view option);

/// Whether `Field[...].option` may be set.
bool is_allowed_field_option(std::string_view option);

}  // namespace reye::cad
