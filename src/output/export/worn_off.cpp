#include "output/export/worn_off.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mesh/measure.hpp"
#include "mesh/solid/solid_measure.hpp"
#include "output/report/run_data.hpp"
#include "output/solid/solid_vtk.hpp"

namespace reye::output {

namespace {

/// int pi r^2 dy along an edge through its middle m, exact for parabolas: three points of Gauss.
double swept(const base::Vec2& a, const base::Vec2& m, const base::Vec2& b) {
  static const std::array<double, 3> places{-std::sqrt(0.6), 0.0, std::sqrt(0.6)},
      weights{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
  double sum = 0.0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double t = places[k];
    const double r = 0.5 * t * (t - 1.0) * a.x() + (1.0 - t * t) * m.x() + 0.5 * t * (t + 1.0) * b.x();
    const double dy = (t - 0.5) * a.y() - 2.0 * t * m.y() + (t + 0.5) * b.y();
    sum += weights[k] * std::numbers::pi * r * r * dy;
  }
  return sum;
}

double swept_volume(const mesh::Mesh& mesh) {
  const std::size_t step = mesh.cells.empty() ? 1 : static_cast<std::size_t>(mesh::order(mesh.kind));
  double sum = 0.0;
  for (const auto& loop : mesh.outline)
    for (std::size_t i = 0; i + step < loop.size(); i += step) {
      const base::Vec2 &a = mesh.X[loop[i]], &b = mesh.X[loop[i + step]];
      sum += swept(a, step == 2 ? mesh.X[loop[i + 1]] : base::Vec2(0.5 * (a + b)), b);
    }
  return sum;
}

}  // namespace

double content(const WornBody& body, base::Analysis analysis) {
  return analysis == base::Analysis::axisymmetric ? swept_volume(body.mesh) : mesh::area(body.mesh);
}

double content(const WornSolid& solid) { return mesh::volume(solid.mesh); }

double depth_amount(const WornBody& body, base::Analysis analysis) {
  const auto weighted = [&](int node) {
    return body.wear_depth_mm[static_cast<std::size_t>(node)] * base::out_of_plane(analysis, body.mesh.X[node].x());
  };
  double sum = 0.0;
  for (const auto& loop : body.mesh.outline)
    for (std::size_t i = 1; i < loop.size(); ++i)
      sum +=
          0.5 * (weighted(loop[i - 1]) + weighted(loop[i])) * (body.mesh.X[loop[i]] - body.mesh.X[loop[i - 1]]).norm();
  return sum;
}

namespace {

/// What a frame says of shapes and wear.
struct Look {
  std::vector<base::Points> plane;
  std::vector<base::Points3> solid;
  double deepest_mm = 0.0;
};

Look look_at(const std::string& dir, bool solid, std::size_t frame) {
  Look look;
  const std::string bodies = frame_path(dir, "bodies", "vtu", frame),
                    surfaces = frame_path(dir, "surface", "vtp", frame);
  const auto count = [&look](const std::vector<double>& depths) {
    for (const double depth : depths) look.deepest_mm = std::max(look.deepest_mm, depth);
  };
  if (solid) {
    for (auto& body : read_worn_solids(bodies)) look.solid.push_back(std::move(body.mesh.X));
    for (const auto& skin : read_drawn_skins(surfaces).all) count(skin.wear_depth_mm);
    return look;
  }
  for (auto& body : read_worn_bodies(bodies)) {
    count(body.wear_depth_mm);
    look.plane.push_back(std::move(body.mesh.X));
  }
  return look;
}

}  // namespace

Lag lag_of(const std::string& dir, bool solid, std::size_t frame) {
  const Look now = look_at(dir, solid, frame);
  Lag lag{frame, now.deepest_mm, 0.0};
  while (lag.shown > 0) {
    const Look before = look_at(dir, solid, lag.shown - 1);
    if (before.plane != now.plane || before.solid != now.solid) break;
    --lag.shown;
    lag.lacking_mm = now.deepest_mm - before.deepest_mm;
  }
  return lag;
}

}  // namespace reye::output
