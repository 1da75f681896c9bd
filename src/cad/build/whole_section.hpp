#pragma once
#include <vector>

#include "base/issue.hpp"
#include "cad/build/body_plan.hpp"

/// Axisymmetric scenes whose files have the whole section through the axis instead of its half x >= 0.
namespace reye::cad {

/// Leaves out faces at x < 0 that are mirror images of others: a hollow solid's section through its axis has two faces.
void leave_out_mirror_images(std::vector<Part>& parts);

/// Says what to give for points at x < 0 that have selected no body.
void tell_of_the_half(const std::vector<BodyOptions>& bodies, std::vector<base::Issue>& issues);

/// Replaces parts on both sides of the axis by their halves x >= 0, with their boundaries. Issues: a section that is
/// not mirror-symmetric, with the sizes that differ; a boundary that selects an edge at x < 0 and not its mirror image,
/// or has a profile.
void take_halves(Plans& plans, const GeometryOptions& options, std::vector<base::Issue>& issues);

}  // namespace reye::cad
