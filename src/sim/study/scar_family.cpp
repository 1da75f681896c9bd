#include "sim/study/scar_family.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace reye::sim {

namespace {

using scene::ScarAxis;

const std::vector<double>& coordinates(const SurfaceRecord& surface, ScarAxis axis) {
  return axis == ScarAxis::arc ? surface.arc_length_mm : axis == ScarAxis::x ? surface.x_mm : surface.y_mm;
}

/// A piecewise linear function; zero beyond its ends.
struct Polyline {
  std::vector<double> x, y;

  double operator()(const Vec2& place) const {
    const auto above = std::upper_bound(x.begin(), x.end(), place.x());
    if (above == x.begin() || above == x.end()) return 0.0;
    const auto i = static_cast<std::size_t>(above - x.begin());
    const double t = (place.x() - x[i - 1]) / (x[i] - x[i - 1]);
    return (1.0 - t) * y[i - 1] + t * y[i];
  }
};

/// Values at the points of a regular grid, linear in each direction between them; zero beyond it.
struct Raster {
  Vec2 low;
  double spacing = 1.0;
  int nx = 0, ny = 0;
  std::vector<double> value;

  double& at(int i, int j) { return value[static_cast<std::size_t>(j) * nx + i]; }
  double at(int i, int j) const { return value[static_cast<std::size_t>(j) * nx + i]; }

  double operator()(const Vec2& place) const {
    const Vec2 cell = (place - low) / spacing;
    const int i = static_cast<int>(std::floor(cell.x())), j = static_cast<int>(std::floor(cell.y()));
    if (!(cell.x() >= 0.0 && cell.y() >= 0.0 && cell.x() < nx - 1 && cell.y() < ny - 1)) return 0.0;
    const double s = cell.x() - i, t = cell.y() - j;
    return (1 - s) * (1 - t) * at(i, j) + s * (1 - t) * at(i + 1, j) + (1 - s) * t * at(i, j + 1) +
           s * t * at(i + 1, j + 1);
  }

  /// The plane through three corners at the points of the grid inside of them; where facets lie above each other the
  /// largest.
  void add(const std::array<Vec2, 3>& p, const std::array<double, 3>& depth) {
    const double area = base::cross(p[1] - p[0], p[2] - p[0]);
    if (area == 0.0) return;
    const Vec2 least = p[0].cwiseMin(p[1]).cwiseMin(p[2]), most = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
    const auto first = [&](double from, double origin) {
      return std::max(0, static_cast<int>(std::ceil((from - origin) / spacing)));
    };
    for (int j = first(least.y(), low.y()); j < ny && low.y() + j * spacing <= most.y(); ++j)
      for (int i = first(least.x(), low.x()); i < nx && low.x() + i * spacing <= most.x(); ++i) {
        const Vec2 q(low.x() + i * spacing, low.y() + j * spacing);
        const double b = base::cross(q - p[0], p[2] - p[0]) / area, c = base::cross(p[1] - p[0], q - p[0]) / area;
        constexpr double rim = -1e-9;  // points on an edge belong to both facets
        if (b < rim || c < rim || b + c > 1.0 - rim) continue;
        at(i, j) = std::max(at(i, j), (1.0 - b - c) * depth[0] + b * depth[1] + c * depth[2]);
      }
  }
};

Vec2 seen(const Vec3& x, const std::vector<ScarAxis>& axes) {
  const auto component = [&](ScarAxis axis) { return x[axis == ScarAxis::x ? 0 : axis == ScarAxis::y ? 1 : 2]; };
  return {component(axes[0]), component(axes[1])};
}

/// The linear parts of a facet, as rows of its nodes.
std::vector<std::array<int, 3>> parts_of(const mesh::Facet& facet) {
  if (facet.kind == mesh::FacetKind::tri3) return {{0, 1, 2}};
  if (facet.kind == mesh::FacetKind::quad4) return {{0, 1, 2}, {0, 2, 3}};
  return {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
}

/// An empty raster about the worn rows; eight points to a row each way, as far as that is affordable.
Raster raster_about(const SkinRecord& skin, const std::vector<ScarAxis>& axes) {
  constexpr double most_points = 600.0;
  Vec2 low(INFINITY, INFINITY), high(-INFINITY, -INFINITY);
  double area = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < skin.x_mm.size(); ++i) {
    if (!(skin.wear_depth_mm[i] > 0.0)) continue;
    const Vec2 p = seen(skin.x_mm[i], axes);
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    area += skin.area_mm2[i];
    ++count;
  }
  Raster raster;
  if (count == 0 || !(area > 0.0)) return raster;
  const double row = std::sqrt(area / count), extent = (high - low).maxCoeff() + 4.0 * row;
  raster.spacing = std::max(0.125 * row, extent / most_points);
  raster.low = low.array() - 2.0 * row;
  raster.nx = 2 + static_cast<int>((high.x() - low.x() + 4.0 * row) / raster.spacing);
  raster.ny = 2 + static_cast<int>((high.y() - low.y() + 4.0 * row) / raster.spacing);
  raster.value.assign(static_cast<std::size_t>(raster.nx) * raster.ny, 0.0);
  return raster;
}

/// Sums of volume, of its first moments and of its second.
struct Moments {
  double volume = 0.0, second = 0.0;
  Vec2 first{0.0, 0.0};

