#include "cad/build/profile.hpp"

#include <algorithm>
#include <cmath>

#include "cad/build/height_curve.hpp"
#include "cad/meshing/region.hpp"
#include "cad/part/text.hpp"

namespace reye::cad {

namespace {

constexpr double height_tolerance = 1e-9;  // mm, of heights at ends
constexpr double smooth = 1e-3;            // rad: a joint that turns by more is a corner

/// The edges of a boundary in the order of the loop.
struct Run {
  int loop = 0;
  std::vector<int> edges;
  std::vector<double> begin;  ///< arc length at which each edge begins
  double length = 0.0;
};

struct DoesNotFit {
  std::string rule;
};

std::vector<Run> runs_of(const Part& part, const EdgeChoice& chosen) {
  std::vector<Run> runs;
  for (int loop = 0; loop < static_cast<int>(chosen.size()); ++loop) {
    const int count = static_cast<int>(chosen[loop].size());
    if (std::find(chosen[loop].begin(), chosen[loop].end(), false) == chosen[loop].end())
      throw DoesNotFit{"needs a boundary with two ends; this one goes all round"};
    for (int first = 0; first < count; ++first) {
      if (!chosen[loop][first] || chosen[loop][(first + count - 1) % count]) continue;
      Run run{loop, {}, {}, 0.0};
      for (int k = first; chosen[loop][k]; k = (k + 1) % count) {
        run.edges.push_back(k);
        run.begin.push_back(run.length);
        run.length += part.loops[loop][k].length();
      }
      runs.push_back(std::move(run));
    }
  }
  return runs;
}

Run one_run(const Part& part, const EdgeChoice& chosen) {
  const std::vector<Run> runs = runs_of(part, chosen);
  if (runs.size() != 1)
    throw DoesNotFit{"needs one connected boundary; this one has " + std::to_string(runs.size()) + " pieces"};
  const Loop& loop = part.loops[runs[0].loop];
  for (std::size_t i = 0; i + 1 < runs[0].edges.size(); ++i)
    if (kink(loop[runs[0].edges[i]], loop[runs[0].edges[i + 1]]) > smooth)
      throw DoesNotFit{"needs a smooth boundary; this one has a corner at " + text(loop[runs[0].edges[i]].last())};
  return runs[0];
}

/// Whether arc length counts against the direction of the loop: from the end with smaller x, then smaller y.
bool counts_backward(const Vec2& first, const Vec2& last) {
  return last.x() < first.x() || (last.x() == first.x() && last.y() < first.y());
}

void check_range(const Profile& profile, double length) {
  const auto& [file, s, h] = profile;
  const double slack = 1e-6 * length;
  if (s.back() > length + slack)
    throw DoesNotFit{"reaches to arc length " + text(s.back()) + " mm; the boundary is " + text(length) + " mm long"};
  for (const auto& [arc, height, inside] :
       {std::tuple{s.front(), h.front(), s.front() > slack}, std::tuple{s.back(), h.back(), s.back() < length - slack}})
    if (inside && std::abs(height) > height_tolerance)
      throw DoesNotFit{"the height at arc length " + text(arc) + " mm, where it ends within the boundary, is " +
                       text(height) + " mm; it must be 0 there"};
  for (double height : h)
    if (std::abs(height) >= length)
      throw DoesNotFit{"a height of " + text(height) + " mm is out of proportion to a boundary " + text(length) +
                       " mm long"};
}

/// The profile in the direction of the loop, from one end of the boundary to the other.
HeightCurve height_along(const Profile& profile, double length, bool backward) {
  check_range(profile, length);
  std::vector<double> arc = profile.arc_mm, height = profile.height_mm;
  if (backward) {
    std::reverse(arc.begin(), arc.end());
    std::reverse(height.begin(), height.end());
    for (double& s : arc) s = length - s;
  }
  const double slack = 1e-6 * length;
  if (arc.front() > slack) {
    arc.insert(arc.begin(), 0.0);
    height.insert(height.begin(), 0.0);
  }
  if (arc.back() < length - slack) {
    arc.push_back(length);
    height.push_back(0.0);
  }
  arc.front() = 0.0;
  arc.back() = length;
  return {std::move(arc), std::move(height)};
}

/// Arc lengths on an edge for the knots of its displaced curve: the points of the profile, points between them, and a
/// grid as fine as that of CAD curves.
std::vector<double> knots_on(const HeightCurve& curve, double begin, double length) {
  const double step = length / 1024.0;
  const int parts = std::clamp(4096 / static_cast<int>(curve.arc().size()), 1, 64);
  std::vector<double> fine, knots{0.0};
  for (std::size_t i = 0; i + 1 < curve.arc().size(); ++i)
    for (int k = 0; k < parts; ++k)
      fine.push_back(curve.arc()[i] + (curve.arc()[i + 1] - curve.arc()[i]) * k / parts - begin);
  fine.push_back(length);
  for (double s : fine) {
    if (s < 1e-9 * length || s > length) continue;
    const double from = knots.back();
    for (int k = 1; from + (k + 0.25) * step < s; ++k) knots.push_back(from + k * step);
    if (s - knots.back() > 1e-9 * length) knots.push_back(s);
  }
  knots.back() = length;
  return knots;
}

/// Curvature, positive where the loop turns left.
double curvature(const Edge& edge, double s) {
  if (edge.type == EdgeType::line) return 0.0;
  const double reach = edge.length() / 1024.0;
  const double low = std::max(0.0, s - reach), high = std::min(edge.length(), s + reach);
  const Vec2 a = tangent_at(edge, low), b = tangent_at(edge, high);
  return std::atan2(base::cross(a, b), a.dot(b)) / (high - low);
}

/// x(s) + h(s) n(s), whose derivative is (1 + h curvature) t + h' n.
Edge displaced(const Edge& edge, const HeightCurve& curve, double begin) {
  Points knots, directions;
  for (double s : knots_on(curve, begin, edge.length())) {
    const Vec2 t = tangent_at(edge, s), n = base::right_of(t);
    const auto [height, slope] = curve.at(begin + s);
    const double stretch = 1.0 + height * curvature(edge, s);
    if (stretch <= 0.0) throw DoesNotFit{"is deeper than the boundary's radius near " + text(at(edge, s))};
    knots.push_back(at(edge, s) + height * n);
    directions.push_back(stretch * t + slope * n);
  }
  Edge moved = make_edge(EdgeType::spline, std::move(knots), std::move(directions));
  moved.names = edge.names;
  return moved;
}

/// A straight neighbour of the boundary whose end goes from `old_end` to `end`.
Edge stretched(const Edge& edge, const Vec2& old_end, const Vec2& end) {
  const bool at_first = (edge.first() - old_end).norm() < (edge.last() - old_end).norm();
  const Vec2 stays = at_first ? edge.last() : edge.first();
  const Vec2 before = stays - old_end, after = stays - end;
  if (edge.type != EdgeType::line ||
      std::abs(base::cross(before.normalized(), end - old_end)) > 1e-6 * (end - old_end).norm())
    throw DoesNotFit{"the height at the end " + text(old_end) +
                     " of the boundary must be 0: no straight edge continues there at a right angle"};
  if (before.dot(after) <= 0.0)
    throw DoesNotFit{"the height at the end " + text(old_end) + " of the boundary takes all of the next edge, " +
                     describe(edge)};
  const Vec2 along = at_first ? after : Vec2(-after);
  Edge moved = make_edge(EdgeType::line, at_first ? Points{end, stays} : Points{stays, end}, {along, along});
  moved.names = edge.names;
  return moved;
}

/// Makes ends meet exactly: of the displaced edges with each other and with their neighbours.
void join(Part& part, const Part& before, const Run& run) {
  Loop& loop = part.loops[run.loop];
  const Loop& old = before.loops[run.loop];
  const int count = static_cast<int>(loop.size());
  for (std::size_t i = 0; i + 1 < run.edges.size(); ++i)
    loop[run.edges[i + 1]].knots.front() = loop[run.edges[i]].knots.back();
  const auto settle = [&](Vec2& end, const Vec2& old_end, int neighbour) {
    if ((end - old_end).norm() <= height_tolerance)
      end = old_end;
    else
      loop[neighbour] = stretched(loop[neighbour], old_end, end);
  };
  settle(loop[run.edges.front()].knots.front(), old[run.edges.front()].first(),
         (run.edges.front() + count - 1) % count);
  settle(loop[run.edges.back()].knots.back(), old[run.edges.back()].last(), (run.edges.back() + 1) % count);
}

/// A place where the outline crosses itself. It is laid along the boundary, where the search is quick.
std::optional<Vec2> crossing_of(const Part& part, const Vec2& along) {
  Region region;
  for (const Loop& loop : part.loops) {
    RegionLoop nodes;
    for (const Edge& edge : loop)
      for (std::size_t i = 0; i + 1 < edge.knots.size(); ++i) {
        nodes.nodes.push_back(static_cast<int>(region.X.size()));
        region.X.emplace_back(along.dot(edge.knots[i]), base::cross(along, edge.knots[i]));
      }
    nodes.corner.assign(nodes.nodes.size(), true);
    region.loops.push_back(std::move(nodes));
  }
  region.kind = mesh::CellKind::tri3;
  const auto place = crossing(region);
  if (!place) return std::nullopt;
  return Vec2(place->x() * along - place->y() * base::right_of(along));
}

Part displaced(const Part& part, const EdgeChoice& chosen, const Profile& profile) {
  if (part.mesh) throw DoesNotFit{"needs the edges of a CAD file; the body brings its own mesh"};
  const Run run = one_run(part, chosen);
  const Loop& loop = part.loops[run.loop];
  const Vec2 first = loop[run.edges.front()].first(), last = loop[run.edges.back()].last();
  const HeightCurve curve = height_along(profile, run.length, counts_backward(first, last));
  Part moved = part;
  for (std::size_t i = 0; i < run.edges.size(); ++i)
    moved.loops[run.loop][run.edges[i]] = displaced(loop[run.edges[i]], curve, run.begin[i]);
  join(moved, part, run);
  if (const auto place = crossing_of(moved, (last - first).normalized()))
    throw DoesNotFit{"makes the outline cross itself near " + text(*place)};
  return moved;
}

}  // namespace

std::optional<Part> with_profile(const Part& part, const EdgeChoice& edges, const BoundaryOptions& boundary,
                                 std::vector<base::Issue>& issues) {
  try {
    return displaced(part, edges, *boundary.profile);
  } catch (const DoesNotFit& why) {
    issues.push_back({"boundary." + boundary.name + ".profile", "\"" + boundary.profile->file + "\"", why.rule});
    return std::nullopt;
  }
}

}  // namespace reye::cad
