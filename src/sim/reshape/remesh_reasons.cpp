#include <string>

#include "adapt/shape/triggers.hpp"
#include "sim/measure/displacements.hpp"
#include "sim/measure/renewable.hpp"
#include "sim/measure/zones.hpp"
#include "sim/reshape/remesh.hpp"

namespace reye::sim {

namespace {

bool in_contact(const Problem& problem, int body) { return !problem.inputs[body].contact_boundaries.empty(); }

/// The triggers of a body that the wear of a block has moved. `reason`: found so far.
void apply_triggers(const Problem& problem, const State& state, const solver::System& system, int b,
                    const body::Shape& shape, RemeshReason& reason) {
  const auto& triggers = problem.scene.remesh.triggers;
  base::Points x = shape.mesh.X;  // of a linear body, whose strain is small, as good as where its nodes are
  if (is_nonlinear(problem.inputs[b])) {
    const auto u = recovered(problem, state, system, b);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += u[i];
  }
  reason.divide = adapt::largest_size_ratio(shape, x).value > triggers.size_ratio;
  if (reason.text.empty()) reason.text = adapt::why_remesh(shape, can_renew(problem, b) ? nullptr : &x, triggers);
}

/// `worn`: of any body; without wear a fine zone stays as the user gave it.
RemeshReason remesh_reason(const Problem& problem, const State& state, const solver::System& system, int b,
                           const Moved& moved, bool worn) {
  const auto& options = problem.scene.remesh;
  RemeshReason reason;
  if (options.automatic && worn) {
    reason = {leaves_zone(problem, state, b, *moved.shape), true};
    if (!reason.text.empty()) return reason;
    reason = {moved.poor, false};
  }
  if (options.automatic && moved.shape != state.shapes[b])
    apply_triggers(problem, state, system, b, *moved.shape, reason);
  const bool due = options.every_blocks > 0 && (state.counts.blocks + 1) % options.every_blocks == 0;
  if (due && reason.text.empty())
    reason = {"every " + std::to_string(options.every_blocks) + " blocks, as asked for", false};
  return reason;
}

}  // namespace

std::vector<RemeshReason> remesh_reasons(const Problem& problem, const State& state, const solver::System& system,
                                         const std::vector<Moved>& moved) {
  std::vector<RemeshReason> reasons(moved.size());
  bool worn = false;
  for (int b = 0; b < problem.body_count(); ++b) worn = worn || moved[b].shape != state.shapes[b];
  for (int b = 0; b < problem.body_count(); ++b)
    if (!problem.rigid[b] && in_contact(problem, b))
      reasons[b] = remesh_reason(problem, state, system, b, moved[b], worn);
  return reasons;
}

}  // namespace reye::sim
