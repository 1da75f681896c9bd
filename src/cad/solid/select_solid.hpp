#pragma once
#include <map>
#include <optional>

#include "cad/solid/raw_solid.hpp"
#include "cad/solid/solid_options.hpp"

namespace reye::cad {

/// The points of the options that are sought in solids and on faces, each by its place among the probes.
struct SolidProbes {
  Points3 points;
  std::vector<int> of_bodies, of_faces;  ///< -1: without point
  std::vector<int> of_zones;
};

SolidProbes probes_of(const SolidGeometryOptions& options);

/// A body with its solid, and its named faces by their places in the solid's list.
struct SolidPlan {
  const SolidBodyOptions* options = nullptr;
  const RawSolid* solid = nullptr;
  std::map<std::string, std::vector<int>> faces;
};

/// Finds the solid of every body and the faces of every name; also physical surfaces keep their names. Adds an issue
/// for each selector that matches nothing or several things, bodies of one solid, and bodies that share a face of it.
std::vector<SolidPlan> plan_solids(const std::vector<RawSolid>& solids, const SolidGeometryOptions& options,
                                   const SolidProbes& probes, std::vector<base::Issue>& issues);

/// How each is meshed: its far size and the fine zones that name it. Adds an issue for a zone that no body reaches, and
/// for a body of too many nodes.
SolidOrder order_of(const SolidPlan& plan, const SolidGeometryOptions& options, std::vector<base::Issue>& issues);
void check_zones(const std::vector<SolidPlan>& plans, const SolidGeometryOptions& options, const SolidProbes& probes,
                 std::vector<base::Issue>& issues);

}  // namespace reye::cad
