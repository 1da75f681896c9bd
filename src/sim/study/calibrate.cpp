#include "sim/study/calibrate.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "scene/located.hpp"
#include "scene/read.hpp"
#include "scene/rewrite.hpp"
#include "scene/solid/solid_located.hpp"
#include "scene/solid/validate_solid.hpp"
#include "scene/validate.hpp"
#include "sim/study/scar_search.hpp"

namespace reye::sim {

namespace {

using scene::MeasuredScars;

/// The number at a key in the scene's text; nothing where there is none.
std::optional<double> number_at(const scene::Node& node, const std::string& key) {
  if (node.key == key) return node.is_number() ? std::optional(node.number) : std::nullopt;
  for (const auto& child : node.children)
    if (const auto found = number_at(child, key)) return found;
  return {};
}

scene::Scene read_again(const scene::Scene& scene, const std::string& text) {
  return scene::read_text(text, scene.path);
}
scene::SolidScene read_again(const scene::SolidScene& scene, const std::string& text) {
  return scene::read_solid_text(text, scene.path);
}

/// The scene with values at keys replaced.
template <class Scene>
Scene changed(const Scene& scene, const KeyValues& values) {
  if (values.empty()) return scene;
  std::string text = scene.text;
  for (const auto& [key, value] : values) {
    auto with = scene::with_value(text, key, base::formatted("%.12g", value));
    if (!with) throw base::InputError({{"--free", key, "the scene cannot hold this key"}});
    text = std::move(*with);
  }
  Scene result = read_again(scene, text);
  result.geometry.trusted = scene.geometry.trusted;
  return result;
}

template <class Scene>
ScarScene scar_scene(const Scene& scene, const MeasuredScars& measured) {
  ScarScene result;
  for (const auto& contact : scene.contacts) result.contacts.push_back({contact.name, contact.wear});
  result.no_scaling = no_band_rule(scene);
  for (const auto& step : scene.steps) result.cycles += step.cycles;
  result.number_at = [document = scene::document_of(scene.text, scene.path)](const std::string& key) {
    return number_at(document, key);
  };
  result.check = [&scene](const KeyValues& values) { changed(scene, values); };
  result.play = [&](const KeyValues& values, const WearFactors& factors, double cycles, const ScarStop& stop) {
    return play_scars(changed(scene, values), measured, factors, cycles, stop);
  };
  return result;
}

/// Coefficients in the unit of their keys.
void set_coefficients(const ScarScene& scene, const ScarParameters& parameters, Calibration& result) {
  const auto& e = result.estimate;
  for (const auto& [name, wear] : scene.contacts)
    for (const bool primary : {false, true}) {
      double own = primary ? wear.primary : wear.secondary;
      if (parameters.factors == 0 || !wear.wears() || !(own > 0.0)) continue;
      const bool energy = wear.kind == wear::LawKind::energy;
      if (energy) own *= 1e3;  // from mm^2/N
      const char* unit = energy ? "_mm3_per_J" : wear.kind == wear::LawKind::archard ? "_per_MPa" : "_mm_per_mm";
      const Eigen::Index k = parameters.factors == 2 && primary ? 1 : 0;
      const double fitted = std::exp(e.theta[k]), low = std::exp(e.low[k]), high = std::exp(e.high[k]);
      result.values.push_back({"contact." + name + ".wear." + (primary ? "primary" : "secondary") + unit, own,
                               own * fitted, own * low, own * high});
      result.low = std::min(result.low, low / fitted);
      result.high = std::max(result.high, high / fitted);
    }
}

/// Values of free keys; one beyond its bounds is named in the notes.
void set_keys(const ScarScene& scene, const ScarParameters& parameters, Calibration& result) {
  const auto& e = result.estimate;
  for (std::size_t i = 0; i < parameters.keys.size(); ++i) {
    const auto& [key, low, high] = parameters.keys[i];
    const auto k = parameters.factors + static_cast<Eigen::Index>(i);
    const auto value = [&, from = low, to = high](double share) { return from + share * (to - from); };
    result.values.push_back({key, scene.number_at(key).value_or(NAN), parameters.value_of(e.theta, i), value(e.low[k]),
                             value(e.high[k]), false});
    if (e.theta[k] < 0.0 || e.theta[k] > 1.0)
      result.notes.push_back(
          base::formatted("The measurements ask for %s = %.4g, beyond the bounds %g to %g; the bound "
                          "was taken.",
                          key.c_str(), value(e.theta[k]), low, high));
  }
}

template <class Scene>
Calibration calibrated(const Scene& scene, MeasuredScars measured, std::vector<FreeKey> free,
                       const CalibrationWatch& watch) {
  Calibration result;
  result.measured = std::move(measured);
  const ScarScene any = scar_scene(scene, result.measured);
  const auto parameters = search_scars(any, std::move(free), watch, result);
  if (!result.failure.empty()) return result;
  set_coefficients(any, parameters, result);
  set_keys(any, parameters, result);
  return result;
}

scene::ScarContext context_of(const auto& scene) {
  scene::ScarContext context;
  for (const auto& contact : scene.contacts)
    if (contact.wear.wears())
      context.contacts.push_back({contact.name, contact.wear.secondary > 0.0, contact.wear.primary > 0.0});
  if (context.contacts.empty())
    throw located(
        scene, {{"contact", "", "no contact of the scene wears: give its wear law first guesses of its coefficients"}});
  return context;
}

}  // namespace

scene::ScarContext scar_context(const scene::Scene& scene) {
  auto context = context_of(scene);
  context.volumes = scene.analysis == base::Analysis::axisymmetric;
  return context;
}

scene::ScarContext scar_context(const scene::SolidScene& scene) {
  auto context = context_of(scene);
  context.dimension = 3;
  context.volumes = true;
  return context;
}

Calibration calibrate(const scene::Scene& scene, MeasuredScars measured, std::vector<FreeKey> free,
                      const CalibrationWatch& watch) {
  return calibrated(scene, std::move(measured), std::move(free), watch);
}

Calibration calibrate(const scene::SolidScene& scene, MeasuredScars measured, std::vector<FreeKey> free,
                      const CalibrationWatch& watch) {
  return calibrated(scene, std::move(measured), std::move(free), watch);
}

}  // namespace reye::sim
