#include "output/solid/skin_map.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "algebra/decompose.hpp"
#include "output/solid/solid_words.hpp"

namespace reye::output {

using base::Vec2;
using base::Vec3;

namespace {

/// The mean normal of the rows in contact, by area; of all where that is none.
Vec3 mean_normal(const DrawnSkin& skin) {
  const double most =
      skin.pressure_MPa.empty() ? 0.0 : *std::max_element(skin.pressure_MPa.begin(), skin.pressure_MPa.end());
  for (const bool pressed_alone : {true, false}) {
    Vec3 sum = Vec3::Zero();
    double area = 0.0;
    for (std::size_t i = 0; i < skin.X.size(); ++i) {
      if (pressed_alone && !(skin.pressure_MPa[i] > 1e-6 * most)) continue;
      const double share = std::max(skin.area_mm2[i], 1e-300);
      sum += share * skin.normal[i];
      area += share;
    }
    if (sum.norm() > 0.05 * area) return sum.normalized();
  }
  return Vec3::UnitZ();
}

/// Axes of the map: z upwards where the normal is not along it, and both ascending as those of space do.
void choose_axes(const Vec3& normal, SkinMap& map) {
  map.normal = normal;
  const Vec3 above = std::abs(normal.z()) > 0.9 ? Vec3::UnitY() : Vec3::UnitZ();
  map.up = (above - above.dot(normal) * normal).normalized();
  map.across = map.up.cross(normal).normalized();
  Eigen::Index largest = 0;
  map.across.cwiseAbs().maxCoeff(&largest);
  if (map.across[largest] < 0.0) map.across = -map.across;
}

/// Adds a triangle that faces along the normal, counter-clockwise in the map.
void add_triangle(SkinMap& map, const DrawnSkin& skin, std::array<int, 3> t, const std::array<Vec3, 3>& X) {
  const Vec3 area = (X[1] - X[0]).cross(X[2] - X[0]);
  if (!(area.dot(map.normal) > 0.03 * area.norm()) || skin.X.empty()) return;
  const auto at = [&](int k) { return map.x[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])]; };
  const Vec2 a = at(1) - at(0), b = at(2) - at(0);
  if (a.x() * b.y() - a.y() * b.x() < 0.0) std::swap(t[1], t[2]);
  map.triangles.push_back(t);
}

void add_facet(SkinMap& map, const DrawnSkin& skin, const std::vector<int>& facet) {
  const auto X = [&](int row) { return skin.X[static_cast<std::size_t>(row)]; };
  if (facet.size() == 3)
    return add_triangle(map, skin, {facet[0], facet[1], facet[2]}, {X(facet[0]), X(facet[1]), X(facet[2])});
  const Vec3 middle = 0.25 * (X(facet[0]) + X(facet[1]) + X(facet[2]) + X(facet[3]));
  const int point = static_cast<int>(map.x.size());
  map.x.push_back(map.flat(middle));
  map.middles.push_back({facet[0], facet[1], facet[2], facet[3]});
  for (std::size_t k = 0; k < 4; ++k)
    add_triangle(map, skin, {facet[k], facet[(k + 1) % 4], point}, {X(facet[k]), X(facet[(k + 1) % 4]), middle});
}

/// Whether the box of a triangle meets what is shown.
bool is_seen(const SkinMap& map, const std::array<int, 3>& t) {
  Vec2 low = map.x[static_cast<std::size_t>(t[0])], high = low;
  for (const int point : t) {
    low = low.cwiseMin(map.x[static_cast<std::size_t>(point)]);
    high = high.cwiseMax(map.x[static_cast<std::size_t>(point)]);
  }
  return high.x() >= map.x_seen.low && low.x() <= map.x_seen.high && high.y() >= map.y_seen.low &&
         low.y() <= map.y_seen.high;
}

/// What is shown: the rows in contact with a margin, not narrower than a figure may be.
void choose_part(SkinMap& map) {
  constexpr double margin = 1.35, least_share = 0.5, most_share = 1.0;  // of height over width
  Vec2 low(INFINITY, INFINITY), high(-INFINITY, -INFINITY);
  for (const bool active_alone : {true, false}) {
    for (std::size_t i = 0; i < map.active.size(); ++i) {
      if (active_alone && !map.active[i]) continue;
      low = low.cwiseMin(map.x[i]);
      high = high.cwiseMax(map.x[i]);
    }
    if ((high - low).maxCoeff() > 0.0) break;
  }
  if (!(low.allFinite() && high.allFinite())) low = high = Vec2(0.0, 0.0);
  Vec2 half = 0.5 * margin * (high - low).cwiseMax(2.0 * map.spacing_mm).cwiseMax(1e-9);
  half.y() = std::max(half.y(), least_share * half.x());
  half.x() = std::max(half.x(), half.y() / most_share);
  const Vec2 middle = 0.5 * (low + high);
  map.x_seen = {middle.x() - half.x(), middle.x() + half.x()};
  map.y_seen = {middle.y() - half.y(), middle.y() + half.y()};
}

}  // namespace

std::vector<double> SkinMap::at_points(std::vector<double> rows) const {
  rows.reserve(x.size());
  for (const auto& of : middles) {
    double sum = 0.0;
    for (const int row : of) sum += 0.25 * rows[static_cast<std::size_t>(row)];
    rows.push_back(sum);
  }
  return rows;
}

