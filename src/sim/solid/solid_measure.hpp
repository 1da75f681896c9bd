#pragma once
#include <optional>

#include "sim/solid/solid_state.hpp"

/// What is seen of an increment that was solved.
namespace reye::sim {

/// Work that friction dissipated in the increment, per contact: sum of covered area x shear . slip [mJ].
std::vector<double> dissipated(const solver::SolidSolution& solution);

SkinContactRow contact_row(const solver::SolidSolution& solution, std::size_t contact, double friction,
                           double energy_mJ);

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

SolidFrame solid_frame(const SolidProblem& problem, const SolidAssembly& assembly,
                       const solver::SolidSolution& solution, const SolidRunState& state, const std::string& step,
                       double progress, bool bodies);

SkinContactSummary contact_summary(const SolidProblem& problem, const solver::SolidSystem& system,
                                   const solver::SolidSolution& solution, std::size_t contact,
                                   const SolidRunState& state);

/// Displacements of the probes. Throws base::InputError for a point outside of its body.
std::map<std::string, Vec3> probe_values(const SolidProblem& problem, const SolidAssembly& assembly,
                                         const solver::SolidSolution& solution);

}  // namespace reye::sim
