#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "sim/solid/solid_state.hpp"

namespace reye::output {

/// The state of a run of solids on these meshes (`mesh_checksums`) as bytes, and back: every bit that the run resumes
/// from. Throws std::runtime_error for bytes that are not of a state, or of one on other meshes; sim::check_state
/// checks that their content is consistent.
/// `drawn`: these meshes themselves; bodies that still have them are not stored.
std::string solid_state_to_bytes(const sim::SolidRunState& state, const std::vector<std::uint64_t>& meshes,
                                 const sim::SolidMeshes& drawn = {});
sim::SolidRunState solid_state_from_bytes(const std::string& bytes, const std::vector<std::uint64_t>& meshes,
                                          const sim::SolidMeshes& drawn = {});

/// The layout of these bytes and of the Counters before them, which changes with any of their types.
std::uint64_t solid_state_layout();

}  // namespace reye::output