SkinMap skin_map(const DrawnSkin& skin) {
  std::vector<char> touches;
  for (const int status : skin.status) touches.push_back(status != 0);
  return skin_map(skin, std::move(touches));
}

SkinMap skin_map(const DrawnSkin& skin, std::vector<char> active) {
  SkinMap map;
  map.active = std::move(active);
  choose_axes(mean_normal(skin), map);
  for (const Vec3& X : skin.X) map.x.push_back(map.flat(X));
  double area = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < skin.X.size(); ++i) {
    if (!map.active[i]) continue;
    area += skin.area_mm2[i];
    ++count;
  }
  if (count > 0) map.spacing_mm = std::sqrt(std::max(0.0, area) / count);
  for (const auto& facet : skin.facets) add_facet(map, skin, facet);
  choose_part(map);
  std::erase_if(map.triangles, [&](const auto& t) { return !is_seen(map, t); });
  return map;
}

std::array<MapLine, 2> principal_lines(const SkinMap& map, const DrawnSkin& skin) {
  std::array<MapLine, 2> lines{MapLine{{0.0, 0.0}, {1.0, 0.0}}, MapLine{{0.0, 0.0}, {0.0, 1.0}}};
  Vec2 first = Vec2::Zero();
  double force = 0.0, most = 0.0;
  Vec2 peak(0.5 * (map.x_seen.low + map.x_seen.high), 0.5 * (map.y_seen.low + map.y_seen.high));
  for (std::size_t i = 0; i < skin.X.size(); ++i) {
    const double f = skin.pressure_MPa[i] * skin.area_mm2[i];
    force += f;
    first += f * map.x[i];
    if (skin.pressure_MPa[i] > most) {
      most = skin.pressure_MPa[i];
      peak = map.x[i];
    }
  }
  for (auto& line : lines) line.through = peak;
  if (!(force > 0.0)) return lines;
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < skin.X.size(); ++i) {
    const Vec2 d = map.x[i] - first / force;
    second += skin.pressure_MPa[i] * skin.area_mm2[i] / force * d * d.transpose();
  }
  const auto axes = algebra::eigenpairs(second);
  constexpr double round = 1.15;  // square of the ratio of widths below which no direction is better than another
  if (!(axes.values[1] > round * std::max(axes.values[0], 0.0))) return lines;
  for (int k = 0; k < 2; ++k) {
    Vec2 along = axes.vectors.col(1 - k);
    if (along.cwiseAbs().maxCoeff() > 0.9995) along = along.array().round();  // along an axis but for noise
    lines[static_cast<std::size_t>(k)].along = along.sum() < 0.0 ? Vec2(-along) : along;
  }
  return lines;
}

LineSamples sampled(const SkinMap& map, const std::vector<double>& values, const MapLine& line) {
  constexpr int count = 321;
  const Vec2 centre(0.5 * (map.x_seen.low + map.x_seen.high), 0.5 * (map.y_seen.low + map.y_seen.high));
  const double reach = 0.5 * std::hypot(map.x_seen.width(), map.y_seen.width()),
               middle = (centre - line.through).dot(line.along);
  LineSamples samples;
  for (int i = 0; i < count; ++i) samples.position.push_back(middle + reach * (2.0 * i / (count - 1) - 1.0));
  samples.value.assign(count, NAN);
  const Vec2 across(-line.along.y(), line.along.x());
  for (const auto& t : map.triangles) {
    std::array<Vec2, 3> p;  // along and across the line
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 d = map.x[static_cast<std::size_t>(t[k])] - line.through;
      p[k] = {d.dot(line.along), d.dot(across)};
    }
    if (std::min({p[0].y(), p[1].y(), p[2].y()}) > 0.0 || std::max({p[0].y(), p[1].y(), p[2].y()}) < 0.0) continue;
    const double area = (p[1] - p[0]).x() * (p[2] - p[0]).y() - (p[1] - p[0]).y() * (p[2] - p[0]).x();
    const auto [low, high] = std::minmax({p[0].x(), p[1].x(), p[2].x()});
    for (auto i = static_cast<std::size_t>(
             std::max(0.0, std::floor((low - samples.position.front()) / (2.0 * reach) * (count - 1))));
         i < samples.position.size() && samples.position[i] <= high; ++i) {
      const Vec2 at(samples.position[i], 0.0);
      const double u = ((p[1] - at).x() * (p[2] - at).y() - (p[1] - at).y() * (p[2] - at).x()) / area,
                   v = ((p[2] - at).x() * (p[0] - at).y() - (p[2] - at).y() * (p[0] - at).x()) / area;
      if (u < -1e-9 || v < -1e-9 || u + v > 1.0 + 1e-9) continue;
      samples.value[i] = u * values[static_cast<std::size_t>(t[0])] + v * values[static_cast<std::size_t>(t[1])] +
                         (1.0 - u - v) * values[static_cast<std::size_t>(t[2])];
    }
  }
  return samples;
}

std::string axis_label(const base::Vec3& direction) {
  constexpr double near = 0.999;  // within 2.5 degrees: the normal of a scar is nearly that of its face
  Eigen::Index k = 0;
  const bool along_axis = direction.cwiseAbs().maxCoeff(&k) > near * direction.norm();
  const std::string words =
      direction_in_words(along_axis ? Vec3(std::copysign(1.0, direction[k]) * Vec3::Unit(k)) : direction);
  return words.size() <= 2 ? words : "along " + words;
}

}  // namespace reye::output
