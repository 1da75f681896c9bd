#pragma once
#include <string>

#include "scene/measured_scars.hpp"

/// Scars as a rig measured them: the input of `reye calibrate` besides the scene.
namespace reye::scene {

/// Reads a CSV file (one scar) or a TOML file (`[[scar]]`, `[[loop]]` and `[[figure]]`, paths beside it). Of CSV
/// columns the names say what they hold: `x_mm`, `y_mm`, `z_mm` or `arc_mm`; `depth_mm`, `depth_um`, `height_mm` or
/// `height_um`; `scatter_mm` or `scatter_um`. A loop counts by its energy. Throws base::InputError with all issues.
MeasuredScars read_scars(const std::string& path, const ScarContext& scene);

/// The table of keys of the TOML file as markdown, for geo/REFERENCE.md.
std::string scar_reference();

}  // namespace reye::scene
