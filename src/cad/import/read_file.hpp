#pragma once
#include "cad/part/raw.hpp"

namespace reye::cad {

/// Options of reading files.
struct Reading {
  std::optional<Section> section;
  std::string folder;    ///< scripts may include what lies below it
  bool trusted = false;  ///< scripts may use all of gmsh's language
};

/// The format of a file that may be read: one of those known, recognised by its content, a script of allowed commands.
/// Throws base::InputError (key "geometry").
Format checked_format(const std::string& path, const Reading& how);

/// Reads one file: STEP, IGES, BREP, .geo, .geo_unrolled, .msh, .vtu, lengths in mm. Its solids are
/// cut by the section.
/// Throws base::InputError (key "geometry", value the path) for what cannot be used; key "section.point_mm" where the
/// section misses all its solids.
std::vector<RawPart> read_file(const std::string& path, const Reading& how);

}  // namespace reye::cad
