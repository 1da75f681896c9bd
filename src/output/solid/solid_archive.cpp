#include "output/solid/solid_archive.hpp"

#include "output/run/checksum.hpp"
#include "output/run/layout.hpp"
#include "output/run/run_files.hpp"
#include "output/run/serialize.hpp"
#include "output/run/serialize_records.hpp"

/// Every function here takes its struct apart into all of its members: one more member, and it does not compile until
/// the archive has it, or says why it has not.

namespace reye::contact {

template <class Archive>
void serialize(Archive& archive, SkinFrame& s) {
  auto& [normal, tangent, free] = s;
  archive(normal, tangent, free);
}

template <class Archive>
void serialize(Archive& archive, SkinPlace& s) {
  auto& [Q, covered, area, frame, carries] = s;
  archive(Q, covered, area, frame, carries);
}

template <class Archive>
void serialize(Archive& archive, SkinNode& s) {
  auto& [traction, gap, slip] = s;
  archive(traction, gap, slip);
}

}  // namespace reye::contact

namespace reye::solver {

template <class Archive>
void serialize(Archive& archive, SolidState& s) {
  auto& [traction, status, a, driven, u] = s;
  archive(traction, status, a, driven, u);
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
void serialize(Archive& archive, SolidRunState& s) {
  auto& [solution, touchable, solved, factors, held, step, step_plays, increment, cycle, energy, energy_before_cycle,
         energy_last_cycle, warnings, counts, cutback_reasons, balance, retained, mortar_s, interface_s, factor_s] = s;
  archive(solution, touchable, solved, factors, held, step, step_plays, increment, cycle, energy, energy_before_cycle,
          energy_last_cycle, warnings, counts, cutback_reasons, balance, retained);
  static_cast<void>(mortar_s), static_cast<void>(interface_s), static_cast<void>(factor_s);  // of one process
}

}  // namespace reye::sim

namespace reye::output {

std::string solid_state_to_bytes(const sim::SolidRunState& state, const std::vector<std::uint64_t>& meshes) {
  return to_bytes(meshes, state);
}

sim::SolidRunState solid_state_from_bytes(const std::string& bytes, const std::vector<std::uint64_t>& meshes) {
  sim::SolidRunState state;
  std::vector<std::uint64_t> theirs;
  try {
    BoundedInput archive(bytes);
    archive(theirs);
    if (theirs != meshes)
      throw std::runtime_error(
          "its bodies have other meshes, and the file of those of the run, checkpoint/meshes.bin, is lost");
    archive(state);
    archive.end();
  } catch (const cereal::Exception& error) {
    throw std::runtime_error(std::string("altered: ") + error.what());
  }
  return state;
}

std::uint64_t solid_state_layout() {
  LayoutArchive archive;
  archive(Counters{}, std::vector<std::uint64_t>{}, sim::SolidRunState{});
  return checksum(archive.text());
}

}  // namespace reye::output
