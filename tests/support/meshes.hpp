#pragma once
#include <algorithm>
#include <cmath>

#include "mesh/mesh.hpp"
#include "mesh/second_order.hpp"

/// Small meshes written by hand, for tests of all rooms.
namespace reye::support {

using base::Vec2;
using mesh::Cell;
using mesh::CellKind;
using mesh::Chain;
using mesh::Mesh;

/// A rectangle cut into nx times ny quadrilaterals (or twice as many triangles).
/// `distortion` in [0, 1) moves inner nodes, as a share of a third of the cell size; repeatable. In second order edges
/// are straight, with mid nodes between the moved vertices.
struct RectangleOptions {
  Vec2 corner{0.0, 0.0};  ///< lower left [mm]
  Vec2 size{1.0, 1.0};
  int nx = 4;
  int ny = 4;
  CellKind kind = CellKind::quad4;
  double distortion = 0.0;
};

namespace detail {

inline void add_cells(Mesh& m, int i, int j, int nx) {
  const int a = j * (nx + 1) + i, b = a + 1, d = a + nx + 1, c = d + 1;
  if (m.kind == CellKind::quad4) {
    m.cells.push_back(mesh::cell_of({a, b, c, d}));
  } else if ((i + j) % 2 == 0) {
    m.cells.push_back(mesh::cell_of({a, b, c}));
    m.cells.push_back(mesh::cell_of({a, c, d}));
  } else {
    m.cells.push_back(mesh::cell_of({a, b, d}));
    m.cells.push_back(mesh::cell_of({b, c, d}));
  }
}

}  // namespace detail

/// Boundaries `bottom`, `right`, `top`, `left`, each one chain with the body on its left (so `top` runs
/// towards smaller x and `left` towards smaller y). Node of row j and column i: j * (nx + 1) + i.
inline Mesh rectangle(const RectangleOptions& o) {
  Mesh m;
  m.kind = mesh::corners(o.kind) == 3 ? CellKind::tri3 : CellKind::quad4;
  const Vec2 h{o.size.x() / o.nx, o.size.y() / o.ny};
  for (int j = 0; j <= o.ny; ++j)
    for (int i = 0; i <= o.nx; ++i) {
      Vec2 x{o.corner.x() + h.x() * i, o.corner.y() + h.y() * j};
      if (i > 0 && j > 0 && i < o.nx && j < o.ny) {
        const double k = 12.9898 * i + 78.233 * j;  // any repeatable scatter does
        x += o.distortion / 3.0 * Vec2{h.x() * std::sin(37.0 * k), h.y() * std::cos(53.0 * k)};
      }
      m.X.push_back(x);
    }
  for (int j = 0; j < o.ny; ++j)
    for (int i = 0; i < o.nx; ++i) detail::add_cells(m, i, j, o.nx);
  const auto node = [&](int i, int j) { return j * (o.nx + 1) + i; };
  Chain bottom, right, top, left;
  for (int i = 0; i <= o.nx; ++i) bottom.push_back(node(i, 0));
  for (int j = 0; j <= o.ny; ++j) right.push_back(node(o.nx, j));
  for (int i = o.nx; i >= 0; --i) top.push_back(node(i, o.ny));
  for (int j = o.ny; j >= 0; --j) left.push_back(node(0, j));
  Chain loop;
  for (const Chain* side : {&bottom, &right, &top, &left}) loop.insert(loop.end(), side->begin(), side->end() - 1);
  loop.push_back(loop.front());
  m.boundaries = {{"bottom", {bottom}}, {"right", {right}}, {"top", {top}}, {"left", {left}}};
  m.outline = {loop};
  return mesh::order(o.kind) == 2 ? mesh::to_second_order(m) : m;
}

/// The mesh with every node moved by `map` (which must keep cells counter-clockwise).
template <class Map>
Mesh mapped(Mesh m, Map map) {
  for (Vec2& x : m.X) x = map(x);
  return m;
}

/// The mesh turned about the origin, angle in radians.
inline Mesh turned(const Mesh& m, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return mapped(m, [&](const Vec2& x) { return Vec2{c * x.x() - s * x.y(), s * x.x() + c * x.y()}; });
}

/// A sector of a ring, 0 <= angle <= `angle` [rad], radii a < b: `left` and `right` become the inner and the
/// outer arc, `bottom` the straight edge on the x axis, `top` the one at `angle`.
struct RingOptions {
  double inner = 1.0;
  double outer = 2.0;
  double angle = 1.5707963267948966;
  int across = 4;
  int around = 8;
  CellKind kind = CellKind::quad4;
};

inline Mesh ring(const RingOptions& o) {
  const RectangleOptions box{{o.inner, 0.0}, {o.outer - o.inner, o.angle}, o.across, o.around, o.kind, 0.0};
  return mapped(rectangle(box), [](const Vec2& p) { return Vec2{p.x() * std::cos(p.y()), p.x() * std::sin(p.y())}; });
}

/// The node nearest to a point.
inline int node_at(const Mesh& m, const Vec2& x) {
  const auto nearer = [&](const Vec2& a, const Vec2& b) { return (a - x).squaredNorm() < (b - x).squaredNorm(); };
  return static_cast<int>(std::min_element(m.X.begin(), m.X.end(), nearer) - m.X.begin());
}

}  // namespace reye::support