  void add(double part, const Vec2& place) {
    volume += part;
    first += part * place;
    second += part * place.squaredNorm();
  }
  void place(ScarShape& shape) const {
    if (!(volume > 0.0)) return;
    shape.volume = volume;
    shape.middle = first / volume;
    shape.width = std::sqrt(std::max(0.0, second / volume - shape.middle.squaredNorm()));
  }
};

}  // namespace

ScarShape profile_of(const SurfaceRecord& surface, ScarAxis axis) {
  const auto& x = coordinates(surface, axis);
  const auto& depth = surface.wear_depth_mm;
  if (depth.empty()) return number_of(0.0);
  const auto deepest = static_cast<std::size_t>(std::max_element(depth.begin(), depth.end()) - depth.begin());
  std::size_t first = deepest, last = deepest;
  const double sense = deepest + 1 < x.size() ? x[deepest + 1] - x[deepest] : x[deepest] - x[deepest - 1];
  while (last + 1 < x.size() && (x[last + 1] - x[last]) * sense > 0.0) ++last;
  while (first > 0 && (x[first] - x[first - 1]) * sense > 0.0) --first;
  Polyline line;
  for (std::size_t i = first; i <= last; ++i) {
    line.x.push_back(x[i]);
    line.y.push_back(depth[i]);
  }
  if (sense < 0.0) {
    std::reverse(line.x.begin(), line.x.end());
    std::reverse(line.y.begin(), line.y.end());
  }
  Moments moments;
  for (std::size_t i = 1; i < line.x.size(); ++i)
    moments.add(0.5 * (line.y[i] + line.y[i - 1]) * (line.x[i] - line.x[i - 1]),
                {0.5 * (line.x[i] + line.x[i - 1]), 0.0});
  ScarShape shape{.depth = std::move(line), .directions = 1};
  moments.place(shape);
  return shape;
}

ScarShape number_of(double value, bool worn) {
  return {.depth = [value](const Vec2&) { return value; }, .worn = worn};
}

ScarShape map_of(const SkinRecord& skin, const std::vector<ScarAxis>& axes) {
  Raster raster = raster_about(skin, axes);
  for (const auto& facet : skin.facets)
    for (const auto& part : parts_of(facet)) {
      std::array<Vec2, 3> p;
      std::array<double, 3> depth{};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto row = static_cast<std::size_t>(facet.nodes[static_cast<std::size_t>(part[k])]);
        p[k] = seen(skin.x_mm[row], axes);
        depth[k] = skin.wear_depth_mm[row];
      }
      if (std::max({depth[0], depth[1], depth[2]}) > 0.0) raster.add(p, depth);
    }
  Moments moments;
  for (int j = 0; j < raster.ny; ++j)
    for (int i = 0; i < raster.nx; ++i)
      moments.add(raster.spacing * raster.spacing * raster.at(i, j), raster.low + raster.spacing * Vec2(i, j));
  ScarShape shape{.depth = std::move(raster), .directions = 2};
  moments.place(shape);
  return shape;
}

