#include <algorithm>
#include <iterator>

#include "base/errors.hpp"
#include "cad/generate.hpp"
#include "cad/geometry.hpp"
#include "cad/plane.hpp"
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

Drawing drawing_of(const BodyPlan& plan, const GeometryOptions& options) {
  Drawing drawing{*plan.part, plan.boundaries, *plan.options, {}, options.axisymmetric};
  for (const FineZone& zone : options.fine_zones)
    if (applies(zone, plan.options->name) && zone_outline(*plan.part, zone, !zone.bodies.empty()))
      drawing.zones.push_back(zone);
  return drawing;
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
