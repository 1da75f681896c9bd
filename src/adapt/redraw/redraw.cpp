#include "adapt/redraw/redraw.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "adapt/redraw/own_outline.hpp"
#include "adapt/redraw/trace.hpp"
#include "adapt/shape/fit.hpp"
#include "adapt/shape/runs.hpp"
#include "mesh/measure.hpp"

namespace reye::adapt {

namespace {

/// The old drawing and the nodes of one loop on it.
struct Source {
  const body::Shape& shape;
  const cad::Drawing& drawing;
  const Trace& traced;
  std::size_t loop = 0;
  double tolerance = 0.0;  ///< of fits; 0: chosen

  const Vec2& now(int node) const { return shape.mesh.X[node]; }
  const Vec2& born(int node) const { return shape.born->X[node]; }
  const cad::Edge& edge(int k) const { return drawing.part.loops[loop][k]; }
};

/// Boundaries an edge belongs to, and its physical names.
struct Membership {
  std::vector<bool> boundaries;
  std::set<std::string> names;
  bool operator==(const Membership&) const = default;
};

Membership membership(const Source& s, int edge) {
  Membership m{{}, s.edge(edge).names};
  for (const auto& [name, choice] : s.drawing.boundaries) m.boundaries.push_back(choice[s.loop][edge]);
  return m;
}

/// Whether a node has left the straight line its edge is; round-off of many steps along the line does not count.
bool off_line(const Source& s, const cad::Edge& line, int node) {
  const Vec2 t = (line.last() - line.first()).normalized(), way = s.now(node) - line.first();
  const double slack = 1e-12 * (way.norm() + line.length()) + 1e-8 * (s.now(node) - s.born(node)).norm();
  return std::abs(base::cross(t, way)) > slack;
}

bool worn_here(const Source& s, int edge, int node) {
  const cad::Edge& e = s.edge(edge);
  if (s.now(node) == s.born(node)) return false;
  return e.worn || e.type != cad::EdgeType::line || off_line(s, e, node);
}

/// Where the old drawing has a corner.
bool drawn_corner(const Source& s, const Segment& before, const Segment& after) {
  return before.edge != after.edge && cad::kink(s.edge(before.edge), s.edge(after.edge)) > drawn_kink;
}

/// Marks the segments that begin at a node which a fresh outline must keep.
void mark_hard(const Source& s, std::vector<Segment>& segments) {
  const auto sharp = corners(segments, s.shape.mesh.X);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& before = segments[(i + segments.size() - 1) % segments.size()];
    Segment& here = segments[i];
    const bool joint = before.edge != here.edge;
    here.hard = (joint && membership(s, before.edge) != membership(s, here.edge)) ||
                (sharp[i] && (joint || before.worn || here.worn)) ||
                (drawn_corner(s, before, here) && turning_at(segments, i, s.shape.mesh.X) > least_turning);
  }
}

/// The outline loop as segments.
std::vector<Segment> segments_of(const Source& s) {
  std::vector<Segment> segments;
  const auto& loop = s.shape.mesh.outline[s.loop];
  const auto step = static_cast<std::size_t>(mesh::order(s.shape.mesh.kind));
  for (int k = 0; k < static_cast<int>(s.drawing.part.loops[s.loop].size()); ++k) {
    const auto nodes = nodes_on(loop, s.traced.start[s.loop], static_cast<std::size_t>(k));
    for (std::size_t i = 0; i + step < nodes.size(); i += step) {
      Segment segment{nodes[i], nodes[i + step], k, i == 0, i + step + 1 == nodes.size()};
      segment.length = (s.now(segment.b) - s.now(segment.a)).norm();
      if (step == 2) segment.mid = nodes[i + 1];
      for (std::size_t j = i; j <= i + step; ++j) segment.worn = segment.worn || worn_here(s, k, nodes[j]);
      segments.push_back(segment);
    }
  }
  mark_hard(s, segments);
  return segments;
}

double tolerance_of(const Source& s, const std::vector<Segment>& run) {
  if (s.tolerance > 0.0) return s.tolerance;
  double length = 0.0;
  for (const Segment& segment : run) length += segment.length;
  constexpr double of_mean_facet = 0.05;
  return of_mean_facet * length / static_cast<double>(run.size());
}

Points places(const Source& s, const std::vector<Segment>& run) {
  Points points{s.now(run.front().a)};
  for (const Segment& segment : run) {
    if (segment.mid >= 0) points.push_back(s.now(segment.mid));
    points.push_back(s.now(segment.b));
  }
  return points;
}

cad::Edge worn_edge(const Source& s, const std::vector<Segment>& run) {
  cad::Edge edge = fit(cad::EdgeType::spline, places(s, run), tolerance_of(s, run));
  edge.worn = true;
  return edge;
}

/// The new edge for a run of segments that are still on one drawn curve.
cad::Edge fresh_edge(const Source& s, const std::vector<Segment>& run) {
  const cad::Edge& old = s.edge(run.front().edge);
  const Vec2 &first = s.now(run.front().a), &last = s.now(run.back().b);
  if (old.type == cad::EdgeType::line) return cad::make_edge(old.type, {first, last}, {last - first, last - first});
  if (old.straight && !old.worn) return fit(old.type, places(s, run), tolerance_of(s, run));
  const double s0 = run.front().starts_edge ? 0.0 : cad::foot_on(old, first).s;
  const double s1 = run.back().ends_edge ? old.length() : cad::foot_on(old, last).s;
  cad::Edge edge = cad::trimmed(old, s0, s1);
  edge.knots.front() = first;
  edge.knots.back() = last;
  return edge;
}

/// Draws one loop; `source` receives the old edge each new one replaces, with its names.
cad::Loop draw_loop(const Source& s, std::vector<int>& source) {
  cad::Loop loop;
  std::vector<bool> worn_edges;
  for (const cad::Edge& edge : s.drawing.part.loops[s.loop]) worn_edges.push_back(edge.worn);
  for (const auto& run : runs_of(segments_of(s), worn_edges)) {
    loop.push_back(run.front().worn ? worn_edge(s, run) : fresh_edge(s, run));
    loop.back().names = s.edge(run.front().edge).names;
    source.push_back(run.front().edge);
  }
  return loop;
}

bool nothing_moved(const body::Shape& shape) {
  for (const auto& loop : shape.mesh.outline)
    for (int node : loop)
      if (shape.mesh.X[node] != shape.born->X[node]) return false;
  return true;
}

std::string of_body(const cad::Drawing& drawing) {
  return drawing.options.name.empty() ? "" : " of body '" + drawing.options.name + "'";
}

/// Longest facet next to a chain that is not closed.
double facet_beside(const mesh::Mesh& mesh, const mesh::Chain& chain) {
  double longest = 0.0;
  for (const auto& loop : mesh.outline)
    for (std::size_t i = 0; i + 1 < loop.size(); ++i)
      if (loop[i + 1] == chain.front() || loop[i] == chain.back())
        longest = std::max(longest, (mesh.X[loop[i + 1]] - mesh.X[loop[i]]).norm());
  return longest;
}

constexpr double vanishing = 1e-3;  ///< of the facet beside

/// The named boundary that wear has made shorter than a thousandth of the facets beside it.
std::string vanished_boundary(const mesh::Mesh& mesh, const cad::Drawing& drawing) {
  for (const auto& [name, chains] : mesh.boundaries) {
    double facet = 0.0;
    for (const auto& chain : chains) facet = std::max(facet, facet_beside(mesh, chain));
    if (!chains.empty() && mesh::length(mesh.X, chains) < vanishing * facet)
      return "boundary '" + name + "'" + of_body(drawing) + " has vanished by wear";
  }
  return {};
}

/// A side without a name that has vanished, recognised by the length of its drawn edge against its neighbours.
std::string vanished_edge(const cad::Drawing& drawing) {
  for (const auto& loop : drawing.part.loops)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const double beside =
          std::max(loop[(k + 1) % loop.size()].length(), loop[(k + loop.size() - 1) % loop.size()].length());
      if (loop[k].length() > 1e-6 * beside) continue;
      std::ostringstream text;
      text << "the side" << of_body(drawing) << " at (" << loop[k].first().x() << ", " << loop[k].first().y()
           << ") mm has vanished by wear";
      return text.str();
    }
  return {};
}

