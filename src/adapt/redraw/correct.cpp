#include "adapt/redraw/correct.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "adapt/shape/segment_tree.hpp"
#include "adapt/shape/strip.hpp"
#include "mesh/quadratic_edge.hpp"

namespace reye::adapt {

namespace {

using base::Vec2;

Points at(const Points& X, const std::vector<int>& nodes) {
  Points points;
  for (int node : nodes) points.push_back(X[node]);
  return points;
}

double length(const Points& p) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < p.size(); ++i) sum += (p[i + 1] - p[i]).norm();
  return sum;
}

/// Outward unit normal times weight at every point; zero at the ends.
Points directions(const Points& p) {
  const double whole = length(p), taper = 2.0 * whole / static_cast<double>(p.size() - 1);
  Points d(p.size(), Vec2::Zero());
  double s = 0.0;
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    const Vec2 in = p[i] - p[i - 1], out = p[i + 1] - p[i];
    s += in.norm();
    d[i] = std::min(1.0, std::min(s, whole - s) / taper) *
           base::right_of(in / in.squaredNorm() + out / out.squaredNorm()).normalized();
  }
  return d;
}

Points moved(const Points& p, const Points& d, double by) {
  Points q = p;
  for (std::size_t i = 0; i < p.size(); ++i) q[i] += by * d[i];
  return q;
}

/// Length by which points are to be moved along d to gain `volume`.
double gain(Analysis analysis, const Points& p, const Points& d, double volume, int order) {
  if (volume == 0.0) return 0.0;
  const double start = fan_volume(analysis, p, order), target = start + volume;
  double radius = 1.0;
  if (analysis == Analysis::axisymmetric) {
    radius = 0.0;
    for (const Vec2& x : p) radius += 2.0 * std::numbers::pi * x.x() / static_cast<double>(p.size());
  }
  double by = 0.0, excess = -volume, next = volume / (length(p) * radius);
  for (int i = 0; i < 30; ++i) {
    const double f = fan_volume(analysis, moved(p, d, next), order) - target;
    if (!(std::abs(f) < std::abs(excess))) break;  // round-off reached
    const double slope = (f - excess) / (next - by);
    by = next;
    excess = f;
    if (f == 0.0) break;
    next = by - f / slope;
  }
  return by;
}

/// Signed distance, outward positive, of a point from the nearest place of a polyline, and where that is.
struct FootOnLine {
  std::size_t segment = 0;
  double s = 0.0, distance = 0.0;
};

FootOnLine beside(const SegmentTree& tree, const Points& line, const Vec2& x) {
  const auto foot = tree.nearest(x);
  const auto k = static_cast<std::size_t>(foot.segment);
  const Vec2 e = line[k + 1] - line[k];
  return {k, foot.s, base::right_of(e).dot(x - line[k] - foot.s * e) / e.norm()};
}

SegmentTree tree_of(const Points& line) {
  std::vector<SegmentTree::Segment> segments;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) segments.push_back({line[i], line[i + 1]});
  return SegmentTree(std::move(segments));
}

/// Height of the old polyline over the new one, at arc lengths of the new one; linear between them.
std::vector<std::array<double, 2>> heights(const Points& old, const Points& fresh, const std::vector<double>& arc) {
  std::vector<std::array<double, 2>> h;
  const SegmentTree on_fresh = tree_of(fresh), on_old = tree_of(old);
  for (std::size_t j = 1; j + 1 < old.size(); ++j) {
    const FootOnLine b = beside(on_fresh, fresh, old[j]);
    h.push_back({arc[b.segment] + b.s * (arc[b.segment + 1] - arc[b.segment]), b.distance});
  }
  for (std::size_t k = 0; k < fresh.size(); ++k) {
    const bool end = k == 0 || k + 1 == fresh.size();
    h.push_back({arc[k], end ? 0.0 : -beside(on_old, old, fresh[k]).distance});
  }
  std::sort(h.begin(), h.end());
  return h;
}

std::vector<double> arc_along(const Points& line) {
  std::vector<double> arc{0.0};
  for (std::size_t k = 1; k < line.size(); ++k) arc.push_back(arc.back() + (line[k] - line[k - 1]).norm());
  return arc;
}

