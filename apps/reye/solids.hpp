#pragma once
#include "commands.hpp"

/// The commands for scenes of solids; exit codes as those of the plane.
namespace reye::apps {

int run_solid(const Request& request);
int plan_solid(const Request& request);
int check_solid(const Request& request);
int mesh_solid(const Request& request);

}  // namespace reye::apps
