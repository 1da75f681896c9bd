#pragma once
#include <string>

#include "sim/problem/problem.hpp"

namespace reye::output {

/// The scene before its run as one SVG picture that stands alone: the whole assembly and, for up to three contacts, the
/// place where their sides are nearest. Bodies with mesh, both sides of contacts, supports and loads by letters that
/// the key below explains with their values and histories, fine zones, gaps and overlaps of the drawing with their
/// size; the histories as small curves.
std::string scene_picture(const sim::Problem& problem);

}  // namespace reye::output
