#include <cmath>
#include <numbers>
#include <numeric>

#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "mesh/solid/solid_place.hpp"
#include "sim/solid/solid_measure.hpp"
#include "sim/solid/whole_patch.hpp"

namespace reye::sim {

namespace {

void add_wear(const contact::SkinWear& wear, const SkinContactRow& row, SkinContactSummary& summary) {
  summary.wears = true;
  summary.secondary = {row.depth_secondary_mm, row.volume_secondary_mm3};
  summary.primary = {row.depth_primary_mm, row.volume_primary_mm3};
  const auto gone = [](double strip, const std::vector<double>& pending) {
    return strip + std::accumulate(pending.begin(), pending.end(), 0.0);
  };
  if (wear.law_volume > 0.0)
    summary.ledger_relative_error = wear::Ledger{wear.law_volume, gone(wear.strip_secondary, wear.pending_secondary),
                                                 gone(wear.strip_primary, wear.pending_primary)}
                                        .relative_error();
}

}  // namespace

SkinContactSummary contact_summary(const SolidProblem& problem, const solver::SolidSystem& system,
                                   const SolidRunState& state, std::size_t c) {
  const auto& options = problem.contacts[c].options;
  const auto row = contact_row(system, state, c);
  SkinContactSummary summary;
  summary.name = options.name;
  summary.normal_force_N = row.normal_force_N;
  summary.tangential_force_N = row.tangential_force_N;
  summary.dissipated_energy_mJ = row.energy_mJ;
  if (state.cycle >= 1.0) summary.energy_last_cycle_mJ = state.energy_last_cycle_mJ[c];
  summary.peak_pressure_MPa = row.pressure_max_MPa;
  const WholePatch patch = whole_patch(problem, system, *state.solved, c);
  summary.area_mm2 = row.area_mm2;
  summary.stick_area_mm2 = row.stick_area_mm2;
  summary.equivalent_radius_mm = std::sqrt(patch.area() / std::numbers::pi);
  summary.half_widths_mm = patch.half_widths();
  if (options.wear.wears()) add_wear(state.solution.wear[c], row, summary);
  return summary;
}

std::map<std::string, Vec3> probe_values(const SolidProblem& problem, const SolidAssembly& assembly,
                                         const SolidRunState& state) {
  std::map<std::string, Vec3> values;
  if (problem.scene.probes.empty()) return values;
  const SolidFrame frame = solid_frame(problem, assembly, state, "", {});
  std::vector<base::Issue> issues;
  for (const auto& probe : problem.scene.probes)
    for (const auto& body : frame.bodies)
      if (body.name == probe.body) {
        const auto place = mesh::place_in(*body.mesh, probe.at_mm);
        Vec3 u = Vec3::Zero();
        for (const auto& [node, share] : place) u += share * body.u[node];
        values[probe.name] = u;
      }
  return values;
}

}  // namespace reye::sim
