#pragma once
#include <memory>
#include <string>
#include <vector>

#include "body/solid/solid_body.hpp"
#include "cad/solid/solid_geometry.hpp"
#include "contact/solid/skin_setup.hpp"
#include "scene/solid/solid_scene.hpp"
#include "sim/solid/placed_skins.hpp"
#include "sim/solid/solid_records.hpp"

namespace reye::sim {

/// Everything that does not change in a run of solids.
struct SolidProblem {
  scene::SolidScene scene;
  std::vector<body::SolidInput> inputs;        ///< per body
  std::vector<std::array<int, 2>> support_of;  ///< per support of the scene: its body, and its place there
  std::vector<PlacedSkins> contacts;
  std::vector<Warning> warnings;     ///< known before the run
  std::vector<std::string> decided;  ///< before the run, a sentence each
  double mesh_seconds = 0.0;

  int body_count() const { return static_cast<int>(inputs.size()); }
};

/// The kind of warnings that the geometry gave.
inline constexpr const char* geometry_warning = "geometry";

/// Imports and meshes the geometry, finds the faces by their names and puts supports, loads and contacts onto the
/// bodies. Throws base::InputError with all issues and their lines.
SolidProblem prepare_solid(scene::SolidScene scene);

/// Puts the scene onto geometry that was built before.
SolidProblem prepare_solid(scene::SolidScene scene, cad::SolidGeometry geometry);

}  // namespace reye::sim
