#pragma once
#include "cad/part/options.hpp"
#include "cad/part/raw.hpp"

/// Files are read by a program of its own, `reye-import`, which lies beside this one and may do nothing but read
/// (`import/guard`): what damaged or hostile files make of gmsh, OpenCASCADE and VTK ends there.
namespace reye::cad {

struct Imported {
  std::vector<RawPart> parts;
  bool guarded = true;  ///< false: the system has no means to keep the importer from anything but reading
};

/// What the files hold. Throws base::InputError, all issues together: key "geometry" with value the path for files that
/// are none, are refused, or make the importer crash, take too long or too much memory; key "section.point_mm". Throws
/// std::runtime_error when there is no importer to start.
Imported import_files(const GeometryOptions& options);

}  // namespace reye::cad
