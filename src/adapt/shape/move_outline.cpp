#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "adapt/shape/outline.hpp"

namespace reye::adapt {

namespace {

/// Limits on one part: the farthest a node goes, against the shorter of its facets, and how far theta may be
/// from 1. The first also keeps normals from crossing: with turning below 50 degrees kappa W < 0.2.
constexpr double max_advance = 0.2, max_correction = 1e-2;
constexpr int max_parts = 1024;

/// Where along its chord a middle node may be.
constexpr double first_middle = 0.4, last_middle = 0.6;

struct Motion {
  Analysis analysis;
  const Outline& outline;
  const std::vector<WornNode>& nodes;
  const std::vector<LineFacet> facets;
  const double volume;
};

/// Steps of all nodes and control points for a share of the wear.
Points steps(const Motion& m, const Points& P, double share) {
  Points step(P.size(), Vec2::Zero());
  std::vector<double> volume(P.size(), 0.0);
  for (const auto& worn : m.nodes)
    if (m.outline.middle[worn.node])
      volume[worn.node] = share * worn.total();
    else
      step[worn.node] = share * nodal_step(m.analysis, P, m.outline, worn);
  for (const auto& [a, b, c] : m.facets)
    if (c >= 0) step[c] = control_step(m.analysis, {P[a], P[b], P[c]}, {step[a], step[b]}, volume[c]);
  return step;
}

/// Keeps middle nodes away from the ends of their edges: they move along the new chord, which changes no area in the
/// plane.
void centre(const Motion& m, const Points& P, Points& step) {
  for (const auto& [a, b, c] : m.facets) {
    if (c < 0) continue;
    const Vec2 first = P[a] + step[a], chord = P[b] + step[b] - first;
    const double s = 0.25 + 0.5 * (P[c] + step[c] - first).dot(chord) / chord.squaredNorm();
    step[c] += 2.0 * (std::clamp(s, first_middle, last_middle) - s) * chord;
  }
}

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

/// One part of the motion of nodes and control points in place; empty failure when it kept within the limits.
void move_part(const Motion& m, int parts, MovedOutline& moved) {
  const double share = 1.0 / parts;
  Points step = steps(m, moved.X, share);
  const auto worst = overshoot(m, moved.X, step);
  if (worst.node >= 0) {
    moved.failure = too_far(moved.X[worst.node], worst.ratio);
    return;
  }
  centre(m, moved.X, step);
  const double theta = exact_factor(m.analysis, moved.X, m.facets, step, share * m.volume);
  if (!(std::abs(theta - 1.0) <= max_correction)) {
    moved.failure = too_far(moved.X[m.nodes.front().node], std::numeric_limits<double>::quiet_NaN());
    return;
  }
  if (std::abs(theta - 1.0) > std::abs(moved.theta - 1.0)) moved.theta = theta;
  for (const auto& worn : m.nodes)
    if (!m.outline.middle[worn.node]) moved.X[worn.node] += theta * step[worn.node];
  for (const auto& facet : m.facets)
    if (facet[2] >= 0) moved.X[facet[2]] += theta * step[facet[2]];
}

MovedOutline move_in(const Motion& m, const Points& X, int parts) {
  MovedOutline moved{mesh::control_points(m.facets, X), 1.0, parts, {}};
  for (int part = 0; part < parts && moved.failure.empty(); ++part) move_part(m, parts, moved);
  moved.X = mesh::middle_nodes(m.facets, std::move(moved.X));
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
