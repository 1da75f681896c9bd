#pragma once
#include <string>
#include <utility>
#include <vector>

#include "mesh/solid/solid_mesh.hpp"
#include "scene/solid/solid_scene.hpp"

namespace reye::output {

using BodyMeshes = std::vector<const mesh::SolidMesh*>;

/// A support or a load of a scene of solids: its letter, where it acts, and what it does, in words.
struct SolidAction {
  std::string letter, words;
  const char* colour = nullptr;
  int body = -1;                                      ///< -1: of no body of the scene
  std::string face;                                   ///< empty: the whole body
  std::vector<std::pair<base::Vec3, bool>> arrows{};  ///< unit directions; true: to and fro
};

/// The body that has a face of this name; -1: none.
int body_with_face(const BodyMeshes& bodies, const std::string& face);

/// Supports, then loads, with letters from A on.
std::vector<SolidAction> solid_actions(const scene::SolidScene& scene, const BodyMeshes& bodies);

}  // namespace reye::output
