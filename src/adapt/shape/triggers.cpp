#include "adapt/shape/triggers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "adapt/shape/cause.hpp"
#include "mesh/quality.hpp"

namespace reye::adapt {

namespace {

using base::Points;
using base::Vec2;

constexpr double kept_quality = 0.7;  ///< a cell that has more of its quality at birth is no reason for a new mesh

/// The smallest `quality` of the cells that have lost much of theirs since birth, none above `best`.
template <class Quality>
Measured poorest_changed(const body::Shape& shape, const Points& x, double best, Quality quality) {
  Measured poorest{best};
  const mesh::Mesh &mesh = shape.mesh, &born = *shape.born;
  for (const auto& cell : mesh.cells) {
    const double now = quality(x, mesh.kind, cell);
    if (now >= poorest.value || now >= kept_quality * quality(born.X, born.kind, cell)) continue;
    Vec2 centre = Vec2::Zero();
    const int n = mesh::nodes_per_cell(mesh.kind);
    for (int k = 0; k < n; ++k) centre += mesh.X[cell[k]] / n;
    poorest = {now, centre};
  }
  return poorest;
}

Measured largest_wear(const body::Shape& shape) {
  Measured largest;
  for (const auto& [node, wear] : wear_in_elements(shape.mesh, *shape.born))
    if (wear > largest.value) largest = {wear, shape.mesh.X[node]};
  return largest;
}

std::string at(const Vec2& place) {
  std::ostringstream text;
  text << "at (" << place.x() << ", " << place.y() << ") mm ";
  return text.str();
}

/// A bound that is exceeded by a factor, and the sentence that says so.
struct Reason {
  double factor = 1.0;
  std::string text;
};

void keep_worst(Reason& worst, double factor, const std::string& subject, const Measured& m, const std::string& verb,
                const std::string& bound) {
  if (!(factor > worst.factor)) return;
  std::ostringstream text;
  text << subject << at(m.at) << verb << m.value << bound;
  worst = {factor, text.str()};
}

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

/// bound / value for values that must not fall below; a value of zero or less is beyond all.
double undershoot(double value, double bound) {
  return value > 0.0 ? bound / value : bound > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
}

void judge(Reason& worst, const MeshState& m, const Triggers& t, const std::string& frame) {
  keep_worst(worst, undershoot(m.scaled_jacobian.value, t.min_scaled_jacobian), "the element ", m.scaled_jacobian,
             "has scaled Jacobian ", frame + ", below " + number(t.min_scaled_jacobian));
  keep_worst(worst, undershoot(m.angle_deg.value, t.min_angle_deg), "the element ", m.angle_deg, "has a corner of ",
             " degrees" + frame + ", below " + number(t.min_angle_deg));
  keep_worst(worst, m.size_ratio.value / t.size_ratio, "the facet ", m.size_ratio,
             "has changed its length by the factor ", frame + ", above " + number(t.size_ratio));
}

}  // namespace

Measured largest_size_ratio(const body::Shape& shape, const Points& x) {
  Measured largest{1.0};
  const auto edge = static_cast<std::size_t>(mesh::order(shape.mesh.kind));  // from vertex to vertex
  for (const auto& loop : shape.mesh.outline)
    for (std::size_t i = 0; i + edge < loop.size(); i += edge) {
      const double now = (x[loop[i + edge]] - x[loop[i]]).norm();
      const double born = (shape.born->X[loop[i + edge]] - shape.born->X[loop[i]]).norm();
      const double ratio = std::max(now / born, born / now);
      if (ratio > largest.value) largest = {ratio, 0.5 * (shape.mesh.X[loop[i]] + shape.mesh.X[loop[i + edge]])};
    }
  return largest;
}

MeshState measure(const body::Shape& shape, const Points& x) {
  const auto degrees = [](const Points& X, mesh::CellKind kind, const mesh::Cell& cell) {
    return mesh::smallest_angle(X, kind, cell) * 180.0 / std::numbers::pi;
  };
  return {poorest_changed(shape, x, 1.0, mesh::scaled_jacobian), poorest_changed(shape, x, 90.0, degrees),
          largest_size_ratio(shape, x), largest_wear(shape)};
}

std::string why_remesh(const body::Shape& shape, const Points* current, const Triggers& triggers) {
  const MeshState on_X = measure(shape, shape.mesh.X);
  Reason worst;
  judge(worst, on_X, triggers, "");
  if (current) judge(worst, measure(shape, *current), triggers, " when deformed");
  keep_worst(worst, on_X.wear_fraction.value / triggers.wear_fraction, "wear ", on_X.wear_fraction,
             "since the mesh was made is ",
             " times the height of the element below, above " + number(triggers.wear_fraction));
  return worst.text;
}

std::string why_renew(const body::Shape& shape, const Points& current, const Triggers& triggers) {
  Reason worst;
  judge(worst, measure(shape, current), triggers, " when deformed");
  return worst.text;
}

}  // namespace reye::adapt
