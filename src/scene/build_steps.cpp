#include "scene/build.hpp"

#include <algorithm>
#include <utility>

#include "scene/measured.hpp"

namespace reye::scene {

namespace {

/// Sets the jump of a step; one that wears and gives none is controlled by half of the accuracy, where one is asked
/// for.
void set_jump(const Entry& entry, double accuracy, Step& step) {
  const auto control = entry.at("jump");
  const bool by_accuracy = accuracy > 0.0 && !entry.given("jump") && step.wear && step.cycles > 0.0;
  if (!control.is_table() && !by_accuracy) {
    step.jump = entry.number("jump");
    return;
  }
  step.jump_tolerance = by_accuracy ? 0.5 * accuracy : control.number("tolerance");
  step.jump = control.maybe_number("first").value_or(std::max(1.0, 1e-3 * step.cycles));
  step.jump_most = control.maybe_number("most").value_or(step.jump_most);
}

/// Steps at each level of a spectrum in turn, with its cycles; where it has no levels, the steps themselves.
std::vector<Step> at_levels(const Entry& spectrum, const std::string& scene_path, const std::vector<Step>& steps,
                            Issues& issues) {
  if (!spectrum.given("levels")) return steps;
  std::vector<Step> all;
  for (const auto& [level, cycles] : levels_of(spectrum, scene_path, issues))
    for (Step step : steps) {
      step.level = level;
      step.cycles = cycles;
      step.jump = std::min(step.jump, cycles);
      all.push_back(std::move(step));
    }
  return all;
}

/// The steps with those of the spectrum, which follow one another, repeated.
std::vector<Step> repeated(const Entry& root, const std::string& scene_path, std::vector<Step> steps, Issues& issues) {
  const auto spectrum = root.at("spectrum");
  if (!spectrum.is_table()) return steps;
  const auto names = spectrum.texts("steps");
  const auto first = std::search(steps.begin(), steps.end(), names.begin(), names.end(),
                                 [](const Step& step, const std::string& name) { return step.name == name; });
  if (names.empty() || first == steps.end()) {
    issues.push_back(
        {spectrum.key("steps"), spectrum.written("steps"), "must name steps that follow one another, in their order"});
    return steps;
  }
  const auto count = static_cast<std::ptrdiff_t>(names.size());
  auto once = at_levels(spectrum, scene_path, {first, first + count}, issues);
  auto after = steps.insert(steps.erase(first, first + count), once.begin(), once.end()) +
               static_cast<std::ptrdiff_t>(once.size());
  for (int k = 1; k < spectrum.whole("times"); ++k)
    after = steps.insert(after, once.begin(), once.end()) + static_cast<std::ptrdiff_t>(once.size());
  return steps;
}

}  // namespace

Histories histories_of(const Entry& root, const std::string& scene_path, Issues& issues) {
  Histories histories{root.at("history").histories(), {}};
  for (const auto& entry : root.all("history")) {
    auto measured = measured_history(entry, scene_path, issues);
    histories.corners[entry.name()] = measured ? measured->corners : History{{0.0, 0.0}, {1.0, 0.0}};
    if (measured) histories.measured[entry.name()] = std::move(*measured);
  }
  return histories;
}

Step step_of(const Entry& entry, std::size_t index) {
  Step step;
  step.name = entry.given("name") ? entry.text("name") : "step " + std::to_string(index + 1);
  step.play = entry.texts("play");
  step.increments = entry.whole("increments");
  step.cycles = entry.number("cycles");
  return step;
}

std::vector<Step> steps_of(const Entry& root, const std::string& scene_path, Issues& issues) {
  std::vector<Step> steps;
  for (const auto& entry : root.all("step")) {
    Step step = step_of(entry, steps.size());
    step.wear = entry.flag("wear");
    set_jump(entry, root.number("accuracy"), step);
    step.period_s = entry.number("period_s");
    steps.push_back(step);
  }
  return repeated(root, scene_path, std::move(steps), issues);
}

std::vector<Limit> limits_of(const Entry& root, Issues& issues) {
  std::vector<Limit> limits;
  const bool solid = root.text("analysis") == "solid";
  const bool volume = solid || analysis_of(root) == base::Analysis::axisymmetric;
  const auto* amount = volume ? "volume_mm3" : "area_mm2";
  const auto* other = volume ? "area_mm2" : "volume_mm3";
  for (const auto& entry : root.all("limit")) {
    if (entry.given(other) && !solid)
      refuse(entry, {other}, takes_instead(analysis_of(root), amount), issues);
    else
      exactly_one(entry, {"depth_mm", amount}, issues);
    limits.push_back({.name = entry.name(),
                      .contact = entry.text("contact"),
                      .side = entry.text("side"),
                      .depth_mm = entry.maybe_number("depth_mm"),
                      .area_mm2 = entry.maybe_number(amount),
                      .stop = entry.flag("stop"),
                      .wear_factor = {}});
    if (const auto factor = entry.pair("wear_factor")) limits.back().wear_factor = {factor->x(), factor->y()};
  }
  return limits;
}

void require_shape_to_remesh(const Entry& root, Issues& issues) {
  const auto remesh = root.at("remesh");
  if (root.text("shape") == "off" && remesh.whole("every_blocks") > 0)
    issues.push_back({remesh.key("every_blocks"), remesh.written("every_blocks"),
                      "with shape = \"off\" no surface moves and no body is remeshed; leave one of them out"});
}

Remesh remesh_of(const Entry& root) {
  const auto entry = root.at("remesh");
  Remesh remesh;
  remesh.automatic = entry.flag("automatic");
  remesh.every_blocks = entry.whole("every_blocks");
  remesh.triggers = {.min_scaled_jacobian = entry.number("min_scaled_jacobian"),
                     .min_angle_deg = entry.number("min_angle_deg"),
                     .size_ratio = entry.number("size_ratio"),
                     .wear_fraction = entry.number("wear_fraction")};
  remesh.options = {.most_nodes = 0.5 * entry.number("max_dofs"),
                    .fit_tolerance_mm = entry.maybe_number("fit_tolerance_mm").value_or(0.0)};
  const auto transfer = entry.text("state_transfer");
  remesh.state_transfer = transfer == "nearest" ? adapt::GaussTransfer::nearest
                          : transfer == "patch" ? adapt::GaussTransfer::patch
                                                : adapt::GaussTransfer::l2;
  return remesh;
}

namespace {

bool has_rule(const FrameRules& frames) {
  return frames.every_cycles > 0.0 || frames.every_blocks > 0 || frames.per_decade > 0 || frames.at_remeshes ||
         frames.every_increment || frames.last_block;
}

}  // namespace

FrameRules frames_of(const Entry& frames) {
  FrameRules rules{.every_cycles = frames.number("every_cycles"),
                   .every_blocks = frames.whole("every_blocks"),
                   .per_decade = frames.whole("per_decade"),
                   .at_remeshes = frames.flag("at_remeshes"),
                   .every_increment = frames.flag("every_increment"),
                   .last_block = frames.flag("last_block"),
                   .paraview = frames.flag("paraview")};
  rules.per_step = frames.given("per_step") ? frames.whole("per_step") : has_rule(rules) ? 0 : 5;
  return rules;
}

Output output_of(const Entry& root) {
  Output output;
  const auto entry = root.at("output");
  output.frames = frames_of(entry.at("frames"));
  output.history_every_blocks = entry.at("history").whole("every_blocks");
  output.checkpoint_s = entry.number("checkpoint_s");
  output.estimate_error = entry.maybe_flag("estimate_error").value_or(root.given("accuracy"));
  for (const auto& probe : entry.all("probes"))
    output.probes.push_back({.name = probe.name(),
                             .body = probe.text("body"),
                             .at_mm = probe.pair("at_mm").value_or(base::Vec2(0.0, 0.0))});
  return output;
}

}  // namespace reye::scene
