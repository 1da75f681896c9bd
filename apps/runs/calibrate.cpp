#include "runs/calibrate.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "output/folder/files.hpp"
#include "output/run/calibration_page.hpp"
#include "scene/rewrite.hpp"
#include "sim/study/calibrate.hpp"

namespace reye::apps {

namespace {

/// A folder is written to where it is new, empty, or holds a calibration.
void check_folder(const std::string& dir, bool force) {
  std::error_code error;
  namespace fs = std::filesystem;
  if (force || !fs::exists(dir, error)) return;
  if (!fs::is_directory(dir, error)) throw base::InputError({{"--out", dir, "is a file"}});
  if (!fs::is_empty(dir, error) && !fs::exists(dir + "/calibration.json", error))
    throw base::InputError(
        {{"--out", dir, "holds something else than a calibration; name another folder, or use --force"}});
}

/// "contact.pad.friction=0.2:0.9"
std::vector<sim::FreeKey> free_keys(const std::vector<std::string>& words) {
  std::vector<sim::FreeKey> keys;
  std::vector<base::Issue> issues;
  for (const auto& text : words) {
    const auto equal = text.find('=');
    sim::FreeKey key{text.substr(0, equal)};
    char rest = 0;
    const bool two = equal != std::string::npos &&
                     std::sscanf(text.c_str() + equal + 1, "%lf:%lf%c", &key.low, &key.high, &rest) == 2;
    if (two && std::isfinite(key.low) && std::isfinite(key.high) && key.low < key.high)
      keys.push_back(key);
    else
      issues.push_back({"--free", text, "must be KEY=LOW:HIGH, two numbers of which the first is less"});
  }
  if (!issues.empty()) throw base::InputError(std::move(issues));
  return keys;
}

/// The scene with the fitted values, and the interval of the coefficients as scatter of its lives.
template <class Scene>
std::string fitted_scene(const Scene& scene, const sim::Calibration& result) {
  std::string text = scene.text;
  const auto set = [&](const std::string& key, const std::string& value) {
    auto changed = scene::with_value(text, key, value);
    if (!changed) throw std::runtime_error("the fitted scene cannot hold " + key + " = " + value);
    text = std::move(*changed);
  };
  for (const auto& value : result.values) set(value.key, base::formatted("%.6g", value.fitted));
  const bool coefficients = !result.values.empty() && result.values.front().coefficient;
  for (const auto& limit : scene.limits)
    if (result.scales && coefficients)
      set("limit." + limit.name + ".wear_factor", base::formatted("[%.5g, %.5g]", result.low, result.high));
  return scene::with_absolute_paths(std::move(text), scene.path);
}

template <class Scene>
void write(const Scene& scene, const sim::Calibration& result, const std::string& dir) {
  std::filesystem::create_directories(dir + "/figures");
  for (const auto& figure : output::calibration_figures(result))
    output::replace_text(dir + "/figures/" + figure.id + ".svg", output::svg(figure));
  output::atomic_write(dir + "/scene.toml", fitted_scene(scene, result));
  output::replace_text(dir + "/calibration.html", output::calibration_page(scene.title, result));
  output::atomic_write(dir + "/calibration.json", output::calibration_json(scene.title, result));
}

template <class Scene>
sim::Calibration calibrated(const Scene& scene, const CalibrateRequest& request, const sim::CalibrationWatch& watch) {
  const auto dir = calibration_folder(scene.name, request);
  check_folder(dir, request.force);
  auto free = free_keys(request.free);
  auto context = sim::scar_context(scene);
  context.at_cycles = request.at;
  context.contact = request.contact;
  context.side = request.side;
  auto result = sim::calibrate(scene, scene::read_scars(request.measured, context), std::move(free), watch);
  if (result.failure.empty()) write(scene, result, dir);
  return result;
}

}  // namespace

std::string calibration_folder(const std::string& scene_name, const CalibrateRequest& request) {
  return request.out.empty() ? "./" + scene_name + ".calibration" : request.out;
}

sim::Calibration calibrate(const scene::Scene& scene, const CalibrateRequest& request,
                           const sim::CalibrationWatch& watch) {
  return calibrated(scene, request, watch);
}

sim::Calibration calibrate(const scene::SolidScene& scene, const CalibrateRequest& request,
                           const sim::CalibrationWatch& watch) {
  return calibrated(scene, request, watch);
}

}  // namespace reye::apps
