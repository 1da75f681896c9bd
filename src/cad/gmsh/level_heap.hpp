#pragma once

namespace reye::cad {

/// Lets what is allocated next lie at addresses that do not depend on what was allocated and freed before: fills all
/// holes of the heap and continues it at a multiple of a megabyte. gmsh orders and hashes some of its sets by
/// addresses, and keeps texts of any length, as the path of the program: a mesh would depend on where Reye is
/// installed. For processes started with the same addresses (`start_with_same_addresses`), once and for little: what is
/// filled is not given back. Does nothing with another allocator than that of glibc.
void level_heap();
void level_heap_once();  ///< at the first call alone

}  // namespace reye::cad
