#pragma once
#include <string>
#include <vector>

#include "cad/build/body_plan.hpp"

namespace reye::cad {

/// The fine zones of a scene that refine the body of this name: those of which its outline passes within half_width +
/// depth of the centre. A zone that names the body refines it from farther away, too, where no other one of its contact
/// is so near.
std::vector<const FineZone*> zones_on(const Part& part, const std::string& body, const std::vector<FineZone>& zones);

/// Element size far from fine zones: as asked for, or a twentieth of the body's bounding-box diagonal [mm].
double far_size(const BodyPlan& plan);

/// Nodes that a mesh of the plan would have, about: int dA / size^2 over the body and its fine zones.
double estimated_nodes(const BodyPlan& plan);

/// Finds parts and boundaries of all bodies, takes the halves x >= 0 of sections on both sides of the axis, puts
/// profiles on the boundaries that have one, finds fine zones. Throws base::InputError with every issue there is:
/// selectors that match nothing or several things, sections that are not mirror-symmetric about the axis, profiles that
/// do not fit, material at a negative radius, a mesh of more nodes than a body may have.
Plans make_plans(std::vector<Part> parts, const GeometryOptions& options);

}  // namespace reye::cad
