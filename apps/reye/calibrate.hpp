#pragma once
#include <string>
#include <vector>

/// `reye calibrate`: wear coefficients of a scene from scars that a rig has measured.
namespace reye::apps {

struct CalibrateRequest {
  std::string path, measured;
  std::vector<std::string> free;  ///< KEY=LOW:HIGH
  std::string contact, side;      ///< of measurements that name none
  std::string out;                ///< folder; empty: ./<scene name>.calibration
  double at = 0.0;                ///< cycles of measurements that name none
  int threads = 0;
  bool trust_geometry = false, force = false, quiet = false;
};

/// Writes calibration.json, calibration.html, figures and scene.toml, the scene with the coefficients. 0 done, 1 the
/// scars cannot be fitted or a run failed.
int calibrate(const CalibrateRequest& request);

}  // namespace reye::apps
