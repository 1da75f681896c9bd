#include <filesystem>

#include "base/errors.hpp"
#include "cad/build/generate.hpp"
#include "cad/build/geometry.hpp"
#include "cad/build/importer.hpp"
#include "cad/part/map_to_plane.hpp"
#include "mesh/outline.hpp"
#include "mesh/quality.hpp"

namespace reye::cad {

namespace {

Drawing drawing_of(const BodyPlan& plan, const GeometryOptions& options) {
  Drawing drawing{*plan.part, plan.boundaries, *plan.options, {}, options.axisymmetric};
  for (const FineZone* zone : zones_on(*plan.part, plan.options->name, options.fine_zones))
    drawing.zones.push_back(*zone);
  return drawing;
}

}  // namespace

Geometry build(const GeometryOptions& options) {
  const Imported imported = import_files(options);
  const Plans plans = make_plans(map_to_plane(imported.parts, options.section), options);
  Geometry geometry;
  geometry.guarded = imported.guarded;
  std::vector<base::Issue> issues;
  for (const BodyPlan& plan : plans.bodies) {
    mesh::Mesh mesh;
    try {
      mesh = generate(plan);
      if (options.axisymmetric) clear_axis(mesh);
      mesh::check(mesh);
    } catch (const base::MeshError& error) {
      issues.push_back({"body." + plan.options->name, "",
                        "its face " + describe(*plan.part) + " of " +
                            std::filesystem::path(plan.part->file).filename().string() +
                            " cannot be meshed: " + error.what()});
      continue;
    }
    geometry.drawings.push_back(drawing_of(plan, options));
    choose_arc_origins(mesh, geometry.drawings.back());
    geometry.facts.push_back(
        {plan.options->name, area(*plan.part), bounding_box(*plan.part), plan.halved, plan.cut_off});
    geometry.bodies.push_back(std::move(mesh));
  }
  if (!issues.empty()) throw base::InputError(std::move(issues));
  return geometry;
}

}  // namespace reye::cad
