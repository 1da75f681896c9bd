#pragma once
#include <numbers>

#include "adapt/redraw/remesh.hpp"
#include "adapt/worn.hpp"

/// Shapes with a drawing, for tests of redrawing and remeshing.
namespace reye::support {

inline cad::Edge line(Vec2 a, Vec2 b) { return cad::make_edge(cad::EdgeType::line, {a, b}, {b - a, b - a}); }

inline cad::Edge arc(Vec2 centre, double radius, double from, double to) {
  base::Points knots, tangents;
  for (int i = 0; i <= 1000; ++i) {
    const double angle = from + (to - from) * i / 1000.0;
    knots.emplace_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
    tangents.push_back(std::copysign(1.0, to - from) * Vec2(-std::sin(angle), std::cos(angle)));
  }
  return cad::make_edge(cad::EdgeType::circle, knots, tangents);
}

struct DrawnOptions {
  CellKind kind = CellKind::quad4;
  double far_size = 0.1;
  bool axisymmetric = false;
};

/// One loop of edges with a name each ("" for none).
inline cad::Drawing drawing(cad::Loop loop, const std::vector<std::string>& names, const DrawnOptions& o) {
  cad::Drawing d;
  for (std::size_t k = 0; k < loop.size(); ++k)
    if (loop[k].knots.back() != loop[(k + 1) % loop.size()].knots.front())
      loop[k].knots.back() = loop[(k + 1) % loop.size()].knots.front();
  d.part.loops = {std::move(loop)};
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (names[k].empty()) continue;
    auto& choice = d.boundaries[names[k]];
    if (choice.empty()) choice.assign(1, std::vector<bool>(names.size(), false));
    choice[0][k] = true;
  }
  d.options.name = "block";
  d.options.mesh.element = o.kind;
  d.options.mesh.far_size_mm = o.far_size;
  d.axisymmetric = o.axisymmetric;
  return d;
}

/// A block [x0, x0 + 2] x [0, 1] with boundaries bottom, right, top, left.
inline cad::Drawing block_drawing(const DrawnOptions& o = {}, double x0 = 0.0) {
  const Vec2 a(x0, 0), b(x0 + 2, 0), c(x0 + 2, 1), d(x0, 1);
  return drawing({line(a, b), line(b, c), line(c, d), line(d, a)}, {"bottom", "right", "top", "left"}, o);
}

/// The upper half of a disc of radius 1 about the origin: `flat` on y = 0, and `round`.
inline cad::Drawing half_disc(const DrawnOptions& o = {}) {
  return drawing({line({-1, 0}, {1, 0}), arc({0, 0}, 1.0, 0.0, std::numbers::pi)}, {"flat", "round"}, o);
}

inline body::ShapePtr shape_of(const cad::Drawing& d) {
  return body::make_shape(cad::remesh(d), std::make_shared<const cad::Drawing>(d));
}

/// The shape after wear of depth(x) on a boundary.
inline body::ShapePtr wear(const body::ShapePtr& shape, const std::string& boundary,
                           const std::function<double(Vec2)>& depth, Analysis analysis = Analysis::plane_strain) {
  const auto result = adapt::evolve(shape, analysis, {worn_by(shape->mesh, boundary, depth, analysis)});
  if (!result.shape) throw std::runtime_error(result.failure);
  return result.shape;
}

inline std::vector<cad::EdgeType> types(const cad::Loop& loop) {
  std::vector<cad::EdgeType> all;
  for (const auto& edge : loop) all.push_back(edge.type);
  return all;
}

inline int worn_edges(const cad::Loop& loop) {
  return static_cast<int>(std::count_if(loop.begin(), loop.end(), [](const cad::Edge& e) { return e.worn; }));
}

}  // namespace reye::support
