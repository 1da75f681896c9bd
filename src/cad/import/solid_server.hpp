#pragma once
#include "cad/import/read_file.hpp"

namespace reye::cad {

/// Answers about the solids of one file: first to a query, which solids it holds; then to each order, the mesh of one.
/// Limits computing and memory at each of them.
void serve_solids(const std::string& file, const Reading& how);

/// Answers to each surface that is to be filled with its mesh.
void serve_fillings(const Reading& how);

}  // namespace reye::cad
