#pragma once

namespace reye::cad {

/// Starts this program again with addresses of memory that are the same in every run, once: gmsh and OpenCASCADE order
/// some of their sets by addresses, and the meshes of solids would differ from run to run by a node here and there.
/// Where the system does not allow it the program continues as it is. `words` as `main` got them.
void start_with_same_addresses(char** words);

}  // namespace reye::cad
