#include "cad/part/edge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/measure.hpp"

namespace reye::cad {

namespace {

double angle_between(const Vec2& a, const Vec2& b) { return std::atan2(base::cross(a, b), a.dot(b)); }

std::size_t piece_at(const Edge& edge, double s) {
  const auto above = std::upper_bound(edge.arc.begin() + 1, edge.arc.end() - 1, s);
  return static_cast<std::size_t>(above - edge.arc.begin()) - 1;
}

/// Parameter in [0, 1] and width of the piece in which s lies.
std::pair<double, double> local(const Edge& edge, std::size_t piece, double s) {
  const double width = edge.arc[piece + 1] - edge.arc[piece];
  return {std::clamp((s - edge.arc[piece]) / width, 0.0, 1.0), width};
}

}  // namespace

std::string to_string(EdgeType type) {
  return type == EdgeType::line ? "line" : type == EdgeType::circle ? "circle" : "spline";
}

Edge make_edge(EdgeType type, Points knots, Points directions) {
  Edge edge{type, false, std::move(knots), std::move(directions), {0.0}, {}};
  for (Vec2& t : edge.tangents) t.normalize();
  for (std::size_t i = 1; i < edge.knots.size(); ++i) {
    const double chord = (edge.knots[i] - edge.knots[i - 1]).norm();
    const double half = 0.5 * std::abs(angle_between(edge.tangents[i - 1], edge.tangents[i]));
    edge.arc.push_back(edge.arc.back() + (half > 1e-12 && half < 1.0 ? chord * half / std::sin(half) : chord));
  }
  return edge;
}

Edge make_polyline(EdgeType type, Points knots) {
  Edge edge{type, true, std::move(knots), {}, {0.0}, {}};
  for (std::size_t i = 1; i < edge.knots.size(); ++i) {
    const Vec2 chord = edge.knots[i] - edge.knots[i - 1];
    edge.tangents.push_back(chord.normalized());
    edge.arc.push_back(edge.arc.back() + chord.norm());
  }
  edge.tangents.push_back(edge.tangents.back());
  return edge;
}

Vec2 at(const Edge& edge, double s) {
  if (s <= 0.0) return edge.first();
  if (s >= edge.length()) return edge.last();
  const std::size_t i = piece_at(edge, s);
  const auto [u, width] = local(edge, i, s);
  const Vec2 &a = edge.knots[i], &b = edge.knots[i + 1];
  if (edge.straight || edge.type == EdgeType::line) return a + u * (b - a);
  const double v = 1.0 - u;
  return v * v * (1.0 + 2.0 * u) * a + u * u * (3.0 - 2.0 * u) * b +
         width * u * v * (v * edge.tangents[i] - u * edge.tangents[i + 1]);
}

Vec2 tangent_at(const Edge& edge, double s) {
  const std::size_t i = piece_at(edge, s);
  const double u = local(edge, i, s).first;
  if (edge.straight) return edge.tangents[i];
  return ((1.0 - u) * edge.tangents[i] + u * edge.tangents[i + 1]).normalized();
}

Edge reversed(Edge edge) {
  const double total = edge.length();
  if (edge.straight) {
    std::reverse(edge.knots.begin(), edge.knots.end());
    Edge turned = make_polyline(edge.type, std::move(edge.knots));
    turned.names = std::move(edge.names);
    turned.worn = edge.worn;
    return turned;
  }
  std::reverse(edge.knots.begin(), edge.knots.end());
  std::reverse(edge.tangents.begin(), edge.tangents.end());
  std::reverse(edge.arc.begin(), edge.arc.end());
  for (Vec2& t : edge.tangents) t = -t;
  for (double& s : edge.arc) s = total - s;
  return edge;
}

Edge trimmed(const Edge& edge, double s0, double s1) {
  if (s0 <= 0.0 && s1 >= edge.length()) return edge;
  Points knots{at(edge, s0)}, directions{tangent_at(edge, s0)};
  const auto apart = [&](std::size_t i, double s) {
    const double width = s < edge.arc[i] ? edge.arc[i] - edge.arc[i - 1] : edge.arc[i + 1] - edge.arc[i];
    return std::abs(edge.arc[i] - s) > 0.1 * width;
  };
  for (std::size_t i = 1; i + 1 < edge.knots.size(); ++i)
    if (edge.arc[i] > s0 && edge.arc[i] < s1 && apart(i, s0) && apart(i, s1)) {
      knots.push_back(edge.knots[i]);
      directions.push_back(edge.tangents[i]);
    }
  knots.push_back(at(edge, s1));
  directions.push_back(tangent_at(edge, s1));
  Edge part = edge.straight ? make_polyline(edge.type, std::move(knots))
                            : make_edge(edge.type, std::move(knots), std::move(directions));
  part.names = edge.names;
  part.worn = edge.worn;
  return part;
}

Edge begun_at(const Edge& ring, double s) {
  if (s <= 0.0 || s >= ring.length()) return ring;
  Edge edge = trimmed(ring, s, ring.length());
  const Edge rest = trimmed(ring, 0.0, s);
  edge.knots.insert(edge.knots.end(), rest.knots.begin() + 1, rest.knots.end());
  edge.tangents.insert(edge.tangents.end(), rest.tangents.begin() + 1, rest.tangents.end());
  edge.knots.back() = edge.knots.front();
  for (std::size_t i = 1; i < rest.arc.size(); ++i) edge.arc.push_back(ring.length() - s + rest.arc[i]);
  return edge;
}

Foot foot_on(const Edge& edge, const Vec2& p) {
  Foot best{0.0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i + 1 < edge.knots.size(); ++i) {
    const Vec2 chord = edge.knots[i + 1] - edge.knots[i];
    const double u = mesh::nearest_parameter(edge.knots[i], edge.knots[i + 1], p);
    const double distance = (edge.knots[i] + u * chord - p).norm();
    if (distance < best.distance) best = {edge.arc[i] + u * (edge.arc[i + 1] - edge.arc[i]), distance};
  }
  if (edge.straight || edge.type == EdgeType::line) return best;
  for (int newton = 0; newton < 2; ++newton)  // from the chord onto the curve
    best.s = std::clamp(best.s + (p - at(edge, best.s)).dot(tangent_at(edge, best.s)), 0.0, edge.length());
  best.distance = (p - at(edge, best.s)).norm();
  return best;
}

std::array<double, 4> bounding_box(const Edge& edge) {
  std::array<double, 4> box{edge.first().x(), edge.first().y(), edge.first().x(), edge.first().y()};
  for (const Vec2& p : edge.knots)
    box = {std::min(box[0], p.x()), std::min(box[1], p.y()), std::max(box[2], p.x()), std::max(box[3], p.y())};
  return box;
}

double swept_area(const Edge& edge) {
  double twice = 0.0;
  for (std::size_t i = 0; i + 1 < edge.knots.size(); ++i) {
    const Vec2 &a = edge.knots[i], &b = edge.knots[i + 1];
    twice += base::cross(a, b);
    if (edge.straight) continue;
    // The cubic as Bezier b0 b1 b2 b3; its area beyond that of the chord b0 x b3.
    const Vec2 b1 = a + (edge.arc[i + 1] - edge.arc[i]) / 3.0 * edge.tangents[i];
    const Vec2 b2 = b - (edge.arc[i + 1] - edge.arc[i]) / 3.0 * edge.tangents[i + 1];
    twice += 0.3 * (2.0 * base::cross(a, b1) + base::cross(a, b2) + base::cross(b1, b2) + base::cross(b1, b) +
                    2.0 * base::cross(b2, b) - 3.0 * base::cross(a, b));
  }
  return 0.5 * twice;
}

double turning(const Edge& edge) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < edge.tangents.size(); ++i)
    sum += std::abs(angle_between(edge.tangents[i], edge.tangents[i + 1]));
  return sum;
}

double kink(const Edge& from, const Edge& to) {
  return std::abs(angle_between(from.tangents.back(), to.tangents.front()));
}

}  // namespace reye::cad
