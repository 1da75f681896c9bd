#pragma once
#include <string>

#include "runs/calibrate_request.hpp"
#include "scene/scene.hpp"
#include "scene/solid/solid_scene.hpp"
#include "sim/study/calibration.hpp"

/// A calibration as the command and the Python module share it: measurements read, runs played, results written.
namespace reye::apps {

/// The folder that a calibration of this scene writes to.
std::string calibration_folder(const std::string& scene_name, const CalibrateRequest& request);

/// Writes calibration.json, calibration.html, figures and scene.toml, the scene with the fitted values, unless the
/// result has a failure. Throws base::InputError, before anything runs, for measurements or a folder that cannot be
/// used.
sim::Calibration calibrate(const scene::Scene& scene, const CalibrateRequest& request,
                           const sim::CalibrationWatch& watch);
sim::Calibration calibrate(const scene::SolidScene& scene, const CalibrateRequest& request,
                           const sim::CalibrationWatch& watch);

}  // namespace reye::apps