/// int N_k h ds of the hats on a line, h being linear between the places where it is known.
std::vector<double> hat_contents(const std::vector<std::array<double, 2>>& h, const std::vector<double>& arc) {
  std::vector<double> content(arc.size(), 0.0);
  std::size_t k = 0;
  for (std::size_t i = 0; i + 1 < h.size(); ++i) {
    const auto& [s0, h0] = h[i];
    const auto& [s1, h1] = h[i + 1];
    const double middle = 0.5 * (s0 + s1), width = s1 - s0;
    while (k + 2 < arc.size() && middle > arc[k + 1]) ++k;
    const auto hat = [&](double s) { return (s - arc[k]) / (arc[k + 1] - arc[k]); };
    const double right =
        width / 6.0 * (h0 * hat(s0) + 4.0 * 0.5 * (h0 + h1) * hat(middle) + h1 * hat(s1));  // Simpson: exact
    content[k + 1] += right;
    content[k] += 0.5 * width * (h0 + h1) - right;
  }
  return content;
}

std::vector<double> hat_lengths(const std::vector<double>& arc) {
  std::vector<double> length(arc.size(), 0.0);
  for (std::size_t j = 1; j < arc.size(); ++j)
    for (std::size_t end : {j - 1, j}) length[end] += 0.5 * (arc[j] - arc[j - 1]);
  return length;
}

/// Mean heights of the inner nodes; the ends, which stay, leave their contents to their neighbours.
std::vector<double> inner_heights(std::vector<double> content, const std::vector<double>& length) {
  const std::size_t n = content.size();
  content[1] += content[0];
  content[n - 2] += content[n - 1];
  std::vector<double> height(n, 0.0);
  for (std::size_t j = 1; j + 1 < n; ++j) height[j] = content[j] / length[j];
  return height;
}

/// Shift of every inner node along its outward normal that gives each piece of the outline the content it had there:
/// d_k = int N_k h ds / int N_k ds, the ends' shares with their neighbours'. A contact responds to the mean height over
/// an element, so content that is kept only in total would still change pressures.
std::vector<double> local_shifts(const Points& old, const Points& fresh) {
  const auto arc = arc_along(fresh);
  return inner_heights(hat_contents(heights(old, fresh, arc), arc), hat_lengths(arc));
}

constexpr std::size_t chords = 8;  ///< that represent a quadratic edge where heights are measured

/// Points along a chain of quadratic edges, `chords` for each.
Points sampled(const Points& p) {
  Points points{p.front()};
  for (std::size_t i = 0; i + 2 < p.size(); i += 2)
    for (std::size_t k = 1; k <= chords; ++k)
      points.push_back(mesh::QuadraticEdge{p[i], p[i + 1], p[i + 2]}.at(2.0 * static_cast<double>(k) / chords - 1.0));
  return points;
}

/// int B_k h ds and int B_k ds of the functions on quadratic edges.
struct BernsteinShares {
  std::vector<double> content, length;

  /// Adds a point of a rule, at t on the edge whose first node is i0.
  void add(std::size_t i0, double t, double height, double weight) {
    const std::array<double, 3> B{(1.0 - t) * (1.0 - t), 2.0 * t * (1.0 - t), t * t};
    for (std::size_t j = 0; j < 3; ++j) {
      content[i0 + j] += weight * B[j] * height;
      length[i0 + j] += weight * B[j];
    }
  }
};

/// Shares of n nodes in h over a line of chords.
BernsteinShares bernstein_shares(const std::vector<std::array<double, 2>>& h, const std::vector<double>& arc,
                                 std::size_t n) {
  BernsteinShares shares{std::vector<double>(n, 0.0), std::vector<double>(n, 0.0)};
  std::size_t k = 0;  // the chord; i0: the first node of its edge
  for (std::size_t i = 0; i + 1 < h.size(); ++i) {
    const auto& [s0, h0] = h[i];
    const auto& [s1, h1] = h[i + 1];
    const double middle = 0.5 * (s0 + s1), width = s1 - s0;
    while (k + 2 < arc.size() && middle > arc[k + 1]) ++k;
    const std::size_t i0 = 2 * (k / chords);
    const auto t = [&](double s) {
      return (static_cast<double>(k % chords) + (s - arc[k]) / (arc[k + 1] - arc[k])) / chords;
    };
    shares.add(i0, t(s0), h0, 1.0 / 6.0 * width);  // Simpson: exact
    shares.add(i0, t(middle), 0.5 * (h0 + h1), 4.0 / 6.0 * width);
    shares.add(i0, t(s1), h1, 1.0 / 6.0 * width);
  }
  return shares;
}

