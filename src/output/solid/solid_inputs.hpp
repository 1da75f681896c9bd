#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/space.hpp"
#include "output/folder/folder.hpp"
#include "output/solid/driven_motions.hpp"
#include "scene/solid/solid_scene.hpp"

/// What went into a run of solids, kept in its folder for the report.
namespace reye::output {

/// A table of inputs in words.
struct InputTable {
  std::string title;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

struct SolidInputs {
  std::vector<std::string> contacts, supports;  ///< in the order of the scene
  std::vector<InputTable> tables;
  std::vector<DrivenMotion> motions;
  bool paraview = true;
};

Identity identity_of(const scene::SolidScene& scene);

SolidInputs inputs_of(const scene::SolidScene& scene);

/// inputs.json, and back; throws base::InputError for a file that no run wrote.
std::string inputs_json(const SolidInputs& inputs);
SolidInputs read_inputs(const std::string& path);

}  // namespace reye::output
