#include "cad/build/plan.hpp"

#include <algorithm>
#include <cmath>

#include "cad/build/profile.hpp"
#include "cad/build/whole_section.hpp"
#include "cad/meshing/size_field.hpp"
#include "cad/part/axis_pieces.hpp"
#include "cad/part/text.hpp"
#include "mesh/arc.hpp"

namespace reye::cad {

namespace {

using base::Issue;

constexpr double most_nodes = 1e6;  ///< of a body: 6 GB, and a minute of meshing

double diagonal(const Part& part) {
  const auto box = bounding_box(part);
  return std::hypot(box[2] - box[0], box[3] - box[1]);
}

/// Whether the zone applies to the body of this name; a zone that names no body applies to all.
bool names(const FineZone& zone, const std::string& body) {
  return zone.bodies.empty() || std::find(zone.bodies.begin(), zone.bodies.end(), body) != zone.bodies.end();
}

/// A zone that refines nothing is a mistake in its centre; bodies that bring their own mesh have none.
void check_zone(const FineZone& zone, const GeometryOptions& options, const std::vector<BodyPlan>& plans,
                std::vector<Issue>& issues) {
  if (options.axisymmetric && zone.centre_mm.x() < -1e-9)
    return issues.push_back({zone.key + ".centre_mm", text(zone.centre_mm),
                             "lies at x < 0; an axisymmetric scene takes what lies at x >= 0: give " +
                                 text(Vec2(-zone.centre_mm.x(), zone.centre_mm.y()))});
  bool wanted = false;
  for (const BodyPlan& plan : plans) {
    if (!plan.part) return;  // reported already
    if (plan.part->mesh || !names(zone, plan.options->name)) continue;
    wanted = true;
    const auto zones = zones_on(*plan.part, plan.options->name, options.fine_zones);
    if (std::find(zones.begin(), zones.end(), &zone) != zones.end()) return;
  }
  if (wanted)
    issues.push_back({zone.key + ".centre_mm", text(zone.centre_mm), "no edge of a body passes through the fine zone"});
}

/// Approximate number of nodes of a rigid body, which is its outline.
double outline_nodes(const BodyPlan& plan) {
  double length = 0.0;
  for (const Loop& loop : plan.part->loops)
    for (const Edge& edge : loop) length += edge.length();
  double nodes = length / far_size(plan);
  for (const ZoneOutline& zone : plan.zones) nodes += zone.length() / zone.size;
  return nodes;
}

void check_body(const BodyPlan& plan, bool axisymmetric, std::vector<Issue>& issues) {
  const std::string key = "body." + plan.options->name;
  const bool told = !plan.part->mesh && crosses_axis(*plan.part);  // by take_halves
  if (axisymmetric && bounding_box(*plan.part)[0] < -1e-9 && !told)
    issues.push_back({key, "",
                      "reaches x = " + text(bounding_box(*plan.part)[0]) +
                          "; in an axisymmetric scene x is the radius and nothing lies at x < 0" +
                          (plan.part->mesh ? "; a mesh is taken as it is: mesh the half x >= 0 alone" : "")});
  if (plan.part->mesh) return;
  const double nodes = plan.options->rigid ? outline_nodes(plan) : estimated_nodes(plan);
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

/// The name of a boundary, before this one in the scene, that has put its profile on one of these edges.
std::optional<std::string> earlier_profile(const BodyPlan& plan, const BoundaryOptions& boundary,
                                           const std::vector<BoundaryOptions>& all) {
  const EdgeChoice& edges = plan.boundaries.at(boundary.name);
  for (const BoundaryOptions& other : all) {
    if (other.name == boundary.name) return std::nullopt;
    if (!other.profile || other.body != boundary.body || !plan.boundaries.contains(other.name)) continue;
    const EdgeChoice& theirs = plan.boundaries.at(other.name);
    for (std::size_t loop = 0; loop < edges.size(); ++loop)
      for (std::size_t k = 0; k < edges[loop].size(); ++k)
        if (edges[loop][k] && theirs[loop][k]) return other.name;
  }
  return std::nullopt;
}

/// Displaces the edges of boundaries that have a profile. Edges keep their numbers.
void put_profiles(Plans& plans, const GeometryOptions& options, std::vector<Issue>& issues) {
  for (const BoundaryOptions& boundary : options.boundaries) {
    const auto plan = std::find_if(plans.bodies.begin(), plans.bodies.end(),
                                   [&](const BodyPlan& p) { return p.options->name == boundary.body; });
    if (!boundary.profile || plan == plans.bodies.end() || !plan->boundaries.contains(boundary.name)) continue;
    if (const auto other = earlier_profile(*plan, boundary, options.boundaries)) {
      issues.push_back({"boundary." + boundary.name + ".profile", "\"" + boundary.profile->file + "\"",
                        "shares an edge with boundary '" + *other + "', which has a profile too"});
      continue;
    }
    if (auto part = with_profile(*plan->part, plan->boundaries.at(boundary.name), boundary, issues))
      plans.parts[plan->part - plans.parts.data()] = std::move(*part);
  }
}

/// A loop of one closed edge begins opposite to the fine zone on it, or amid the longest stretch between several: the
/// mesh in contact must not depend on the seam, where the file happens to begin the ring.
void turn_rings(Plans& plans, const GeometryOptions& options) {
  for (BodyPlan& plan : plans.bodies) {
    if (!plan.part || plan.part->mesh) continue;
    std::map<int, std::vector<double>> centres;  // of each ring
    for (const FineZone* zone : zones_on(*plan.part, plan.options->name, options.fine_zones)) {
      const auto outline = zone_outline(*plan.part, *zone, true);
      if (plan.part->loops[outline->loop].size() == 1) centres[outline->loop].push_back(outline->centre_arc);
    }
    for (const auto& [loop, arcs] : centres) {
      Edge& ring = plans.parts[plan.part - plans.parts.data()].loops[loop].front();
      ring = begun_at(ring, mesh::amid_longest_gap(arcs, ring.length()));
    }
  }
}

}  // namespace

std::vector<const FineZone*> zones_on(const Part& part, const std::string& body, const std::vector<FineZone>& zones) {
  std::vector<const FineZone*> wanted, near;
  for (const FineZone& zone : zones) {
    if (!names(zone, body)) continue;
    wanted.push_back(&zone);
    if (zone_outline(part, zone, false)) near.push_back(&zone);
  }
  const auto leaves_out = [&](const FineZone* zone) {
    if (std::find(near.begin(), near.end(), zone) != near.end()) return false;
    const bool another =
        std::any_of(near.begin(), near.end(), [&](const FineZone* other) { return other->contact == zone->contact; });
    return zone->bodies.empty() || another || !zone_outline(part, *zone, true);
  };
  std::erase_if(wanted, leaves_out);
  return wanted;
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
  const bool quads = plan.options->mesh.element == mesh::CellKind::quad4;
  const double vertices = quads ? elements : 1.15 * elements;
  return plan.options->mesh.order == 1 ? vertices : (quads ? 3.0 : 4.0) * vertices;  // and a node on every edge
}

Plans make_plans(std::vector<Part> all, const GeometryOptions& options) {
  std::vector<Issue> issues;
  if (options.axisymmetric) leave_out_mirror_images(all);
  Plans plans{std::move(all), {}};
  const std::vector<int> chosen = select_parts(plans.parts, options.bodies, issues);
  for (std::size_t b = 0; b < options.bodies.size(); ++b) {
    const Part* part = chosen[b] < 0 ? nullptr : &plans.parts[chosen[b]];
    plans.bodies.push_back(
        {part, &options.bodies[b], part ? named_edges(*part) : decltype(BodyPlan::boundaries){}, {}});
  }
  if (options.axisymmetric) tell_of_the_half(options.bodies, issues);
  add_boundaries(plans.bodies, options, issues);
  if (options.axisymmetric) take_halves(plans, options, issues);
  put_profiles(plans, options, issues);
  turn_rings(plans, options);
  for (BodyPlan& plan : plans.bodies) {
    if (!plan.part) continue;
    if (!plan.part->mesh)
      for (const FineZone* zone : zones_on(*plan.part, plan.options->name, options.fine_zones))
        plan.zones.push_back(*zone_outline(*plan.part, *zone, true));
    check_body(plan, options.axisymmetric, issues);
  }
  for (const FineZone& zone : options.fine_zones) check_zone(zone, options, plans.bodies, issues);
  if (!issues.empty()) throw base::InputError(issues);
  return plans;
}

}  // namespace reye::cad
