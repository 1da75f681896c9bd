#include "scene/build.hpp"

namespace reye::scene {

namespace {

const base::Vec2 none(0.0, 0.0);

void add_boundary_load(const Entry& entry, Scene& scene, Issues& issues) {
  fem::BoundaryLoad load;
  load.name = entry.name();
  load.edge = entry.text("edge");
  load.pressure_MPa = entry.number("pressure_MPa");
  load.traction_MPa = entry.pair("traction_MPa").value_or(none);
  load.history = entry.text("history");
  if (const auto interval = entry.pair("interval_mm")) {
    load.interval_mm = {interval->x(), interval->y()};
    if (interval->x() >= interval->y())
      issues.push_back({entry.key("interval_mm"), entry.written("interval_mm"), "must increase"});
  }
  if (!entry.given("pressure_MPa") && !entry.given("traction_MPa"))
    issues.push_back({entry.key(), "", "needs pressure_MPa, traction_MPa or both"});
  refuse(entry, {"body", "force_N_per_mm", "force_N", "force_N_per_mm3"}, "does not go with edge", issues);
  scene.boundary_loads.push_back(load);
}

void add_point_load(const Entry& entry, Scene& scene, Issues& issues) {
  const bool axisymmetric = scene.analysis == base::Analysis::axisymmetric;
  const auto* force = axisymmetric ? "force_N" : "force_N_per_mm";
  const auto* other = axisymmetric ? "force_N_per_mm" : "force_N";
  if (entry.given(other))
    refuse(entry, {other}, takes_instead(scene.analysis, force), issues);
  else if (!entry.given(force))
    issues.push_back({entry.key(force), "", "missing"});
  refuse(entry, {"pressure_MPa", "traction_MPa", "interval_mm", "force_N_per_mm3"}, "does not go with point_mm",
         issues);
  scene.point_loads.push_back({.name = entry.name(),
                               .body = entry.text("body"),
                               .point_mm = entry.pair("point_mm").value_or(none),
                               .force_N_per_mm = entry.pair(force).value_or(none),
                               .history = entry.text("history")});
}

void add_body_force(const Entry& entry, Scene& scene, Issues& issues) {
  if (!entry.given("body")) issues.push_back({entry.key("body"), "", "missing"});
  refuse(entry, {"pressure_MPa", "traction_MPa", "interval_mm", "force_N_per_mm", "force_N"},
         "does not go with force_N_per_mm3", issues);
  scene.body_forces.push_back({.name = entry.name(),
                               .body = entry.text("body"),
                               .force_N_per_mm3 = entry.pair("force_N_per_mm3").value_or(none),
                               .history = entry.text("history")});
}

}  // namespace

void add_loads(const Entry& root, Scene& scene, Issues& issues) {
  for (const auto& entry : root.all("load")) {
    const bool on_edge = entry.given("edge"), at_point = entry.given("point_mm");
    if (on_edge && at_point)
      issues.push_back({entry.key(), "", "acts on an edge, at a point or in a body; not on two of them"});
    else if (on_edge)
      add_boundary_load(entry, scene, issues);
    else if (at_point)
      add_point_load(entry, scene, issues);
    else if (entry.given("force_N_per_mm3"))
      add_body_force(entry, scene, issues);
    else
      issues.push_back({entry.key(), "", "needs edge, point_mm, or body with force_N_per_mm3"});
  }
}

}  // namespace reye::scene
