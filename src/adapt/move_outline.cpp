#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "adapt/outline.hpp"

namespace reye::adapt {

namespace {

/// Limits on one part: the farthest a node goes, against the shorter of its facets, and how far theta may be
/// from 1. The first also keeps normals from crossing: with turning below 50 degrees kappa W < 0.2.
constexpr double max_advance = 0.2, max_correction = 1e-2;
constexpr int max_parts = 1024;

struct Motion {
  Analysis analysis;
  const Outline& outline;
  const std::vector<WornNode>& nodes;
  const std::vector<Facet> facets;
  const double volume;
};

/// A node that went too far in one part, -1 if none did.
struct Overshoot {
  int node = -1;
  double ratio = 0.0;  ///< of its advance to the shorter of its facets
};

Overshoot overshoot(const Motion& m, const Points& X, const Points& step) {
  Overshoot worst{-1, max_advance};
  for (const auto& worn : m.nodes) {
    const int j = worn.node;
    const double spacing = std::min((X[m.outline.before[j]] - X[j]).norm(), (X[m.outline.after[j]] - X[j]).norm());
    const double ratio = step[j].norm() / spacing;
    if (!(ratio <= worst.ratio)) worst = {j, ratio};
  }
  return worst;
}

std::string too_far(const Vec2& at, double ratio) {
  std::ostringstream text;
  text << "the outline cannot follow the wear at (" << at.x() << ", " << at.y() << ") mm: even in " << max_parts
       << " parts of the step ";
  if (std::isfinite(ratio))
    text << "a node advances " << ratio << " times its facet, more than " << max_advance;
  else
    text << "no factor near 1 gives the strip its volume";
  return text.str();
}

/// One part of the motion in place; empty failure when it kept within the limits.
void move_part(const Motion& m, int parts, MovedOutline& moved) {
  const double share = 1.0 / parts;
  Points step(moved.X.size(), Vec2::Zero());
  for (const auto& worn : m.nodes) step[worn.node] = share * nodal_step(m.analysis, moved.X, m.outline, worn);
  const auto worst = overshoot(m, moved.X, step);
  if (worst.node >= 0) {
    moved.failure = too_far(moved.X[worst.node], worst.ratio);
    return;
  }
  const double theta = exact_factor(m.analysis, moved.X, m.facets, step, share * m.volume);
  if (!(std::abs(theta - 1.0) <= max_correction)) {
    moved.failure = too_far(moved.X[m.nodes.front().node], std::numeric_limits<double>::quiet_NaN());
    return;
  }
  if (std::abs(theta - 1.0) > std::abs(moved.theta - 1.0)) moved.theta = theta;
  for (const auto& worn : m.nodes) moved.X[worn.node] += theta * step[worn.node];
}

MovedOutline move_in(const Motion& m, const Points& X, int parts) {
  MovedOutline moved{X, 1.0, parts, {}};
  for (int part = 0; part < parts && moved.failure.empty(); ++part) move_part(m, parts, moved);
  return moved;
}

}  // namespace

MovedOutline move_outline(Analysis analysis, const mesh::Mesh& mesh, const Outline& outline,
                          const std::vector<WornNode>& nodes) {
  double volume = 0.0;
  for (const auto& worn : nodes) volume += worn.total();
  const Motion motion{analysis, outline, nodes, touched_facets(outline, nodes), volume};
  auto moved = move_in(motion, mesh.X, 1);
  for (int parts = 2; !moved.failure.empty() && parts <= max_parts; parts *= 2) moved = move_in(motion, mesh.X, parts);
  return moved;
}

}  // namespace reye::adapt
