#pragma once
#include "adapt/solid/isotropic.hpp"
#include "adapt/solid/skin_locator.hpp"
#include "mesh/solid/solid_mesh.hpp"

namespace reye::adapt {

/// Moves points of a patch along its normals by the mean height of another surface over them, int N_k h dA / int N_k
/// dA, so that each keeps its content. Those that are not `movable` stay.
void keep_heights(const SkinLocator& other, Points3& X, const std::vector<PatchTriangle>& triangles,
                  const std::vector<char>& movable);

/// Volume within a closed skin [mm^3] with the digits of a small change of it.
long double content_of(const Points3& X, const std::vector<mesh::Facet>& skin);

/// Moves the `movable` nodes of a skin along their normals, all by one length, until it holds `content` to round-off.
/// Returns that length [mm]; nothing happens without movable nodes.
double restore_content(Points3& X, const std::vector<mesh::Facet>& skin, const std::vector<char>& movable,
                       long double content);

}  // namespace reye::adapt
