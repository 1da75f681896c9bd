#include <algorithm>
#include <iterator>
#include <limits>

#include "base/errors.hpp"
#include "cad/generate.hpp"
#include "cad/geometry.hpp"
#include "cad/plane.hpp"
#include "mesh/arc.hpp"
#include "mesh/outline.hpp"
#include "mesh/quality.hpp"

namespace reye::cad {

namespace {

using base::Issue;

std::vector<Part> import_all(const std::vector<std::string>& files, const std::optional<Section>& section) {
  std::vector<Issue> issues;
  std::vector<RawPart> raw;
  for (const std::string& file : files) {
    try {
      std::vector<RawPart> parts = read_file(file, section);
      raw.insert(raw.end(), std::make_move_iterator(parts.begin()), std::make_move_iterator(parts.end()));
    } catch (const base::InputError& error) {
      issues.insert(issues.end(), error.issues().begin(), error.issues().end());
    }
  }
  if (files.empty()) issues.push_back({"geometry", "[]", "names no file"});
  if (!issues.empty()) throw base::InputError(issues);
  return map_to_plane(raw, section);
}

/// The fine zone whose centre is nearest to a ring, of those whose centre is nearer to it than to any other loop.
const FineZone* zone_on(const mesh::Mesh& mesh, const mesh::Chain& ring, const Drawing& drawing) {
  const auto distance = [&](const mesh::Chain& chain, const Vec2& p) {
    double least = std::numeric_limits<double>::infinity();
    for (int node : chain) least = std::min(least, (mesh.X[node] - p).norm());
    return least;
  };
  const FineZone* best = nullptr;
  for (const FineZone& zone : drawing.zones) {
    const double here = distance(ring, zone.centre_mm);
    const bool nearest = std::all_of(mesh.outline.begin(), mesh.outline.end(),
                                     [&](const auto& loop) { return here <= distance(loop, zone.centre_mm); });
    if (nearest && (!best || here < distance(ring, best->centre_mm))) best = &zone;
  }
  return best;
}

Drawing drawing_of(const BodyPlan& plan, const GeometryOptions& options) {
  Drawing drawing{*plan.part, plan.boundaries, *plan.options, {}, options.axisymmetric};
  for (const FineZone& zone : options.fine_zones)
    if (applies(zone, plan.options->name) && zone_outline(*plan.part, zone, !zone.bodies.empty()))
      drawing.zones.push_back(zone);
  return drawing;
}

/// Lets the boundaries of a mesh count their arc length from where they do now for good; a ring from opposite to the
/// centre of the fine zone on it, so that no table is cut where there is contact.
void choose_arc_origins(mesh::Mesh& mesh, const Drawing& drawing) {
  for (const auto& [name, chains] : mesh.boundaries) {
    auto& origins = mesh.arc_origin[name] = mesh::arc_origins(mesh, name);
    for (const auto& chain : chains) {
      if (!mesh::is_closed(chain)) continue;
      const FineZone* zone = zone_on(mesh, chain, drawing);
      if (zone) std::replace(origins.begin(), origins.end(), chain.front(), mesh::opposite(mesh, chain, zone->centre_mm));
    }
  }
}

}  // namespace

Geometry build(const GeometryOptions& options) {
  const Plans plans = make_plans(import_all(options.files, options.section), options);
  Geometry geometry;
  for (const BodyPlan& plan : plans.bodies) {
    mesh::Mesh mesh;
    try {
      mesh = generate(plan);
      if (options.axisymmetric) clear_axis(mesh);
      mesh::check(mesh);
    } catch (const base::MeshError& error) {
      throw base::MeshError("body " + plan.options->name + ": " + error.what());
    }
    geometry.drawings.push_back(drawing_of(plan, options));
    choose_arc_origins(mesh, geometry.drawings.back());
    geometry.facts.push_back({plan.options->name, area(*plan.part), bounding_box(*plan.part)});
    geometry.bodies.push_back(std::move(mesh));
  }
  return geometry;
}

}  // namespace reye::cad
