#include "adapt/redraw/trace.hpp"

#include <sstream>

#include "mesh/measure.hpp"

namespace reye::adapt {

namespace {

int nearest(const mesh::Chain& loop, const base::Points& X, const base::Vec2& place) {
  int best = 0;
  for (int i = 1; i + 1 < static_cast<int>(loop.size()); ++i)
    if ((X[loop[i]] - place).squaredNorm() < (X[loop[best]] - place).squaredNorm()) best = i;
  return best;
}

std::string misfit(const base::Vec2& at) {
  std::ostringstream text;
  text << "the drawing is not that of the mesh at (" << at.x() << ", " << at.y() << ") mm";
  return text.str();
}

}  // namespace

Trace trace(const std::vector<cad::Loop>& loops, const std::vector<mesh::Chain>& outline, const base::Points& X) {
  Trace traced;
  if (loops.size() != outline.size()) {
    traced.failure =
        "the drawing has " + std::to_string(loops.size()) + " loops, the mesh " + std::to_string(outline.size());
    return traced;
  }
  const auto box = mesh::bounding_box(X);
  const double tolerance = 1e-6 * std::hypot(box[2] - box[0], box[3] - box[1]);
  for (std::size_t l = 0; l < loops.size(); ++l) {
    auto& start = traced.start.emplace_back();
    const int n = static_cast<int>(outline[l].size()) - 1;
    int walked = -1;
    for (const cad::Edge& edge : loops[l]) {
      start.push_back(nearest(outline[l], X, edge.first()));
      const int way = (start.back() - start.front() + n) % n;
      if (way <= walked || !((X[outline[l][start.back()]] - edge.first()).norm() <= tolerance)) {
        traced.failure = misfit(edge.first());
        return traced;
      }
      walked = way;
    }
  }
  return traced;
}

std::vector<int> nodes_on(const mesh::Chain& loop, const std::vector<int>& start, std::size_t edge) {
  const std::size_t n = loop.size() - 1, first = static_cast<std::size_t>(start[edge]);
  const std::size_t next = static_cast<std::size_t>(start[(edge + 1) % start.size()]);
  std::vector<int> nodes{loop[first]};
  const std::size_t count = next == first ? n : (next + n - first) % n;
  for (std::size_t k = 1; k <= count; ++k) nodes.push_back(loop[(first + k) % n]);
  return nodes;
}

}  // namespace reye::adapt
