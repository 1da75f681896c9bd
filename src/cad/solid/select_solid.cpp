#include "cad/solid/select_solid.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "cad/solid/solid_size.hpp"
#include "cad/solid/solid_text.hpp"

namespace reye::cad {

namespace {

constexpr double selection_slack = 1e-6;  // mm; gmsh and CAD round their boxes

template <class List, class Words>
std::string listed(const List& items, Words words) {
  constexpr std::size_t shown = 12;
  std::string all;
  for (std::size_t i = 0; i < std::min(items.size(), shown); ++i) all += (i ? ", " : "") + words(items[i]);
  if (items.size() > shown) all += " and " + std::to_string(items.size() - shown) + " more";
  return all;
}

std::string list_solids(const std::vector<RawSolid>& solids, const std::vector<int>& which) {
  return listed(which, [&](int k) { return describe(solids[k]); });
}

/// The solids that a body's selector matches.
std::vector<int> matching(const std::vector<RawSolid>& solids, const SolidBodyOptions& body, int probe) {
  std::vector<int> found;
  for (int k = 0; k < static_cast<int>(solids.size()); ++k) {
    const bool holds = probe < 0 || solids[k].inside[probe];
    const bool named = body.label ? solids[k].label == *body.label : probe >= 0 || solids[k].label == body.name;
    if (holds && named) found.push_back(k);
  }
  const bool only_one = found.empty() && probe < 0 && !body.label && solids.size() == 1;
  return only_one ? std::vector<int>{0} : found;
}

base::Issue no_single_solid(const std::vector<RawSolid>& solids, const SolidBodyOptions& body,
                            const std::vector<int>& found) {
  const std::string key = "body." + body.name;
  std::vector<int> all(solids.size());
  std::iota(all.begin(), all.end(), 0);
  base::Issue issue{key, "", "has neither 'at' nor 'name', and its own name is that of"};
  if (body.label) issue = {key + ".name", "\"" + *body.label + "\"", "is the name of"};
  if (body.at) issue = {key + ".at", text(*body.at), "the point lies in"};
  issue.rule += found.empty() ? " no solid; there are: " + list_solids(solids, all)
                              : " more than one solid: " + list_solids(solids, found);
  return issue;
}

/// The issue of two bodies of one solid, or of two solids of one file that share a face.
std::optional<base::Issue> joined_with(const SolidPlan& plan, const SolidPlan& other) {
  const std::string key = "body." + plan.options->name, its = "body '" + other.options->name + "'";
  if (plan.solid == other.solid)
    return base::Issue{key, "", "selects the same solid as " + its + ": " + describe(*plan.solid)};
  if (plan.solid->file != other.solid->file || !plan.solid->mesh.cells.empty()) return std::nullopt;
  for (const RawFace& face : plan.solid->faces)
    for (const RawFace& theirs : other.solid->faces)
      if (face.tag == theirs.tag)
        return base::Issue{key, "",
                           "shares a face with " + its + ": " + describe(face) +
                               "; bodies that touch must have a face each (no BooleanFragments, no Coherence)"};
  return std::nullopt;
}

void choose_solid(SolidPlan& plan, const std::vector<RawSolid>& solids, int probe,
                  const std::vector<SolidPlan>& earlier, std::vector<base::Issue>& issues) {
  const std::vector<int> found = matching(solids, *plan.options, probe);
  if (found.size() != 1) return issues.push_back(no_single_solid(solids, *plan.options, found));
  plan.solid = &solids[found[0]];
  for (const SolidPlan& other : earlier)
    if (const auto issue = other.solid ? joined_with(plan, other) : std::nullopt) issues.push_back(*issue);
}

bool box_within(const SolidBox& inner, const SolidBox& outer) {
  for (int i = 0; i < 3; ++i)
    if (inner[i] < outer[i] - selection_slack || inner[i + 3] > outer[i + 3] + selection_slack) return false;
  return true;
}

template <class Predicate>
std::vector<int> those(const RawSolid& solid, const std::vector<int>& of, Predicate belongs) {
  std::vector<int> left;
  std::copy_if(of.begin(), of.end(), std::back_inserter(left), [&](int f) { return belongs(solid.faces[f]); });
  return left;
}

/// The faces nearest to a probe, all those at the smallest distance.
std::vector<int> nearest_faces(const RawSolid& solid, const std::vector<int>& of, int probe) {
  double least = std::numeric_limits<double>::infinity();
  for (int f : of) least = std::min(least, solid.faces[f].distance_mm[probe]);
  return those(solid, of, [&](const RawFace& face) { return face.distance_mm[probe] <= least + selection_slack; });
}

/// The faces that a name picks; none, and an issue, where its selectors match nothing or do not decide.
std::vector<int> choose_faces(const RawSolid& solid, const FaceOptions& face, int probe,
                              std::vector<base::Issue>& issues) {
  const std::string key = "face." + face.name;
  std::vector<int> chosen(solid.faces.size());
  std::iota(chosen.begin(), chosen.end(), 0);
  const std::vector<int> all = chosen;
  const auto list_faces = [&](const std::vector<int>& which) {
    return listed(which, [&](int f) { return describe(solid.faces[f]); });
  };
  const auto nothing = [&](const std::string& selector, const std::string& value) {
    issues.push_back(
        {key + selector, value, "matches no face of body '" + face.body + "', which has: " + list_faces(all)});
    return std::vector<int>{};
  };
  if (!face.box_mm && !face.type && probe < 0) {
    const auto physical = those(solid, all, [&](const RawFace& f) { return f.names.contains(face.name); });
    return physical.empty() ? all : physical;
  }
  if (face.box_mm) chosen = those(solid, chosen, [&](const RawFace& f) { return box_within(f.box_mm, *face.box_mm); });
  if (chosen.empty()) return nothing(".box_mm", text(*face.box_mm));
  if (face.type) chosen = those(solid, chosen, [&](const RawFace& f) { return to_string(f.type) == *face.type; });
  if (chosen.empty()) return nothing(".type", "\"" + *face.type + "\"");
  if (probe < 0) return chosen;
  chosen = nearest_faces(solid, chosen, probe);
  if (chosen.size() == 1) return chosen;
  issues.push_back({key + ".nearest_mm", text(*face.nearest_mm), "is equally near to: " + list_faces(chosen)});
  return {};
}

void add_named_faces(std::vector<SolidPlan>& plans, const SolidGeometryOptions& options, const SolidProbes& probes,
                     std::vector<base::Issue>& issues) {
  for (std::size_t k = 0; k < options.faces.size(); ++k) {
    const FaceOptions& face = options.faces[k];
    const auto plan =
        std::find_if(plans.begin(), plans.end(), [&](const SolidPlan& p) { return p.options->name == face.body; });
    if (plan == plans.end()) {
      issues.push_back({"face." + face.name + ".body", "\"" + face.body + "\"",
                        "there is no body of that name; there are: " +
                            listed(plans, [](const SolidPlan& p) { return p.options->name; })});
      continue;
    }
    if (!plan->solid) continue;  // reported already
    const std::vector<int> chosen = choose_faces(*plan->solid, face, probes.of_faces[k], issues);
    if (!chosen.empty()) plan->faces[face.name] = chosen;
  }
}

/// Of a zone's centre from a solid, zero inside.
double distance_of_zone(const RawSolid& solid, int probe) {
  if (solid.inside[probe]) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (const RawFace& face : solid.faces) least = std::min(least, face.distance_mm[probe]);
  return least;
}

bool zone_names(const SolidFineZone& zone, const std::string& body) {
  return zone.bodies.empty() || std::find(zone.bodies.begin(), zone.bodies.end(), body) != zone.bodies.end();
}

/// Nodes that the mesh of a plan would have, about; of a rigid body those of its skin.
double nodes_of_plan(const SolidPlan& plan, const SolidOrder& order) {
  const double per_corner_node = order.second_order ? (order.skin_only ? 4.0 : 7.5) : 1.0;
  if (!order.skin_only)
    return per_corner_node * estimated_solid_nodes(plan.solid->volume_mm3, plan.solid->box_mm, order);
  double area = 0.0, nodes = 0.0;
  for (const RawFace& face : plan.solid->faces) area += face.area_mm2;
  nodes = area / (order.far_size * order.far_size);
  for (const SizeZone& zone : order.zones) {
    const double radius = zone.radius > 0.0 ? zone.radius : zone.half_widths.norm();
    nodes += 3.0 * std::min(area, radius * radius) / (zone.size * zone.size);
  }
  return per_corner_node * nodes;
}

}  // namespace

SolidProbes probes_of(const SolidGeometryOptions& options) {
  SolidProbes probes;
  const auto add = [&](const base::Vec3& p) {
    probes.points.push_back(p);
    return static_cast<int>(probes.points.size()) - 1;
  };
  for (const SolidBodyOptions& body : options.bodies) probes.of_bodies.push_back(body.at ? add(*body.at) : -1);
  for (const FaceOptions& face : options.faces) probes.of_faces.push_back(face.nearest_mm ? add(*face.nearest_mm) : -1);
  for (const SolidFineZone& zone : options.fine_zones) probes.of_zones.push_back(add(zone.centre_mm));
  return probes;
}

std::vector<SolidPlan> plan_solids(const std::vector<RawSolid>& solids, const SolidGeometryOptions& options,
                                   const SolidProbes& probes, std::vector<base::Issue>& issues) {
  std::vector<SolidPlan> plans;
  for (std::size_t b = 0; b < options.bodies.size(); ++b) {
    SolidPlan plan{&options.bodies[b], nullptr, {}};
    choose_solid(plan, solids, probes.of_bodies[b], plans, issues);
    for (std::size_t f = 0; plan.solid && f < plan.solid->faces.size(); ++f)
      for (const std::string& name : plan.solid->faces[f].names) plan.faces[name].push_back(static_cast<int>(f));
    plans.push_back(std::move(plan));
  }
  add_named_faces(plans, options, probes, issues);
  return plans;
}

SolidOrder order_of(const SolidPlan& plan, const SolidGeometryOptions& options, std::vector<base::Issue>& issues) {
  constexpr double elements_in_diagonal = 15.0, most_nodes = 1e6;
  const SolidMeshOptions& mesh = plan.options->mesh;
  const SolidBox& box = plan.solid->box_mm;
  const double diagonal = base::Vec3(box[3] - box[0], box[4] - box[1], box[5] - box[2]).norm();
  SolidOrder order{plan.solid->volumes,
                   plan.options->rigid,
                   mesh.element == mesh::SolidKind::tet10,
                   mesh.far_size_mm > 0.0 ? mesh.far_size_mm : diagonal / elements_in_diagonal,
                   mesh.growth,
                   {}};
  for (const SolidFineZone& zone : options.fine_zones)
    if (zone_names(zone, plan.options->name))
      order.zones.push_back({zone.centre_mm, zone.radius_mm, zone.half_widths_mm, zone.size_mm});
  const double nodes = plan.solid->mesh.cells.empty() ? nodes_of_plan(plan, order) : 0.0;
  if (nodes > most_nodes)
    issues.push_back({"body." + plan.options->name, "",
                      "would need about " + text(nodes) + " nodes (at most " + text(most_nodes) +
                          "): raise the fine zone's size_mm or mesh.far_size_mm"});
  return order;
}

void check_zones(const std::vector<SolidPlan>& plans, const SolidGeometryOptions& options, const SolidProbes& probes,
                 std::vector<base::Issue>& issues) {
  for (std::size_t z = 0; z < options.fine_zones.size(); ++z) {
    const SolidFineZone& zone = options.fine_zones[z];
    const double reach = zone.radius_mm > 0.0 ? zone.radius_mm : zone.half_widths_mm.norm();
    bool wanted = false, reached = false;
    for (const SolidPlan& plan : plans) {
      if (!plan.solid) return;  // reported already
      if (!plan.solid->mesh.cells.empty() || !zone_names(zone, plan.options->name)) continue;
      wanted = true;
      reached = reached || distance_of_zone(*plan.solid, probes.of_zones[z]) <= reach;
    }
    if (wanted && !reached)
      issues.push_back({zone.key + ".centre_mm", text(zone.centre_mm), "no body reaches into the fine zone"});
  }
}

}  // namespace reye::cad
