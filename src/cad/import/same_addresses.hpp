#pragma once

namespace reye::cad {

/// Starts this program again with addresses of memory that are the same in every run, once: gmsh and OpenCASCADE order
/// some of their sets by addresses, and meshes would differ from run to run by a node here and there.
/// The environment stays behind, but for where libraries lie: gmsh keeps texts of it, whose lengths move addresses.
/// Where the system does not allow it the program continues as it is. `words` as `main` got them.
void start_with_same_addresses(char** words);

}  // namespace reye::cad