/// Depths for quadratic edges: W_k = int B_k h ds / int B_k ds at vertices and control points, and the depth these
/// give at each node.
std::vector<double> curved_shifts(const Points& old, const Points& fresh) {
  const std::size_t n = fresh.size();
  const Points line = sampled(fresh);
  const auto arc = arc_along(line);
  auto [content, length] = bernstein_shares(heights(sampled(old), line, arc), arc, n);
  const std::vector<double> W = inner_heights(std::move(content), length);
  std::vector<double> shift = W;
  for (std::size_t j = 1; j + 1 < n; j += 2) shift[j] = 0.25 * (W[j - 1] + 2.0 * W[j] + W[j + 1]);
  return shift;
}

/// The points of a worn edge moved by their local shifts.
Points placed(const Points& old, const Points& fresh, int order) {
  const std::vector<double> shift = order == 1 ? local_shifts(old, fresh) : curved_shifts(old, fresh);
  Points p = fresh;
  for (std::size_t i = 1; i + 1 < fresh.size(); ++i) {
    const Vec2 in = fresh[i] - fresh[i - 1], out = fresh[i + 1] - fresh[i];
    p[i] += shift[i] * base::right_of(in.normalized() + out.normalized()).normalized();
  }
  return p;
}

/// Content between a quadratic edge and its chord, lost when the edge becomes straight.
double under_curve(Analysis analysis, const Vec2& a, const Vec2& mid, const Vec2& b) {
  const Vec2 control = 2.0 * mid - 0.5 * (a + b);
  const std::array<Vec2, 3> onto_chord{Vec2::Zero(), Vec2::Zero(), 0.5 * (a + b) - control};
  return swept_volume(analysis, std::array{a, b, control}, onto_chord);
}

}  // namespace

double fan_volume(Analysis analysis, const Points& p, int order) {
  const bool ring = analysis == Analysis::axisymmetric;
  const auto step = static_cast<std::size_t>(order);
  double sum = 0.0;
  for (std::size_t i = step; i + step < p.size(); i += step) {
    const double area = 0.5 * base::cross(p[i] - p[0], p[i + step] - p[i]);
    sum += ring ? 2.0 * std::numbers::pi / 3.0 * area * (p[0].x() + p[i].x() + p[i + step].x()) : area;
  }
  for (std::size_t i = 0; order == 2 && i + 2 < p.size(); i += 2)
    sum += under_curve(analysis, p[i], p[i + 1], p[i + 2]);
  return sum;
}

Correction correct(Analysis analysis, const Points& before, const Points& after, const std::vector<EdgePair>& edges,
                   int order) {
  Correction c{Points(after.size(), Vec2::Zero())};
  std::vector<Points> fresh;
  std::vector<double> missing;
  std::size_t longest = edges.size();
  const std::size_t shortest = 1 + static_cast<std::size_t>(order);  // an edge of one facet has no inner vertex
  const auto correctable = [&](std::size_t k) { return edges[k].worn && edges[k].after.size() > shortest; };
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const Points old = at(before, edges[k].before), made = at(after, edges[k].after);
    fresh.push_back(correctable(k) ? placed(old, made, order) : made);
    const double content = fan_volume(analysis, old, order);
    c.residue += fan_volume(analysis, made, order) - content;
    missing.push_back(content - fan_volume(analysis, fresh[k], order));
    if (correctable(k) && (longest == edges.size() || length(fresh[k]) > length(fresh[longest]))) longest = k;
  }
  for (std::size_t k = 0; k < edges.size(); ++k)
    if (!correctable(k)) {
      (longest < edges.size() ? missing[longest] : c.left) += missing[k];
      missing[k] = 0.0;
    }
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (!correctable(k)) continue;
    const Points d = directions(fresh[k]);
    const double by = gain(analysis, fresh[k], d, missing[k], order);
    for (std::size_t i = 1; i + 1 < fresh[k].size(); ++i) {
      const int node = edges[k].after[i];
      c.shift[node] = fresh[k][i] + by * d[i] - after[node];
      c.largest_mm = std::max(c.largest_mm, c.shift[node].norm());
    }
  }
  return c;
}

}  // namespace reye::adapt
