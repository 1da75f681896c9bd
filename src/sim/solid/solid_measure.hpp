#pragma once
#include <optional>

#include "sim/solid/solid_state.hpp"

/// What is seen of an increment that was solved.
namespace reye::sim {

/// A contact at the end of the increment that led to a state.
SkinContactRow contact_row(const solver::SolidSystem& system, const SolidRunState& state, std::size_t contact);

/// Forces of contacts on the points of a body [N].
base::Vector forces_on(const solver::SolidSystem& system, const solver::SolidSolution& solution, std::size_t body);

std::vector<SupportRow> support_rows(const SolidProblem& problem, const solver::SolidSystem& system,
                                     const solver::SolidSolution& solution);

/// Of all bodies the largest sum of the forces of contacts, supports and loads, and the largest of these forces;
/// moments about the middle of a body's box count over its size [N].
struct BalanceOfBodies {
  double left_N = 0.0, largest_N = 0.0;
};
BalanceOfBodies balance_of_bodies(const SolidProblem& problem, const solver::SolidSystem& system,
                                  const solver::SolidSolution& solution);

/// The moment of a frame, and whether it shows the bodies.
struct FrameMoment {
  double cycle = 0.0, progress = 0.0;
  bool bodies = true;
};

SolidFrame solid_frame(const SolidProblem& problem, const SolidAssembly& assembly, const SolidRunState& state,
                       const std::string& step, const FrameMoment& moment);

SkinContactSummary contact_summary(const SolidProblem& problem, const solver::SolidSystem& system,
                                   const SolidRunState& state, std::size_t contact);

/// Displacements of the probes. Throws base::InputError for a point outside of its body.
std::map<std::string, Vec3> probe_values(const SolidProblem& problem, const SolidAssembly& assembly,
                                         const SolidRunState& state);

}  // namespace reye::sim
