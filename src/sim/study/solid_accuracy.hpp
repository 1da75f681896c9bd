#pragma once
#include <optional>
#include <string>
#include <vector>

#include "sim/solid/solid_problem.hpp"

namespace reye::sim {

/// Gives the fine zones of a scene of solids that name no size (0) one that suits its accuracy, and reports what it
/// did, a sentence each; nothing where all have a size. As in the plane (`accuracy`): a pilot, the whole run on few
/// elements with its companion (`mesh_error`), estimates an error e_0 of order p on n_0 elements per radius or least
/// half width; n = n_0 (e_0 / e)^(1/p) then has the error e wanted. Deterministic. Throws base::InputError at
/// `accuracy`: no pilot gives an error, or n > 80.
std::vector<std::string> choose_sizes(scene::SolidScene& scene);

/// The problem of a scene once its sizes are chosen; `geometry`: what was built before, if it was.
SolidProblem prepare(scene::SolidScene scene, std::optional<cad::SolidGeometry> geometry = {});

}  // namespace reye::sim
