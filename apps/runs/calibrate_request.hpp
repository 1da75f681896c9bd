#pragma once
#include <string>
#include <vector>

namespace reye::apps {

/// What a calibration reads besides the scene, and where it writes.
struct CalibrateRequest {
  std::string measured;           ///< CSV or TOML file
  std::vector<std::string> free;  ///< KEY=LOW:HIGH
  double at = 0.0;                ///< cycles of measurements that name none; 0: each must
  std::string contact, side;      ///< of those that name none
  std::string out;                ///< folder; empty: ./<scene name>.calibration
  bool force = false;             ///< writes into a folder that holds something else
};

}  // namespace reye::apps
