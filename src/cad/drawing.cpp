#include "cad/drawing.hpp"

#include "base/errors.hpp"
#include "cad/generate.hpp"
#include "cad/text.hpp"
#include "mesh/quality.hpp"

namespace reye::cad {

namespace {

BodyPlan plan_of(const Drawing& drawing) {
  BodyPlan plan{&drawing.part, &drawing.options, drawing.boundaries, {}};
  for (const FineZone& zone : drawing.zones)
    if (auto outline = zone_outline(drawing.part, zone, true)) plan.zones.push_back(std::move(*outline));
  return plan;
}

/// A mesh, if it is not too large, looked over.
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

}  // namespace

double estimated_nodes(const Drawing& drawing) { return estimated_nodes(plan_of(drawing)); }

mesh::Mesh remesh(const Drawing& drawing, double most_nodes) {
  return checked(drawing, most_nodes, [](const BodyPlan& plan) { return generate(plan); });
}

mesh::Mesh refill(const Drawing& drawing, const mesh::Mesh& outline, double most_nodes) {
  return checked(drawing, most_nodes, [&](const BodyPlan& plan) { return generate_within(plan, outline); });
}

}  // namespace reye::cad
