#include "calibrate.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "base/printable.hpp"
#include "output/folder/files.hpp"
#include "output/folder/text.hpp"
#include "output/run/calibration_page.hpp"
#include "scene/read.hpp"
#include "scene/rewrite.hpp"
#include "scene/solid/solid_scene.hpp"
#include "signals.hpp"
#include "sim/problem/warnings.hpp"
#include "sim/study/calibrate.hpp"

namespace reye::apps {

namespace {

/// A scene of any kind as far as calibration reads it.
struct Read {
  std::string name, title, text;
  std::vector<std::string> limits;
  sim::Calibration result;
};

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

template <class Scene>
Read calibrated(Scene scene, const CalibrateRequest& request, const std::string& dir) {
  check_folder(dir, request.force);
  auto context = sim::scar_context(scene);
  context.at_cycles = request.at;
  context.contact = request.contact;
  context.side = request.side;
  auto measured = scene::read_scars(request.measured, context);
  for (const auto& warning : measured.warnings) std::fprintf(stderr, "warning: %s\n", base::printable(warning).c_str());
  scene.geometry.trusted = request.trust_geometry;
  const auto told = [&](const std::string& sentence) {
    if (!request.quiet) std::fprintf(stderr, "%s\n", sentence.c_str());
  };
  Read read{scene.name,
            scene.title,
            scene.text,
            {},
            sim::calibrate(scene, std::move(measured), free_keys(request.free), told)};
  for (const auto& limit : scene.limits) read.limits.push_back(limit.name);
  return read;
}

/// The scene with the fitted coefficients, and the interval as scatter of its lives.
std::string fitted_scene(const Read& read, const std::string& path) {
  std::string text = read.text;
  const auto set = [&](const std::string& key, const std::string& value) {
    if (auto changed = scene::with_value(text, key, value))
      text = std::move(*changed);
    else
      throw std::runtime_error("the fitted scene cannot hold " + key + " = " + value);
  };
  for (const auto& k : read.result.values) set(k.key, base::formatted("%.6g", k.fitted));
  for (const auto& name : read.limits)
    if (read.result.scales)
      set("limit." + name + ".wear_factor", base::formatted("[%.5g, %.5g]", read.result.low, read.result.high));
  return scene::with_absolute_paths(std::move(text), path);
}

void write(const Read& read, const std::string& dir, const std::string& path) {
  std::filesystem::create_directories(dir + "/figures");
  for (const auto& figure : output::calibration_figures(read.result))
    output::replace_text(dir + "/figures/" + figure.id + ".svg", output::svg(figure));
  output::atomic_write(dir + "/scene.toml", fitted_scene(read, path));
  output::replace_text(dir + "/calibration.html", output::calibration_page(read.title, read.result));
  output::atomic_write(dir + "/calibration.json", output::calibration_json(read.title, read.result));
}

void tell(const Read& read, const std::string& dir) {
  std::printf("%-44s %12s %12s   95 %% interval\n", "key", "scene", "fitted");
  for (const auto& k : read.result.values)
    std::printf("%-44s %12.4g %12.4g   %.4g to %.4g\n", base::printable(k.key).c_str(), k.scene, k.fitted, k.low,
                k.high);
  for (const auto& note : read.result.notes) std::printf("%s\n", base::printable(note).c_str());
  if (!read.result.estimate.poor.empty())
    std::fprintf(stderr, "warning: the fit is poor: %s\n", base::printable(read.result.estimate.poor).c_str());
  for (const auto& warning : read.result.warnings)
    std::fprintf(stderr, "warning: %s\n", base::printable(sim::in_words(warning)).c_str());
  const auto shown = base::printable(dir);
  std::printf("page %s/calibration.html, scene with these coefficients %s/scene.toml\n", shown.c_str(), shown.c_str());
}

}  // namespace

int calibrate(const CalibrateRequest& request) {
  ignore_lost_output();
  const bool solid = scene::is_solid(request.path);
  const auto dir_of = [&](const auto& scene) {
    return request.out.empty() ? "./" + scene.name + ".calibration" : request.out;
  };
  std::string dir;
  const auto fitted = [&](auto scene) {
    dir = dir_of(scene);
    return calibrated(std::move(scene), request, dir);
  };
  const Read read = solid ? fitted(scene::read_solid(request.path)) : fitted(scene::read(request.path));
  if (!read.result.failure.empty()) {
    std::fprintf(stderr, "reye: %s\n", base::printable(read.result.failure).c_str());
    return 1;
  }
  write(read, dir, request.path);
  tell(read, dir);
  return 0;
}

}  // namespace reye::apps
