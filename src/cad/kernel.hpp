#pragma once
#include "cad/raw.hpp"
#include "cad/region.hpp"

/// gmsh, and the OpenCASCADE it brings, make a library of their own (`cad/gmsh`), loaded when it is first asked for: to
/// load it takes longer than many a small scene, and one that brings its mesh does without.
namespace reye::cad {

/// What that library does.
struct Kernel {
  std::vector<RawPart> (*read_file)(const std::string& path, Format format, const std::optional<Section>& section);
  void (*fill)(Region& region, const SizeField& size);
};

/// Loads it; throws std::runtime_error when it is not found.
const Kernel& kernel();

std::vector<RawPart> read_by_gmsh(const std::string& path, Format format, const std::optional<Section>& section);
void fill_by_gmsh(Region& region, const SizeField& size);

}  // namespace reye::cad
