#include "output/export/worn_off.hpp"

#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "mesh/measure.hpp"
#include "mesh/solid/solid_measure.hpp"
#include "output/solid/solid_run_data.hpp"

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

double worn_volume(const std::string& dir, double cycle) {
  const Table history = read_solid_run(dir).run.history;
  const auto& cycles = history.column("cycle");
  std::size_t row = 0;
  while (row < cycles.size() && cycles[row] <= cycle * (1.0 + 1e-9)) ++row;
  double sum = 0.0;
  for (std::size_t c = 0; c < history.columns.size() && row > 0; ++c)
    if (history.columns[c].ends_with("_volume_secondary_mm3") || history.columns[c].ends_with("_volume_primary_mm3"))
      sum += history.values[c][row - 1];
  return sum;
}

}  // namespace reye::output
