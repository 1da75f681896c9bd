#pragma once
#include <memory>

#include "cad/part/importer_process.hpp"

namespace reye::cad {

/// From now on `fill` asks this importer, which has read files by gmsh and keeps it ready: to load it costs as much as
/// many a small scene. Without one, `fill` starts its own.
void mesh_in(std::unique_ptr<ImporterProcess> importer, bool trusted);

}  // namespace reye::cad
