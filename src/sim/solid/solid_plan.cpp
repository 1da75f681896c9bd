#include "sim/solid/solid_plan.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "adapt/solid/solid_remesh.hpp"
#include "algebra/ranks.hpp"
#include "base/formatted.hpp"
#include "body/solid/solid_cost.hpp"
#include "sim/problem/rules.hpp"
#include "sim/problem/two_step.hpp"
#include "sim/solid/solid_increments.hpp"

namespace reye::sim {

namespace {

double memory_of_machine_MB() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE)) / 1e6;
}

std::string kind_of(const mesh::SolidMesh& mesh) {
  return mesh.kind == mesh::SolidKind::tet4 ? "tet4" : mesh.kind == mesh::SolidKind::tet10 ? "tet10" : "hex8";
}

/// Where a factor is held, if not in this process alone.
std::string on_ranks(int ranks) {
  return ranks > 1 ? base::formatted(" on the largest of %d ranks", ranks) : std::string();
}

/// How often a step is played: blocks of a fixed number of cycles, or, under a tolerance, of numbers that are taken to
/// grow by half from block to block, to a tenth of the step, each played three times, or once where they continue.
double plays_of(const scene::Step& step, bool continued) {
  if (step.cycles <= 0.0) return 1.0;
  if (!under_tolerance(step)) return std::ceil(step.cycles / step.jump - 1e-9);
  double plays = 0.0, jump = step.jump;
  for (double done = 0.0; done < step.cycles; done += jump) {
    plays += continued && done > 0.0 ? 1.0 : 3.0;
    jump = std::min({1.5 * jump, std::max(jump, 0.1 * step.cycles), step.jump_most});
  }
  return plays;
}

}  // namespace

double solid_increments(const SolidProblem& problem) {
  double count = 0.0;
  const bool continued = may_continue(problem.contacts);
  for (const auto& step : problem.scene.steps)
    count += static_cast<double>(solid_increment_ends(problem.scene, step).size()) * plays_of(step, continued);
  return count;
}

SolidSize size_of(const SolidProblem& problem, int retained) {
  SolidSize size;
  size.retained = retained;
  for (const auto& input : problem.inputs) {
    size.nodes += input.mesh->node_count();
    size.cells += input.mesh->cell_count();
    if (!input.rigid) size.dofs += 3 * input.mesh->node_count();
  }
  return size;
}

SolidPlan solid_plan(const SolidProblem& problem) {
  SolidPlan plan;
  plan.lines = problem.decided;
  const Touchable touchable = touchable_nodes(problem, drawn_meshes(problem));
  double active = 0.0, factors_s = 0.0, others_MB = 0.0;
  for (std::size_t b = 0; b < problem.inputs.size(); ++b) {
    const auto& input = problem.inputs[b];
    std::vector<int> nodes;
    for (std::size_t n = 0; n < touchable[b].size(); ++n)
      if (touchable[b][n]) nodes.push_back(static_cast<int>(n));
    const int kept = static_cast<int>(nodes.size());
    plan.size.retained += kept;
    if (input.rigid) {
      plan.lines.push_back("body " + input.name + ": rigid, no elements");
      continue;
    }
    const auto cost = body::solid_cost(*input.mesh, nodes);
    plan.size.memory_MB += cost.memory_MB;
    factors_s += cost.seconds;
    if (cost.ranks > 1) others_MB += (algebra::ranks_here() - 1) * cost.memory_MB;
    plan.lines.push_back(base::formatted(
        "body %s: %d %s, %d dofs, %d nodes kept for contact; factors %.2g s, %.0f MB%s", input.name.c_str(),
        input.mesh->cell_count(), kind_of(*input.mesh).c_str(), 3 * input.mesh->node_count(), kept, cost.seconds,
        cost.memory_MB, on_ranks(cost.ranks).c_str()));
    if (problem.scene.remesh.every_blocks > 0 && !adapt::can_be_remeshed(*input.mesh))
      plan.lines.push_back("body " + input.name +
                           ": hexahedra are not remeshed, though remesh.every_blocks asks for it");
  }
  if (!problem.scene.remesh.automatic)
    plan.lines.push_back("remesh.automatic = false: a body that must be remeshed ends the run");
  for (const auto& contact : problem.contacts) {
    const auto& nodes = touchable[contact.secondary.body];
    active = std::max(active, 0.5 * static_cast<double>(std::count(nodes.begin(), nodes.end(), 1)));
  }
  const double memory = plan.size.memory_MB;
  const int retained = plan.size.retained;
  plan.size = size_of(problem, retained);
  const double unknowns = 2.2 * active;  // of half the secondary nodes, slipping or sticking
  const double step_s = std::pow(unknowns, 3.0) * 2.5e-11 + 1e-7 * unknowns * unknowns + 1e-5 * retained;
  plan.increments = solid_increments(problem);
  plan.size.memory_MB = memory + 8e-6 * unknowns * unknowns;
  plan.size.seconds = factors_s + 5.0 * plan.increments * step_s;
  plan.lines.push_back(
      base::formatted("contact: about %.0f unknowns, %.2g s an iteration; %.0f increments, %.2g s in all, "
                      "%.0f MB",
                      unknowns, step_s, plan.increments, plan.size.seconds, plan.size.memory_MB));
  if (plan.size.memory_MB + others_MB > memory_of_machine_MB())
    plan.refusal = base::formatted(
        "the run needs about %.0f MB of memory, this machine has %.0f MB: make the mesh coarser "
        "away from contacts (far_size_mm, growth) or fine zones smaller, or let ranks on several machines share it "
        "(mpirun, of a build with REYE_MPI)",
        plan.size.memory_MB + others_MB, memory_of_machine_MB());
  return plan;
}

}  // namespace reye::sim
