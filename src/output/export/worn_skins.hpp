#pragma once
#include <string>

namespace reye::output {

/// The nodes of the worn faces of solids in a frame: contact, side, body, x, y, z on X, depth; by the tables of the
/// run. `body`: this one alone; empty: all. `note` is a comment before them. Throws base::InputError for tables that
/// are damaged or lack the frame.
std::string worn_faces_csv(const std::string& dir, std::size_t frame, const std::string& body, const std::string& note);

}  // namespace reye::output
