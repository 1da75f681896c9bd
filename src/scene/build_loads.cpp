#include <algorithm>

#include "scene/build.hpp"

namespace reye::scene {

namespace {

const base::Vec2 none(0.0, 0.0);

void add_boundary_load(const Entry& entry, const std::vector<Entry>& parts, Scene& scene, Issues& issues) {
  fem::BoundaryLoad load;
  load.name = entry.name();
  load.edge = entry.text("edge");
  if (const auto interval = entry.pair("interval_mm")) {
    load.interval_mm = {interval->x(), interval->y()};
    if (interval->x() >= interval->y())
      issues.push_back({entry.key("interval_mm"), entry.written("interval_mm"), "must increase"});
  }
  refuse(entry, {"body"}, "does not go with edge", issues);
  for (const auto& part : parts) {
    if (!part.given("pressure_MPa") && !part.given("traction_MPa"))
      issues.push_back({part.key(), "", "needs pressure_MPa, traction_MPa or both"});
    refuse(part, {"force_N_per_mm", "force_N", "force_N_per_mm3"}, "does not go with edge", issues);
    load.pressure_MPa = part.number("pressure_MPa");
    load.traction_MPa = part.pair("traction_MPa").value_or(none);
    load.history = part.text("history");
    scene.boundary_loads.push_back(load);
  }
}

void add_point_load(const Entry& entry, const std::vector<Entry>& parts, Scene& scene, Issues& issues) {
  const bool axisymmetric = scene.analysis == base::Analysis::axisymmetric;
  const auto* force = axisymmetric ? "force_N" : "force_N_per_mm";
  const auto* other = axisymmetric ? "force_N_per_mm" : "force_N";
  refuse(entry, {"interval_mm"}, "does not go with point_mm", issues);
  for (const auto& part : parts) {
    if (part.given(other))
      refuse(part, {other}, takes_instead(scene.analysis, force), issues);
    else if (!part.given(force))
      issues.push_back({part.key(force), "", "missing"});
    refuse(part, {"pressure_MPa", "traction_MPa", "force_N_per_mm3"}, "does not go with point_mm", issues);
    scene.point_loads.push_back({.name = entry.name(),
                                 .body = entry.text("body"),
                                 .point_mm = entry.pair("point_mm").value_or(none),
                                 .force_N_per_mm = part.pair(force).value_or(none),
                                 .history = part.text("history")});
  }
}

void add_body_force(const Entry& entry, const std::vector<Entry>& parts, Scene& scene, Issues& issues) {
  if (!entry.given("body")) issues.push_back({entry.key("body"), "", "missing"});
  refuse(entry, {"interval_mm"}, "does not go with force_N_per_mm3", issues);
  for (const auto& part : parts) {
    if (!part.given("force_N_per_mm3")) issues.push_back({part.key("force_N_per_mm3"), "", "missing"});
    refuse(part, {"pressure_MPa", "traction_MPa", "force_N_per_mm", "force_N"}, "does not go with force_N_per_mm3",
           issues);
    scene.body_forces.push_back({.name = entry.name(),
                                 .body = entry.text("body"),
                                 .force_N_per_mm3 = part.pair("force_N_per_mm3").value_or(none),
                                 .history = part.text("history")});
  }
}

}  // namespace

std::vector<Entry> parts_of(const Entry& load, std::initializer_list<std::string_view> values, Issues& issues) {
  if (!load.given("parts")) return {load};
  refuse(load, values, "stands in each of the parts", issues);
  refuse(load, {"history"}, "stands in each of the parts", issues);
  return load.all("parts");
}

void add_loads(const Entry& root, Scene& scene, Issues& issues) {
  for (const auto& entry : root.all("load")) {
    const bool on_edge = entry.given("edge"), at_point = entry.given("point_mm");
    const auto parts =
        parts_of(entry, {"pressure_MPa", "traction_MPa", "force_N_per_mm", "force_N", "force_N_per_mm3"}, issues);
    const auto has_force = [](const Entry& part) { return part.given("force_N_per_mm3"); };
    if (on_edge && at_point)
      issues.push_back({entry.key(), "", "acts on an edge, at a point or in a body; not on two of them"});
    else if (on_edge)
      add_boundary_load(entry, parts, scene, issues);
    else if (at_point)
      add_point_load(entry, parts, scene, issues);
    else if (std::any_of(parts.begin(), parts.end(), has_force))
      add_body_force(entry, parts, scene, issues);
    else
      issues.push_back({entry.key(), "", "needs edge, point_mm, or body with force_N_per_mm3"});
  }
}

}  // namespace reye::scene