void draw_loops(const body::Shape& shape, const cad::Drawing& old, const Trace& traced, double tolerance,
                cad::Drawing& next) {
  for (auto& [name, choice] : next.boundaries) choice.clear();
  next.part.loops.clear();
  for (std::size_t l = 0; l < old.part.loops.size(); ++l) {
    std::vector<int> source;
    next.part.loops.push_back(draw_loop({shape, old, traced, l, tolerance}, source));
    for (auto& [name, choice] : next.boundaries) {
      auto& chosen = choice.emplace_back();
      for (int k : source) chosen.push_back(old.boundaries.at(name)[l][k]);
    }
  }
}

}  // namespace

Redrawn redraw(const body::Shape& shape, double fit_tolerance_mm) {
  const cad::Drawing old = shape.drawing ? *shape.drawing : drawing_of(*shape.born);
  if (shape.drawing && nothing_moved(shape)) return {old, {}};
  Redrawn redrawn{old, vanished_boundary(shape.mesh, old)};
  if (!redrawn.failure.empty()) return redrawn;
  const Trace traced = trace(old.part.loops, shape.born->outline, shape.born->X);
  if (redrawn.failure = traced.failure; !redrawn.failure.empty()) return redrawn;
  draw_loops(shape, old, traced, fit_tolerance_mm, redrawn.drawing);
  if (old.part.mesh) wish_sizes_of(shape.mesh, redrawn.drawing);
  redrawn.drawing.part.mesh.reset();
  redrawn.failure = vanished_edge(redrawn.drawing);
  return redrawn;
}

}  // namespace reye::adapt
