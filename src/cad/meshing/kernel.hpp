#pragma once
#include "cad/meshing/region.hpp"
#include "cad/part/plane_face.hpp"
#include "cad/part/raw.hpp"

/// gmsh and OpenCASCADE are in a separate library (`cad/gmsh`), loaded on first use: loading takes longer than many a
/// small scene, and a scene that brings its mesh does not need it.
namespace reye::cad {

/// The functions of that library.
struct Kernel {
  std::vector<RawPart> (*read_file)(const std::string& path, Format format, const std::optional<Section>& section);
  void (*fill)(Region& region, const SizeField& size);
  std::string (*write_step)(const std::vector<PlaneFace>& faces);
};

/// Loads it; throws std::runtime_error when it is not found.
const Kernel& kernel();

/// What that library exports by this name; loads it. Throws std::runtime_error when it is not found.
const void* kernel_symbol(const char* name);

std::vector<RawPart> read_by_gmsh(const std::string& path, Format format, const std::optional<Section>& section);
void fill_by_gmsh(Region& region, const SizeField& size);
std::string write_step_by_gmsh(const std::vector<PlaneFace>& faces);

}  // namespace reye::cad
