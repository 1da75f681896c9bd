#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <numbers>
#include <random>

#include "mortar/solid/skin.hpp"

/// Skins for tests: grids of facets over a rectangle of a plane.
namespace reye::test {

using base::Vec2;
using base::Vec3;
using mortar::Skin;

struct SkinGrid {
  mesh::FacetKind kind = mesh::FacetKind::tri3;
  int nx = 4, ny = 4;
  Vec2 lo{0, 0}, hi{1, 1};
  double height = 0.0;
  bool up = true;       ///< the facets look along z, else against it
  double shaken = 0.0;  ///< inner points are moved at random by this part of a facet
  double bent = 0.0;    ///< inner control points of edges, by this part
  unsigned seed = 1;
};

/// A point index per place of the grid of corners, or of corners and middles of edges.
class SkinGridPoints {
 public:
  SkinGridPoints(const SkinGrid& grid, Skin& skin) : grid_(grid), skin_(skin) {
    steps_ = grid.kind == mesh::FacetKind::tri6 ? 2 : 1;
    const int count = (steps_ * grid.nx + 1) * (steps_ * grid.ny + 1);
    for (int k = 0; k < count; ++k) {
      const int i = k % (steps_ * grid.nx + 1), j = k / (steps_ * grid.nx + 1);
      skin_.x.push_back({grid.lo.x() + (grid.hi - grid.lo).x() * i / (steps_ * grid.nx),
                         grid.lo.y() + (grid.hi - grid.lo).y() * j / (steps_ * grid.ny), grid.height});
    }
  }
  int at(int i, int j) const { return j * (steps_ * grid_.nx + 1) + i; }
  int steps() const { return steps_; }
  bool inner(int i, int j) const { return i > 0 && j > 0 && i < steps_ * grid_.nx && j < steps_ * grid_.ny; }

 private:
  const SkinGrid& grid_;
  Skin& skin_;
  int steps_ = 1;
};

inline void shake(const SkinGrid& grid, const SkinGridPoints& points, Skin& skin) {
  std::mt19937 random(grid.seed);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const int s = points.steps();
  const Vec2 facet{(grid.hi - grid.lo).x() / grid.nx, (grid.hi - grid.lo).y() / grid.ny};
  const auto move = [&](int i, int j, double part) {
    if (!points.inner(i, j)) return;
    skin.x[points.at(i, j)].x() += part * number(random) * facet.x();
    skin.x[points.at(i, j)].y() += part * number(random) * facet.y();
  };
  for (int j = 0; j <= s * grid.ny; j += s)
    for (int i = 0; i <= s * grid.nx; i += s) move(i, j, grid.shaken);
  if (s == 1) return;
  for (int j = 0; j <= s * grid.ny; ++j)
    for (int i = 0; i <= s * grid.nx; ++i) {
      if (i % 2 == 0 && j % 2 == 0) continue;
      const int di = i % 2, dj = j % 2;  // the middle of two corners: along x, y or the diagonal
      skin.x[points.at(i, j)] = 0.5 * (skin.x[points.at(i - di, j - dj)] + skin.x[points.at(i + di, j + dj)]);
      move(i, j, grid.bent);
    }
}

/// The facets of one cell of the grid.
inline void add_cell(const SkinGrid& grid, const SkinGridPoints& p, int i, int j, Skin& skin) {
  const int s = p.steps(), x = s * i, y = s * j;
  const auto add = [&](std::vector<int> nodes) {
    mesh::Facet facet;
    facet.kind = grid.kind;
    const std::size_t corners = grid.kind == mesh::FacetKind::quad4 ? 4 : 3;
    if (!grid.up) {
      std::reverse(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(corners));
      if (nodes.size() == 6) std::swap(nodes[3], nodes[4]);  // edges 21, 10, 02 of the corners before
    }
    std::copy(nodes.begin(), nodes.end(), facet.nodes.begin());
    skin.facets.push_back(facet);
  };
  if (grid.kind == mesh::FacetKind::quad4) return add({p.at(x, y), p.at(x + 1, y), p.at(x + 1, y + 1), p.at(x, y + 1)});
  const int a = p.at(x, y), b = p.at(x + s, y), c = p.at(x + s, y + s), d = p.at(x, y + s);
  if (s == 1) {
    add({a, b, c});
    return add({a, c, d});
  }
  const int m = p.at(x + 1, y + 1);
  add({a, b, c, p.at(x + 1, y), p.at(x + 2, y + 1), m});
  add({a, c, d, m, p.at(x + 1, y + 2), p.at(x, y + 1)});
}

inline Skin skin_grid(const SkinGrid& grid) {
  Skin skin;
  const SkinGridPoints points(grid, skin);
  if (grid.shaken > 0.0) shake(grid, points, skin);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) add_cell(grid, points, i, j, skin);
  return skin;
}

/// The points of a skin through a map. Of tri6 the map must be affine, or control points are no longer those of the
/// mapped surface.
inline Skin mapped(Skin skin, const std::function<Vec3(const Vec3&)>& map) {
  for (auto& x : skin.x) x = map(x);
  return skin;
}

/// The flat points of a skin on a curved surface: corners, and middles of straight edges, of which control points are
/// those that let the edge pass through.
inline Skin curved(const Skin& flat, const std::function<Vec3(const Vec3&)>& map) {
  Skin skin = mapped(flat, map);
  for (const auto& facet : skin.facets)
    for (int e = 0; facet.kind == mesh::FacetKind::tri6 && e < 3; ++e) {
      const int m = facet.nodes[3 + e];
      skin.x[m] = 2.0 * map(flat.x[m]) - 0.5 * (skin.x[facet.nodes[e]] + skin.x[facet.nodes[(e + 1) % 3]]);
    }
  return skin;
}

/// The map onto a sphere round the origin of points of the plane z = 0: along meridians through (0, 0, -radius).
inline std::function<Vec3(const Vec3&)> onto_sphere(double radius) {
  return [radius](const Vec3& x) { return Vec3(radius * Vec3(x.x(), x.y(), -radius).normalized()); };
}

/// Turned by an angle about a skew axis, and moved.
inline Skin turned(const Skin& skin, double degrees) {
  const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180.0, Vec3(1.0, -2.0, 0.7).normalized());
  return mapped(skin, [&](const Vec3& x) { return Vec3(turn * x + Vec3(3.0, -1.0, 2.0)); });
}

/// Two skins as one.
inline Skin joined_skins(Skin a, const Skin& b) {
  const int before = static_cast<int>(a.x.size());
  a.x.insert(a.x.end(), b.x.begin(), b.x.end());
  for (auto facet : b.facets) {
    for (int j = 0; j < facet.count(); ++j) facet.nodes[j] += before;
    a.facets.push_back(facet);
  }
  return a;
}

/// One coordinate of all points.
inline base::Vector coordinate(const Skin& skin, int c) {
  base::Vector values(static_cast<Eigen::Index>(skin.x.size()));
  for (std::size_t i = 0; i < skin.x.size(); ++i) values[static_cast<Eigen::Index>(i)] = skin.x[i][c];
  return values;
}

/// Largest component of |M x_p - D x_s|: zero where the two sides lie on each other.
inline double offset_error(const mortar::SkinIntegrals& I, const Skin& secondary, const Skin& primary) {
  double error = 0.0;
  for (int c = 0; c < 3; ++c)
    error = std::max(error, (I.M * coordinate(primary, c) - I.D * coordinate(secondary, c)).cwiseAbs().maxCoeff());
  return error;
}

}  // namespace reye::test
