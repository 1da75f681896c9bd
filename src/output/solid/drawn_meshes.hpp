#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cad/solid/solid_geometry.hpp"
#include "sim/solid/solid_problem.hpp"

/// The meshes of a run of solids as they were drawn, beside its checkpoints. A state counts their nodes, and the mesher
/// does not make the same mesh of one file everywhere: it orders some sets by addresses of memory.
namespace reye::output {

/// A checksum per body of its drawn mesh.
std::vector<std::uint64_t> mesh_checksums(const sim::SolidProblem& problem);

/// Writes checkpoint/meshes.bin, before the first checkpoint.
void save_meshes(const std::string& dir, const sim::SolidProblem& problem);

/// The geometry of the run in the folder, whose scene has this `fixed_sha256`; empty where its file is missing,
/// damaged, or of another scene or layout, and the geometry has to be built again.
std::optional<cad::SolidGeometry> load_meshes(const std::string& dir, const std::string& fixed_sha256);

}  // namespace reye::output
