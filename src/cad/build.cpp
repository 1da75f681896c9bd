#include <algorithm>
#include <cmath>

#include "cad/divide.hpp"
#include "cad/geometry.hpp"
#include "cad/plane.hpp"
#include "cad/region.hpp"
#include "cad/select.hpp"
#include "cad/session.hpp"
#include "cad/text.hpp"
#include "cad/zone.hpp"
#include "mesh/measure.hpp"
#include "mesh/outline.hpp"
#include "mesh/quality.hpp"

namespace reye::cad {

namespace {

using base::Issue;

constexpr double most_nodes = 2e6;

/// Everything known of one body before it is meshed.
struct BodyPlan {
  const Part* part = nullptr;
  const BodyOptions* options = nullptr;
  std::map<std::string, EdgeChoice> boundaries;
  std::vector<ZoneOutline> zones;
};

std::vector<Part> import_all(const std::vector<std::string>& files) {
  std::vector<Issue> issues;
  std::vector<RawPart> raw;
  for (const std::string& file : files) {
    try {
      std::vector<RawPart> parts = read_file(file);
      raw.insert(raw.end(), std::make_move_iterator(parts.begin()), std::make_move_iterator(parts.end()));
    } catch (const base::InputError& error) {
      issues.insert(issues.end(), error.issues().begin(), error.issues().end());
    }
  }
  if (files.empty()) issues.push_back({"geometry", "[]", "names no file"});
  if (!issues.empty()) throw base::InputError(issues);
  return map_to_plane(raw);
}

bool applies(const FineZone& zone, const std::string& body) {
  return zone.bodies.empty() || std::find(zone.bodies.begin(), zone.bodies.end(), body) != zone.bodies.end();
}

double diagonal(const Part& part) {
  const auto box = bounding_box(part);
  return std::hypot(box[2] - box[0], box[3] - box[1]);
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

void check_body(const BodyPlan& plan, bool axisymmetric, std::vector<Issue>& issues) {
  const std::string key = "body." + plan.options->name;
  if (axisymmetric && bounding_box(*plan.part)[0] < -1e-9)
    issues.push_back({key, "", "reaches x = " + text(bounding_box(*plan.part)[0]) +
                                   "; in an axisymmetric scene x is the radius and nothing lies at x < 0"});
  if (plan.options->rigid || plan.part->mesh) return;
  const double nodes = estimated_nodes(plan);
  if (nodes > most_nodes)
    issues.push_back({key, "", "would need about " + text(nodes) + " nodes (at most " + text(most_nodes) +
                                   "): raise the fine zone's size_mm or mesh.far_size_mm"});
}

void add_boundaries(std::vector<BodyPlan>& plans, const GeometryOptions& options, std::vector<Issue>& issues) {
  for (const BoundaryOptions& boundary : options.boundaries) {
    const auto plan = std::find_if(plans.begin(), plans.end(),
                                   [&](const BodyPlan& p) { return p.options->name == boundary.body; });
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
  add_boundaries(plans, options, issues);
  if (!issues.empty()) throw base::InputError(issues);
  return plans;
}

/// Far size, fine zones, and the edges that need elements smaller than the far size to be resolved at all:
/// two to an edge, and 30 degrees of a curve to an element.
SizeField size_field(const BodyPlan& plan) {
  const double far = far_size(plan);
  SizeField size(far, plan.options->mesh.growth);
  for (const ZoneOutline& zone : plan.zones) size.add(make_source(sampled(*plan.part, zone), zone.depth, zone.size));
  for (const Loop& loop : plan.part->loops)
    for (const Edge& edge : loop) {
      const double turns = turning(edge) / (M_PI / 6.0);
      const double own = edge.length() / std::max(2.0, turns);
      if (own >= far) continue;
      Points line;
      const int pieces = edge.type == EdgeType::line ? 1 : std::max(2, static_cast<int>(std::ceil(2.0 * turns)));
      for (int i = 0; i <= pieces; ++i) line.push_back(at(edge, edge.length() * i / pieces));
      size.add(make_source(std::move(line), 0.0, own));
    }
  return size;
}

int node_at(const Region& region, const RegionLoop& loop, const Vec2& p) {
  return *std::min_element(loop.nodes.begin(), loop.nodes.end(), [&](int a, int b) {
    return (region.X[a] - p).squaredNorm() < (region.X[b] - p).squaredNorm();
  });
}

/// Rows of equal elements beneath a fine stretch that ends smoothly on both sides, where they fit.
void add_zone_layers(Region& region, const std::vector<RegionLoop>& outline, const BodyPlan& plan) {
  for (const ZoneOutline& zone : plan.zones) {
    if (!zone.smooth_begin || !zone.smooth_end || zone.depth < 1.5 * zone.size) continue;
    const Loop& loop = plan.part->loops[zone.loop];
    const Stretch &begin = zone.stretches.front(), &end = zone.stretches.back();
    const int first = node_at(region, outline[zone.loop], at(loop[begin.edge], begin.begin));
    const int last = node_at(region, outline[zone.loop], at(loop[end.edge], end.end));
    const int layers = 2 * std::max(1, static_cast<int>(std::lround(0.5 * zone.depth / zone.size)));
    add_layers(region, first, last, layers, zone.depth);
  }
}

/// Which segments of each divided loop lie on the chosen edges.
std::vector<std::vector<bool>> segments_on(const std::vector<DividedLoop>& loops, const EdgeChoice& edges) {
  std::vector<std::vector<bool>> on(loops.size());
  for (std::size_t loop = 0; loop < loops.size(); ++loop)
    for (int edge : loops[loop].edge) on[loop].push_back(edges[loop][edge]);
  return on;
}

/// The division that the outline of a mesh from a file already has.
DividedLoop divided_as_is(const Loop& loop) {
  DividedLoop divided;
  for (int k = 0; k < static_cast<int>(loop.size()); ++k)
    for (std::size_t i = 0; i + 1 < loop[k].knots.size(); ++i) divided.edge.push_back(k);
  return divided;
}

mesh::Mesh make_mesh(const BodyPlan& plan) {
  const bool quads = plan.options->mesh.element == mesh::CellKind::quad4;
  const SizeField size = size_field(plan);
  Region region;
  region.kind = plan.options->mesh.element;
  std::vector<DividedLoop> divided;
  mesh::Mesh mesh;
  for (int k = 0; k < static_cast<int>(plan.part->loops.size()); ++k) {
    std::vector<ZoneOutline> zones;
    for (const ZoneOutline& zone : plan.zones)
      if (zone.loop == k) zones.push_back(zone);
    divided.push_back(divide(plan.part->loops[k], zones, size, quads && !plan.options->rigid));
    RegionLoop loop{{}, divided.back().corner};
    for (const Vec2& p : divided.back().nodes) {
      loop.nodes.push_back(static_cast<int>(region.X.size()));
      region.X.push_back(p);
    }
    mesh.outline.push_back(loop.nodes);
    mesh.outline.back().push_back(loop.nodes.front());
    region.loops.push_back(std::move(loop));
  }
  if (!plan.options->rigid) {
    add_zone_layers(region, std::vector<RegionLoop>(region.loops), plan);
    fill(region, size);
  }
  mesh.X = std::move(region.X);
  mesh.kind = region.kind;
  mesh.cells = std::move(region.cells);
  for (const auto& [name, edges] : plan.boundaries)
    mesh.boundaries[name] = mesh::chains_along(mesh.outline, segments_on(divided, edges));
  return mesh;
}

mesh::Mesh mesh_from_file(const BodyPlan& plan) {
  mesh::Mesh mesh = *plan.part->mesh;
  std::vector<DividedLoop> divided;
  for (const Loop& loop : plan.part->loops) divided.push_back(divided_as_is(loop));
  for (const auto& [name, edges] : plan.boundaries)
    mesh.boundaries[name] = mesh::chains_along(mesh.outline, segments_on(divided, edges));
  return mesh;
}

}  // namespace

Geometry build(const GeometryOptions& options) {
  const Session session;
  const std::vector<Part> parts = import_all(options.files);
  Geometry geometry;
  for (const BodyPlan& plan : make_plans(parts, options)) {
    mesh::Mesh mesh = plan.part->mesh ? mesh_from_file(plan) : make_mesh(plan);
    if (options.axisymmetric)
      for (Vec2& p : mesh.X) p.x() = std::max(p.x(), 0.0);  // checked to be round-off
    try {
      mesh::check(mesh);
    } catch (const base::MeshError& error) {
      throw base::MeshError("body " + plan.options->name + ": " + error.what());
    }
    geometry.facts.push_back({plan.options->name, area(*plan.part), bounding_box(*plan.part)});
    geometry.bodies.push_back(std::move(mesh));
  }
  return geometry;
}

}  // namespace reye::cad
