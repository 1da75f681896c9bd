#pragma once
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "sim/problem/problem.hpp"
#include "sim/solid/solid_plan.hpp"
#include "sim/solid/solid_problem.hpp"

/// Problems in words, as `reye check` and `reye plan` print them.
namespace reye::apps {

/// A sentence per warning; those about a table of a plane scene begin with its line.
std::vector<std::string> in_words(const scene::Scene& scene, const std::vector<sim::Warning>& warnings);
std::vector<std::string> in_words(const std::vector<sim::Warning>& warnings);

/// A line per body and per boundary: contents, boxes, lengths in mm, numbers of nodes and cells.
std::vector<std::string> body_lines(const sim::Problem& problem);
std::vector<std::string> body_lines(const sim::SolidProblem& problem);

/// Throws base::InputError where the problem cannot run on this machine.
void refuse_what_does_not_fit(const sim::SolidPlan& plan);

}  // namespace reye::apps
