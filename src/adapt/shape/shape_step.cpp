#include "adapt/shape/shape_step.hpp"

#include <sstream>
#include <utility>

#include "adapt/shape/cause.hpp"
#include "adapt/shape/crossing.hpp"
#include "adapt/shape/outline.hpp"
#include "adapt/shape/relocation.hpp"
#include "adapt/shape/sliding.hpp"

namespace reye::adapt {

namespace {

std::string crossing_report(const mesh::Mesh& now, const mesh::Mesh& born, const Crossing& crossing) {
  std::ostringstream text;
  text << meaning(crossing, now, born) << " at (" << crossing.at.x() << ", " << crossing.at.y() << ") mm, facet "
       << crossing.first[0] << "-" << crossing.first[1] << " with facet " << crossing.second[0] << "-"
       << crossing.second[1] << cause(now, born, crossing.at);
  return text.str();
}

/// The message for an invalid loss, negative or not a number; empty when all losses are valid.
std::string bad_loss(const std::vector<WornBoundary>& worn) {
  for (const auto& [name, removed] : worn)
    for (std::size_t k = 0; k < removed.size(); ++k)
      if (!(removed[k] >= 0.0))
        return "node " + std::to_string(k) + " of boundary '" + name + "' loses a volume of " +
               std::to_string(removed[k]);
  return {};
}

/// Checks the mesh after the outline has moved: it fails when the outline crosses itself, and is `poor` where an
/// element is.
void judge(ShapeStepResult& result, std::shared_ptr<body::Shape> next, const QualityBound& bound,
           RelocationCache* cache) {
  if (const auto crossing = find_crossing(next->mesh)) {
    result.failure = crossing_report(next->mesh, *next->born, *crossing);
    return;
  }
  relocate(next->mesh, next->born, cache);
  const auto poorest = mesh::poorest_cell(next->mesh);
  result.min_quality = poorest.scaled_jacobian;
  if (poorest.cell >= 0 && !(poorest.scaled_jacobian >= bound.min_scaled_jacobian))
    result.poor = poor_cell_report(next->mesh, *next->born, poorest, bound.min_scaled_jacobian);
  result.shape = std::move(next);
}

}  // namespace

ShapeStepResult evolve(const body::ShapePtr& shape, base::Analysis analysis, const std::vector<WornBoundary>& worn,
                       const QualityBound& bound, RelocationCache* cache) {
  ShapeStepResult result;
  if (result.failure = bad_loss(worn); !result.failure.empty()) return result;
  const auto nodes = worn_nodes(shape->mesh, worn);
  if (nodes.empty()) {
    result.shape = shape;
    result.min_quality = mesh::poorest_cell(shape->mesh).scaled_jacobian;
    return result;
  }
  const auto outline = outline_of(shape->mesh);
  auto moved = move_outline(analysis, shape->mesh, outline, nodes);
  result.theta = moved.theta;
  result.parts = moved.parts;
  if (result.failure = moved.failure; !result.failure.empty()) return result;
  auto next = std::make_shared<body::Shape>(*shape);
  next->mesh.X = std::move(moved.X);
  slide_sides(next->mesh, *shape->born, nodes);
  result.removed = strip_between(analysis, shape->mesh.X, next->mesh.X, touched_facets(outline, nodes));
  judge(result, std::move(next), bound, cache);
  return result;
}

}  // namespace reye::adapt
