#include "cad/build/drawing.hpp"

#include <algorithm>
#include <limits>

#include "base/errors.hpp"
#include "cad/build/generate.hpp"
#include "cad/part/text.hpp"
#include "mesh/arc.hpp"
#include "mesh/outline.hpp"
#include "mesh/quality.hpp"

namespace reye::cad {

namespace {

BodyPlan plan_of(const Drawing& drawing) {
  BodyPlan plan{&drawing.part, &drawing.options, drawing.boundaries, {}};
  for (const FineZone& zone : drawing.zones)
    if (auto outline = zone_outline(drawing.part, zone, true)) plan.zones.push_back(std::move(*outline));
  return plan;
}

/// Makes a mesh that is not too large, and checks it.
template <class Make>
mesh::Mesh checked(const Drawing& drawing, double most_nodes, Make make) {
  const BodyPlan plan = plan_of(drawing);
  if (const double nodes = estimated_nodes(plan); !(nodes <= most_nodes))
    throw base::MeshError("a new mesh would need about " + text(nodes) + " nodes (at most " + text(most_nodes) + ")");
  mesh::Mesh mesh = make(plan);
  if (drawing.axisymmetric) clear_axis(mesh);
  mesh::check(mesh);
  return mesh;
}

/// The centres of the fine zones that are nearer to a ring than to any other loop.
Points centres_on(const mesh::Mesh& mesh, const mesh::Chain& ring, const Drawing& drawing) {
  const auto distance = [&](const mesh::Chain& chain, const Vec2& p) {
    double least = std::numeric_limits<double>::infinity();
    for (int node : chain) least = std::min(least, (mesh.X[node] - p).norm());
    return least;
  };
  Points centres;
  for (const FineZone& zone : drawing.zones) {
    const double here = distance(ring, zone.centre_mm);
    if (std::all_of(mesh.outline.begin(), mesh.outline.end(),
                    [&](const auto& loop) { return here <= distance(loop, zone.centre_mm); }))
      centres.push_back(zone.centre_mm);
  }
  return centres;
}

}  // namespace

void choose_arc_origins(mesh::Mesh& mesh, const Drawing& drawing) {
  for (const auto& [name, chains] : mesh.boundaries) {
    auto& origins = mesh.arc_origin[name] = mesh::arc_origins(mesh, name);
    for (const auto& chain : chains) {
      if (!mesh::is_closed(chain)) continue;
      const Points centres = centres_on(mesh, chain, drawing);
      if (!centres.empty())
        std::replace(origins.begin(), origins.end(), chain.front(), mesh::farthest_from(mesh, chain, centres));
    }
  }
}

double estimated_nodes(const Drawing& drawing) { return estimated_nodes(plan_of(drawing)); }

mesh::Mesh remesh(const Drawing& drawing, double most_nodes) {
  return checked(drawing, most_nodes, [](const BodyPlan& plan) { return generate(plan); });
}

mesh::Mesh refill(const Drawing& drawing, const mesh::Mesh& outline, double most_nodes) {
  return checked(drawing, most_nodes, [&](const BodyPlan& plan) { return generate_within(plan, outline); });
}

}  // namespace reye::cad