void ScarFamily::add(double cycles, ScarShape shape) {
  cycles_.push_back(cycles);
  shapes_.push_back(std::move(shape));
  const auto half = std::lower_bound(cycles_.begin(), cycles_.end(), 0.5 * cycles) - cycles_.begin();
  const auto& then = shapes_[static_cast<std::size_t>(half)];
  const auto& now = shapes_.back();
  const auto size = [](const ScarShape& s) { return s.directions > 0 ? s.width : s.depth(Vec2::Zero()); };
  const double growth = cycles / cycles_[static_cast<std::size_t>(half)];
  if (growth > 1.0 && size(then) > 0.0 && size(now) > 0.0)
    power_ = std::clamp(std::log(size(now) / size(then)) / std::log(growth), 0.0, 1.0);
}

DepthField ScarFamily::beyond(double growth) const {
  const ScarShape& last = shapes_.back();
  if (!last.worn) return last.depth;
  const double wider = std::pow(growth, power_);
  if (last.directions == 0) return [&last, wider](const Vec2& place) { return wider * last.depth(place); };
  const double deeper = growth / std::pow(wider, last.directions);
  return [&last, wider, deeper](const Vec2& place) {
    return deeper * last.depth(last.middle + (place - last.middle) / wider);
  };
}

DepthField ScarFamily::between(std::size_t next, double cycles) const {
  const ScarShape &a = shapes_[next - 1], &b = shapes_[next];
  const double from = cycles_[next - 1], to = cycles_[next], s = (cycles - from) / (to - from);
  const double power = std::log(cycles / from) / std::log(to / from);
  const auto grown = [power](double x, double y) { return x * std::pow(y / x, power); };
  if (a.directions == 0 && a.worn) {
    const double x = a.depth(Vec2::Zero()), y = b.depth(Vec2::Zero());
    if (x > 0.0 && y > 0.0) return [number = grown(x, y)](const Vec2&) { return number; };
  }
  if (!(a.width > 0.0 && b.width > 0.0))
    return [&a, &b, s](const Vec2& place) { return (1.0 - s) * a.depth(place) + s * b.depth(place); };
  const double volume = (1.0 - s) * a.volume + s * b.volume, width = grown(a.width, b.width);
  const Vec2 middle = (1.0 - s) * a.middle + s * b.middle;
  const auto depths = [&](const ScarShape& shape) {
    return volume / shape.volume * std::pow(shape.width / width, shape.directions);
  };
  return [&a, &b, x = (1.0 - s) * depths(a), y = s * depths(b), width, middle](const Vec2& place) {
    const Vec2 xi = (place - middle) / width;
    return x * a.depth(a.middle + a.width * xi) + y * b.depth(b.middle + b.width * xi);
  };
}

DepthField ScarFamily::after(double cycles) const {
  const auto next =
      static_cast<std::size_t>(std::upper_bound(cycles_.begin(), cycles_.end(), cycles) - cycles_.begin());
  if (next == cycles_.size()) return beyond(cycles / cycles_.back());
  if (next > 0) return between(next, cycles);
  const ScarShape& first = shapes_.front();
  if (!first.worn) return first.depth;
  return [&first, part = cycles / cycles_.front()](const Vec2& place) { return part * first.depth(place); };
}

Vector ScarFamily::at(double cycles, std::span<const Vec2> places) const {
  Vector result = Vector::Zero(static_cast<Eigen::Index>(places.size()));
  if (cycles_.empty()) return result;
  const DepthField depth = after(cycles);
  for (std::size_t i = 0; i < places.size(); ++i) result[static_cast<Eigen::Index>(i)] = depth(places[i]);
  return result;
}

}  // namespace reye::sim
