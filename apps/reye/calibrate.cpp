#include "calibrate.hpp"

#include <cstdio>

#include "base/printable.hpp"
#include "scene/read.hpp"
#include "scene/solid/solid_scene.hpp"
#include "signals.hpp"
#include "sim/problem/warnings.hpp"

namespace reye::apps {

namespace {

void warn(const std::string& text) { std::fprintf(stderr, "warning: %s\n", base::printable(text).c_str()); }

void tell_result(const sim::Calibration& result, const std::string& dir) {
  std::printf("%-44s %12s %12s   95 %% interval\n", "key", "scene", "fitted");
  for (const auto& value : result.values)
    std::printf("%-44s %12.4g %12.4g   %.4g to %.4g\n", base::printable(value.key).c_str(), value.scene, value.fitted,
                value.low, value.high);
  for (const auto& note : result.notes) std::printf("%s\n", base::printable(note).c_str());
  if (!result.estimate.poor.empty()) warn("the fit is poor: " + result.estimate.poor);
  for (const auto& text : result.measured.warnings) warn(text);
  for (const auto& warning : result.warnings) warn(sim::in_words(warning));
  const auto shown = base::printable(dir);
  std::printf("page %s/calibration.html, scene with these values %s/scene.toml\n", shown.c_str(), shown.c_str());
}

}  // namespace

int calibrate(const std::string& scene_path, const CalibrateRequest& request, bool trust_geometry, bool quiet) {
  ignore_lost_output();
  sim::CalibrationWatch watch;
  watch.told = [&](const std::string& sentence) {
    if (!quiet) std::fprintf(stderr, "%s\n", sentence.c_str());
  };
  const auto fitted = [&](auto scene) {
    scene.geometry.trusted = trust_geometry;
    const auto result = calibrate(scene, request, watch);
    if (!result.failure.empty()) {
      std::fprintf(stderr, "reye: %s\n", base::printable(result.failure).c_str());
      return 1;
    }
    tell_result(result, calibration_folder(scene.name, request));
    return 0;
  };
  return scene::is_solid(scene_path) ? fitted(scene::read_solid(scene_path)) : fitted(scene::read(scene_path));
}

}  // namespace reye::apps
