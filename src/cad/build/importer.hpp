#pragma once
#include "cad/part/options.hpp"
#include "cad/part/raw.hpp"

/// Files are read by a separate program, `reye-import`, which lies beside this one and may only read (`import/guard`):
/// damage that bad or hostile files cause in gmsh, OpenCASCADE and VTK stays there.
namespace reye::cad {

struct Imported {
  std::vector<RawPart> parts;
  bool guarded = true;  ///< false: the system has no means to keep the importer from anything but reading
};

/// The content of the files. Throws base::InputError, all issues together: key "geometry" with value the path for files
/// that do not exist, are refused, or make the importer crash, take too long or too much memory; key
/// "section.point_mm". Throws std::runtime_error when there is no importer to start.
Imported import_files(const GeometryOptions& options);

}  // namespace reye::cad
