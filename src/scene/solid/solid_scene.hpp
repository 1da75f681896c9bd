#pragma once
#include <map>
#include <string>
#include <vector>

#include "adapt/solid/solid_triggers.hpp"
#include "body/solid/solid_supports.hpp"
#include "cad/solid/solid_options.hpp"
#include "contact/solid/skin_options.hpp"
#include "material/material.hpp"
#include "scene/scene.hpp"

namespace reye::scene {

struct SolidProbe {
  std::string name;
  std::string body;
  base::Vec3 at_mm = base::Vec3::Zero();
};

/// When a worn solid is remeshed.
struct SolidRemesh {
  bool automatic = true;  ///< false: a body that must be remeshed ends the run
  int every_blocks = 0;   ///< 0: only when a trigger asks for it
  adapt::SolidTriggers triggers;
};

/// The input of a scene with analysis = "solid".
struct SolidScene {
  std::string title;
  double accuracy = 0.0;  ///< relative, for sizes and jumps left open; 0: none
  cad::SolidGeometryOptions geometry;
  std::map<std::string, material::Material> materials;
  std::map<std::string, std::string> body_material;  ///< by body name; none for a rigid body
  std::vector<contact::SkinContactOptions> contacts;
  std::vector<std::string> symmetry;  ///< faces without motion along their normal, as supports: they stand in both
  std::vector<body::SolidSupport> supports;
  std::vector<body::SolidLoad> loads;
  std::map<std::string, History> histories;
  std::map<std::string, Measured> measured;  ///< those of them that come from files
  std::vector<Step> steps;
  std::vector<Limit> limits;
  bool shape = true;  ///< false (shape = "off"): wear stays in the gap
  SolidRemesh remesh;
  FrameRules frames;
  int history_every_blocks = 1;
  double checkpoint_s = 1.0;
  bool estimate_error = false;  ///< of the mesh, by a companion run
  std::vector<SolidProbe> probes;
  int max_newton = 30;
  int max_cutbacks = 8;

  // Where the scene came from, as in Scene.
  std::string name, path, text, sha256, fixed_sha256;
  std::map<std::string, int> lines;
  std::vector<std::string> warnings;
  std::map<std::string, std::string>
      file_sha256;  ///< of geometry and measured histories, by their paths from the scene
};

/// Whether the scene at this path says analysis = "solid". A file that cannot be read says no: reading it gives the
/// reason.
bool is_solid(const std::string& path);

/// Whether the text of a scene says so; one that is not TOML says no.
bool is_solid_text(const std::string& text);

/// Reads and checks; throws base::InputError with every issue, as `read` does for scenes of the plane.
SolidScene read_solid(const std::string& path);

}  // namespace reye::scene
