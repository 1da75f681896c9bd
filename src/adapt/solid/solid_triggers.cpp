#include "adapt/solid/solid_triggers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "adapt/solid/skin_strip.hpp"
#include "adapt/solid/solid_wear.hpp"
#include "base/formatted.hpp"
#include "mesh/solid/solid_measure.hpp"

namespace reye::adapt {

namespace {

/// Only what has less than this share of its shape at birth counts.
constexpr double kept_of_birth = 0.7;

bool any_moved(const mesh::SolidMesh& now, const mesh::SolidMesh& born, const int* nodes, int count) {
  return std::any_of(nodes, nodes + count, [&](int node) { return now.X[node] != born.X[node]; });
}

void keep_least(MeasuredInSpace& least, double now, double at_birth, const mesh::Vec3& at) {
  if (now < kept_of_birth * at_birth && now < least.value) least = {now, at};
}

void measure_cells(const mesh::SolidMesh& now, const mesh::SolidMesh& born, SolidMeshState& state) {
  const int n = mesh::solid_nodes(now.kind);
  for (int cell = 0; cell < now.cell_count(); ++cell) {
    if (!any_moved(now, born, now.cells[cell].data(), n)) continue;
    const double quality = worn_quality(now, cell);
    if (quality < state.quality.value)
      keep_least(state.quality, quality, worn_quality(born, cell), now.X[now.cells[cell][0]]);
  }
}

/// Height over longest edge, in units of that of the regular triangle, or of the square.
double facet_shape(const FacetPoints& x, mesh::FacetKind kind) {
  const int n = mesh::facet_corners(kind);
  double longest = 0.0;
  for (int a = 0; a < n; ++a) longest = std::max(longest, (x.col((a + 1) % n) - x.col(a)).norm());
  const double height = smallest_height(kind == mesh::FacetKind::tri6 ? mesh::FacetKind::tri3 : kind, x);
  return (n == 4 ? 1.0 : 2.0 / std::sqrt(3.0)) * height / longest;
}

double mean_side(const FacetPoints& x, mesh::FacetKind kind) {
  const int n = mesh::facet_corners(kind);
  double sum = 0.0;
  for (int a = 0; a < n; ++a) sum += (x.col((a + 1) % n) - x.col(a)).norm();
  return sum / n;
}

void measure_facets(const mesh::SolidMesh& now, const mesh::SolidMesh& born, SolidMeshState& state) {
  for (const mesh::Facet& facet : now.skin) {
    if (!any_moved(now, born, facet.nodes.data(), facet.count())) continue;
    const FacetPoints x = points_of(now.X, facet), before = points_of(born.X, facet);
    const mesh::Vec3 at = x.leftCols(mesh::facet_corners(facet.kind)).rowwise().mean();
    keep_least(state.facet_shape, facet_shape(x, facet.kind), facet_shape(before, facet.kind), at);
    const double ratio = mean_side(x, facet.kind) / mean_side(before, facet.kind),
                 squeeze = smallest_height(facet.kind, before) / smallest_height(facet.kind, x),
                 change = std::max({ratio, 1.0 / ratio, squeeze});
    if (change > state.size_ratio.value) state.size_ratio = {change, at};
  }
}

/// How far a bound is exceeded, and the sentence that says so.
struct SolidReason {
  double factor = 1.0;
  std::string text;
};

void keep_worse(SolidReason& worst, double factor, const char* subject, const MeasuredInSpace& m, const char* verb,
                const std::string& bound) {
  if (!(factor > worst.factor)) return;
  worst = {factor, subject + base::formatted("at (%.6g, %.6g, %.6g) mm ", m.at.x(), m.at.y(), m.at.z()) + verb +
                       base::formatted("%.3g", m.value) + bound};
}

/// bound / value for values that must not fall below; a value of zero or less is beyond all.
double shortfall(double value, double bound) {
  return value > 0.0 ? bound / value : bound > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
}

}  // namespace

SolidMeshState measure(const mesh::SolidMesh& worn, const mesh::SolidMesh& born) {
  SolidMeshState state;
  measure_cells(worn, born, state);
  measure_facets(worn, born, state);
  const auto wear = wear_in_elements(worn, born);
  const auto largest = std::max_element(wear.begin(), wear.end());
  if (largest != wear.end()) state.wear_fraction = {*largest, worn.X[largest - wear.begin()]};
  return state;
}

std::string why_remesh(const mesh::SolidMesh& worn, const mesh::SolidMesh& born, const SolidTriggers& triggers) {
  const SolidMeshState m = measure(worn, born);
  SolidReason worst;
  const auto below = [](double bound) { return base::formatted(", below %g", bound); };
  keep_worse(worst, shortfall(m.quality.value, triggers.min_quality), "the element ", m.quality, "has shape ",
             below(triggers.min_quality));
  keep_worse(worst, shortfall(m.facet_shape.value, triggers.min_facet_shape), "the facet ", m.facet_shape, "has shape ",
             below(triggers.min_facet_shape));
  keep_worse(worst, m.size_ratio.value / triggers.size_ratio, "the facet ", m.size_ratio,
             "has changed its size by the factor ", base::formatted(", above %g", triggers.size_ratio));
  keep_worse(worst, m.wear_fraction.value / triggers.wear_fraction, "wear ", m.wear_fraction,
             "since the mesh was made is ",
             base::formatted(" times the height of the element below, above %g", triggers.wear_fraction));
  return worst.text;
}

}  // namespace reye::adapt
