#pragma once
#include <vector>

#include "scene/scars.hpp"
#include "scene/scene.hpp"
#include "scene/solid/solid_scene.hpp"
#include "sim/study/calibration.hpp"
#include "sim/study/scar_model.hpp"

/// Wear coefficients, and values of other keys, from measured scars and loops of friction.
namespace reye::sim {

/// What the scene says of its measurements.
scene::ScarContext scar_context(const scene::Scene& scene);
scene::ScarContext scar_context(const scene::SolidScene& scene);

/// Fits the common factor of all wear coefficients, or, where both sides of the one contact that wears were measured,
/// each of its two; and the values of `free` keys. Throws base::InputError where the scene cannot take a key's bounds,
/// or does not reach the cycles of the measurements.                                             [sim/README,
/// Calibrate]
Calibration calibrate(const scene::Scene& scene, scene::MeasuredScars measured, std::vector<FreeKey> free,
                      const CalibrationWatch& watch);
Calibration calibrate(const scene::SolidScene& scene, scene::MeasuredScars measured, std::vector<FreeKey> free,
                      const CalibrationWatch& watch);

}  // namespace reye::sim
