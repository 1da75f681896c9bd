#pragma once
#include <array>
#include <memory>
#include <optional>

#include "sim/solid/touchable.hpp"

namespace reye::sim {

/// The equations of a problem on the nodes that may touch.
struct SolidAssembly {
  solver::SolidSystem system;
  contact::Columns columns;  ///< per body and node
  double seconds = 0.0;      ///< of CPU, for stiffness and factors
  int factorised = 0;        ///< bodies that were condensed for it
};

/// Body and node of the points of a contact, whose values a state holds.
struct SkinPoints {
  std::vector<std::array<int, 2>> secondary, primary;
  bool operator==(const SkinPoints&) const = default;
};
std::vector<SkinPoints> points_of(const solver::SolidSystem& system);

/// Condenses every body of these shapes onto its touchable nodes; bodies of `old` that are the same are taken from it,
/// factors of the others serve again where they fit. Throws base::SolveError.
SolidAssembly assemble(const SolidProblem& problem, const SolidMeshes& meshes, const Touchable& touchable,
                       std::optional<SolidAssembly> old = {});

/// Puts the contacts onto these shapes, whose nodes are those of the equations.
void set_contacts(const SolidProblem& problem, const SolidMeshes& meshes, SolidAssembly& assembly);

/// The state carried onto equations with other points: values stay with their nodes.
solver::SolidState carried(const std::vector<SkinPoints>& from, const solver::SolidSystem& to,
                           const solver::SolidState& state);

/// Values of wear alone, likewise.
std::vector<contact::SkinWear> carried_wear(const std::vector<SkinPoints>& from, const solver::SolidSystem& to,
                                            const std::vector<contact::SkinWear>& wear);

/// Whether a point presses whose facets were left out on one side: the contact has outrun its touchable nodes.
bool outrun(const solver::SolidSystem& system, const solver::SolidSolution& solution);

}  // namespace reye::sim
