#pragma once
#include "cad/import/read_file.hpp"

namespace reye::cad {

/// Answers to each region that is to be filled with its cells. Limits computing and memory at each of them.
void serve_faces(const Reading& how);

}  // namespace reye::cad
