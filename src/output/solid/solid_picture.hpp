#pragma once
#include <string>
#include <vector>

#include "body/solid/solid_body.hpp"
#include "mesh/solid/solid_mesh.hpp"
#include "scene/solid/solid_scene.hpp"

namespace reye::output {

/// The scene of solids before its run as one SVG picture that stands alone: an axonometric view of the skins, hidden
/// parts covered, with feature edges; bodies and what they are made of, named faces and both sides of contacts in
/// colour, supports and loads by letters that the key below explains with their values and histories, fine zones, axes
/// and a bar of size; the histories as small curves. A second view from the other side shows what the first hides.
/// `bodies`: the meshes in the order of the scene's bodies, of which a rigid one may have a skin alone.
std::string solid_picture(const scene::SolidScene& scene, const std::vector<const mesh::SolidMesh*>& bodies);
std::string solid_picture(const scene::SolidScene& scene, const std::vector<mesh::SolidMesh>& bodies);
std::string solid_picture(const scene::SolidScene& scene, const std::vector<body::SolidInput>& bodies);

}  // namespace reye::output
