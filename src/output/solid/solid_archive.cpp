#include "output/solid/solid_archive.hpp"

#include "base/errors.hpp"
#include "mesh/solid/solid_quality.hpp"
#include "output/run/checksum.hpp"
#include "output/run/layout.hpp"
#include "output/run/run_files.hpp"
#include "output/run/serialize_records.hpp"
#include "output/solid/serialize_solids.hpp"

/// Every function here takes its struct apart into all of its members: one more member, and it does not compile until
/// the archive has it, or says why it has not.

namespace Eigen {

template <class Archive>
void serialize(Archive& archive, Quaterniond& turn) {
  archive(turn.coeffs());
}

}  // namespace Eigen

namespace reye::contact {

template <class Archive>
void serialize(Archive& archive, SkinFrame& s) {
  auto& [normal, tangent, free] = s;
  archive(normal, tangent, free);
}

template <class Archive>
void serialize(Archive& archive, SkinPlace& s) {
  auto& [Q, D, M, T, covered, area, frame, carries, covers] = s;
  archive(Q, D, M, T, covered, area, frame, carries, covers);
}

template <class Archive>
void serialize(Archive& archive, SkinNode& s) {
  auto& [traction, gap, slip, own_wear] = s;
  archive(traction, gap, slip, own_wear);
}

template <class Archive>
void serialize(Archive& archive, SkinWear& s) {
  for_each_field(s, [&](const Field&, auto& member) { archive(member); });
}

}  // namespace reye::contact

namespace reye::solver {

template <class Archive>
void serialize(Archive& archive, SolidState& s) {
  auto& [traction, status, wear, a, driven, u, turn] = s;
  archive(traction, status, wear, a, driven, u, turn);
}

template <class Archive>
void serialize(Archive& archive, SolidSolution& s) {
  auto& [converged, reason, loose, iterations, errors, state, place, nodes, mortar_s, interface_s] = s;
  archive(converged, reason, loose, iterations, errors, state, place, nodes);
  static_cast<void>(mortar_s), static_cast<void>(interface_s);  // times are those of one process
}

}  // namespace reye::solver

namespace reye::sim {

template <class Archive>
void serialize(Archive& archive, SkinPoints& s) {
  auto& [secondary, primary] = s;
  archive(secondary, primary);
}

template <class Archive>
void serialize(Archive& archive, SolidRunState& s) {
  auto& [solution, points, meshes, born, touchable, solved, fitted, probes, factors, block_wear, last_wear, step,
         increment, step_cycles, cycle, step_blocks, jump, jump_rate, levels_at_once, share_per_cycle, block_cycles,
         jump_error, energy_last_cycle, slid, life_cycles, life_error, limit_measure, limit_rate, widest_stick,
         warnings, counts, cutback_reasons, balance, imbalance, largest_force, retained, mortar_s, interface_s,
         factor_s, shape_s] = s;
  archive(solution, points, touchable, solved, fitted, probes, factors, block_wear, last_wear, step, increment,
          step_cycles, cycle, step_blocks, jump, jump_rate, levels_at_once, share_per_cycle, block_cycles, jump_error,
          energy_last_cycle, slid, life_cycles, life_error, limit_measure, limit_rate, widest_stick, warnings, counts,
          cutback_reasons, balance, imbalance, largest_force, retained);
  static_cast<void>(meshes), static_cast<void>(born);  // beside the state, those alone that are not as drawn
  static_cast<void>(mortar_s), static_cast<void>(interface_s), static_cast<void>(factor_s);  // of one process
  static_cast<void>(shape_s);
}

}  // namespace reye::sim

namespace reye::output {

namespace {

using WornMeshes = std::vector<std::optional<mesh::SolidMesh>>;

/// Meshes of the bodies that are no longer as drawn.
WornMeshes worn_meshes(const sim::SolidMeshes& present, const sim::SolidMeshes& drawn) {
  WornMeshes worn;
  for (std::size_t b = 0; b < present.size(); ++b)
    worn.push_back(b < drawn.size() && present[b] == drawn[b] ? std::nullopt : std::optional(*present[b]));
  return worn;
}

sim::SolidMeshes present_meshes(WornMeshes worn, const sim::SolidMeshes& drawn) {
  sim::SolidMeshes present;
  for (std::size_t b = 0; b < worn.size(); ++b) {
    if (worn[b]) {
      mesh::check(*worn[b]);
      present.push_back(std::make_shared<const mesh::SolidMesh>(std::move(*worn[b])));
    } else if (b < drawn.size()) {
      present.push_back(drawn[b]);
    } else {
      throw std::runtime_error("altered: a body has no mesh");
    }
  }
  return present;
}

}  // namespace

std::string solid_state_to_bytes(const sim::SolidRunState& state, const std::vector<std::uint64_t>& meshes,
                                 const sim::SolidMeshes& drawn) {
  return to_bytes(meshes, worn_meshes(state.meshes, drawn), worn_meshes(state.born, drawn), state);
}

sim::SolidRunState solid_state_from_bytes(const std::string& bytes, const std::vector<std::uint64_t>& meshes,
                                          const sim::SolidMeshes& drawn) {
  sim::SolidRunState state;
  std::vector<std::uint64_t> theirs;
  WornMeshes worn, born;
  try {
    BoundedInput archive(bytes);
    archive(theirs);
    if (theirs != meshes)
      throw std::runtime_error(
          "its bodies have other meshes, and the file of those of the run, checkpoint/meshes.bin, is lost");
    archive(worn, born, state);
    archive.end();
    state.meshes = present_meshes(std::move(worn), drawn);
    state.born = present_meshes(std::move(born), drawn);
  } catch (const cereal::Exception& error) {
    throw std::runtime_error(std::string("altered: ") + error.what());
  } catch (const base::MeshError& error) {
    throw std::runtime_error(std::string("altered: ") + error.what());
  }
  return state;
}

std::uint64_t solid_state_layout() {
  LayoutArchive archive;
  archive(Counters{}, std::vector<std::uint64_t>{}, WornMeshes{}, WornMeshes{}, sim::SolidRunState{});
  return checksum(archive.text());
}

}  // namespace reye::output
