#include "cad/plan.hpp"

#include <algorithm>
#include <cmath>

#include "cad/size_field.hpp"
#include "cad/text.hpp"

namespace reye::cad {

namespace {

using base::Issue;

constexpr double most_nodes = 2e6;

double diagonal(const Part& part) {
  const auto box = bounding_box(part);
  return std::hypot(box[2] - box[0], box[3] - box[1]);
}

/// A zone that refines nothing is a mistake in its centre; bodies that bring their own mesh have none.
void check_zone(const FineZone& zone, const std::vector<BodyPlan>& plans, std::vector<Issue>& issues) {
  bool wanted = false;
  for (const BodyPlan& plan : plans) {
    if (!plan.part) return;  // told already
    if (plan.part->mesh || !applies(zone, plan.options->name)) continue;
    wanted = true;
    if (zone_outline(*plan.part, zone, !zone.bodies.empty())) return;
  }
  if (wanted)
    issues.push_back({"contact." + zone.contact + ".fine_zone.centre_mm", text(zone.centre_mm),
                      "no edge of a body passes through the fine zone"});
}

void check_body(const BodyPlan& plan, bool axisymmetric, std::vector<Issue>& issues) {
  const std::string key = "body." + plan.options->name;
  if (axisymmetric && bounding_box(*plan.part)[0] < -1e-9)
    issues.push_back({key, "",
                      "reaches x = " + text(bounding_box(*plan.part)[0]) +
                          "; in an axisymmetric scene x is the radius and nothing lies at x < 0"});
  if (plan.options->rigid || plan.part->mesh) return;
  const double nodes = estimated_nodes(plan);
  if (nodes > most_nodes)
    issues.push_back({key, "",
                      "would need about " + text(nodes) + " nodes (at most " + text(most_nodes) +
                          "): raise the fine zone's size_mm or mesh.far_size_mm"});
}

void add_boundaries(std::vector<BodyPlan>& plans, const GeometryOptions& options, std::vector<Issue>& issues) {
  for (const BoundaryOptions& boundary : options.boundaries) {
    const auto plan =
        std::find_if(plans.begin(), plans.end(), [&](const BodyPlan& p) { return p.options->name == boundary.body; });
    if (plan == plans.end()) {
      std::string names;
      for (const BodyPlan& p : plans) names += (names.empty() ? "" : ", ") + p.options->name;
      issues.push_back({"boundary." + boundary.name + ".body", "\"" + boundary.body + "\"",
                        "there is no body of that name; there are: " + names});
    } else if (plan->part) {
      if (const auto edges = select_edges(*plan->part, boundary, issues)) plan->boundaries[boundary.name] = *edges;
    }
  }
}

}  // namespace

bool applies(const FineZone& zone, const std::string& body) {
  return zone.bodies.empty() || std::find(zone.bodies.begin(), zone.bodies.end(), body) != zone.bodies.end();
}

double far_size(const BodyPlan& plan) {
  const double wished = plan.options->mesh.far_size_mm;
  return wished > 0.0 ? wished : diagonal(*plan.part) / 20.0;
}

double estimated_nodes(const BodyPlan& plan) {
  const double far = far_size(plan);
  double elements = area(*plan.part) / (far * far);
  for (const ZoneOutline& zone : plan.zones)
    elements += estimated_elements(zone.length(), zone.depth, zone.size, far, plan.options->mesh.growth);
  return plan.options->mesh.element == mesh::CellKind::quad4 ? elements : 1.15 * elements;
}

std::vector<BodyPlan> make_plans(const std::vector<Part>& parts, const GeometryOptions& options) {
  std::vector<Issue> issues;
  const std::vector<int> chosen = select_parts(parts, options.bodies, issues);
  std::vector<BodyPlan> plans;
  for (std::size_t b = 0; b < options.bodies.size(); ++b) {
    plans.push_back({chosen[b] < 0 ? nullptr : &parts[chosen[b]], &options.bodies[b], {}, {}});
    BodyPlan& plan = plans.back();
    if (!plan.part) continue;
    plan.boundaries = named_edges(*plan.part);
    for (const FineZone& zone : options.fine_zones)
      if (!plan.part->mesh && applies(zone, plan.options->name))
        if (auto outline = zone_outline(*plan.part, zone, !zone.bodies.empty())) plan.zones.push_back(*outline);
    check_body(plan, options.axisymmetric, issues);
  }
  for (const FineZone& zone : options.fine_zones) check_zone(zone, plans, issues);
  add_boundaries(plans, options, issues);
  if (!issues.empty()) throw base::InputError(issues);
  return plans;
}

}  // namespace reye::cad
