#pragma once
#include <string>

#include "runs/calibrate.hpp"

namespace reye::apps {

/// `reye calibrate` on the terminal. 0 done, 1 the measurements cannot be fitted or a run failed.
int calibrate(const std::string& scene_path, const CalibrateRequest& request, bool trust_geometry, bool quiet);

}  // namespace reye::apps
