#include "sim/place/warn_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/formatted.hpp"
#include "scene/histories.hpp"
#include "sim/measure/drawn_gap.hpp"
#include "sim/measure/roundness.hpp"
#include "sim/measure/warn_contact.hpp"
#include "sim/problem/warnings.hpp"

namespace reye::sim {

namespace {

/// Distance of a point from the nearest facet (its chord) and the nearer node of that.
struct NearestFacet {
  double distance = std::numeric_limits<double>::infinity();
  int node = -1;
};

NearestFacet nearest_facet(const mortar::Surface& surface, const Vec2& X) {
  NearestFacet best;
  for (const auto& [a, b, mid] : surface.facets) {
    const Vec2 d = surface.X[b] - surface.X[a];
    const double t = std::clamp((X - surface.X[a]).dot(d) / d.squaredNorm(), 0.0, 1.0);
    const double distance = (X - surface.X[a] - t * d).norm();
    if (distance < best.distance) best = {distance, t < 0.5 ? a : b};
  }
  return best;
}

double away(const contact::Setup& setup, int secondary, const Vec2& from) {
  return (setup.secondary.X[secondary] - from).norm();
}

/// Where the two sides are nearest on the drawing, or one lies deepest in the other.
struct Touch {
  std::vector<NearestFacet> gap;  ///< per secondary node
  int secondary = 0, primary = 0;
  double least() const { return gap[secondary].distance; }
};

Touch touch_of(const contact::Setup& setup, const DrawnGap& drawn) {
  Touch touch;
  for (const Vec2& X : setup.secondary.X) touch.gap.push_back(nearest_facet(setup.primary, X));
  const auto least =
      std::min_element(touch.gap.begin(), touch.gap.end(),
                       [](const NearestFacet& a, const NearestFacet& b) { return a.distance < b.distance; });
  touch.secondary = static_cast<int>(least - touch.gap.begin());
  if (drawn.let_in)
    for (int j = 0; j < setup.secondary_count(); ++j)
      if (away(setup, j, drawn.at) < away(setup, touch.secondary, drawn.at)) touch.secondary = j;
  touch.primary = touch.gap[touch.secondary].node;
  return touch;
}

/// Force of a support that presses the two bodies together along d; empty where other contacts share it, or none is
/// known.
std::optional<double> pressing_force(const Problem& problem, const PlacedContact& contact, const Vec2& d) {
  double force = 0.0;
  const auto look = [&](int body) {
    const auto here = std::count_if(problem.contacts.begin(), problem.contacts.end(), [&](const PlacedContact& c) {
      return c.secondary.body == body ||
             std::any_of(c.primary.begin(), c.primary.end(), [&](const auto& ref) { return ref.body == body; });
    });
    if (here > 1) return;
    for (const auto& support : problem.inputs[body].supports) {
      const double angle = support.angle_deg * std::numbers::pi / 180.0;
      const Vec2 x(std::cos(angle), std::sin(angle));
      const auto along = [&](const body::Motion& motion, const Vec2& axis) {
        if (motion.drive == body::Drive::loaded && motion.stiffness == 0.0)
          force = std::max(force, scene::largest_value(problem.scene, motion.parts) * std::abs(axis.dot(d)));
      };
      along(support.x, x);
      along(support.y, Vec2(-x.y(), x.x()));
    }
  };
  look(contact.secondary.body);
  for (const auto& ref : contact.primary) look(ref.body);
  return force > 0.0 ? std::optional(force) : std::nullopt;
}

/// The fine zone nearest to a secondary node; null: there is none.
const cad::FineZone* zone_of(const Problem& problem, const contact::Setup& setup, int j) {
  return zone_round(*problem.shapes[setup.secondary_nodes.front().body], setup.options.name, setup.secondary.X[j]);
}

/// Warns where no zone contains, to one of its elements, any of the places at which the sides are nearest.
void warn_of_zone(Problem& problem, const contact::Setup& setup, const Touch& touch, const PlacedContact& contact) {
  const auto* zone = zone_of(problem, setup, touch.secondary);
  if (!zone) return;
  double away = std::numeric_limits<double>::infinity();
  for (int j = 0; j < setup.secondary_count(); ++j) {
    const double size = zone_of(problem, setup, j)->size_mm;
    if (spacing(setup.secondary, j) > coarse_in_zone * size) continue;
    if (touch.gap[j].distance <= touch.least() + size) return;
    away = std::min(away, (setup.secondary.X[j] - setup.secondary.X[touch.secondary]).norm());
  }
  if (farthest_way(problem, contact) >= away) return;
  const Vec2& X = setup.secondary.X[touch.secondary];
  const double h = spacing(setup.secondary, touch.secondary);
  warn(problem.warnings,
       {"fine_zone", "contact " + setup.options.name,
        base::formatted(
            "The sides come nearest at (%.4g, %.4g), where elements are %.3g mm long; the fine zone of %.3g mm lies "
            "beside it, round (%.4g, %.4g). Set fine_zone.centre_mm to where they touch.",
            X.x() + 0.0, X.y() + 0.0, h, zone->size_mm, zone->centre_mm.x() + 0.0, zone->centre_mm.y() + 0.0),
        h / zone->size_mm});
}

/// Length of the contact by Hertz: of a line under a force per length, of a ball on the axis.
double hertz_length(double force, double radius, double modulus, bool ball) {
  return 2.0 * (ball ? std::cbrt(0.75 * force * radius / modulus)
                     : std::sqrt(4.0 * force * radius / (std::numbers::pi * modulus)));
}

/// Whether the sides come apart from where they touch as those of a Hertzian contact of that length do: no node farther
/// away is as near to the other side.
bool touch_alone(const mortar::Surface& s, const Touch& touch, double length, double kappa) {
  const Vec2& X = s.X[touch.secondary];
  for (int j = 0; j < s.node_count(); ++j)
    if (touch.gap[j].distance <= touch.least() + length * length * kappa / 8.0 &&
        (s.X[j] - X).norm() > length + spacing(s, touch.secondary))
      return false;
  return true;
}

void warn_of_load(Problem& problem, const contact::Setup& setup, const Touch& touch, const PlacedContact& contact) {
  const auto own = curvature(setup.secondary, touch.secondary), other = curvature(setup.primary, touch.primary);
  const auto& s = setup.secondary;
  const int j = touch.secondary;
  if (s.before[j] < 0 && s.after[j] < 0) return;
  const int facet = s.before[j] >= 0 ? s.before[j] : s.after[j];
  const Vec2 chord = s.X[s.facets[facet][1]] - s.X[s.facets[facet][0]];
  auto force = pressing_force(problem, contact, Vec2(chord.y(), -chord.x()).normalized());
  if (!force) return;
  const bool axisymmetric = problem.scene.analysis == base::Analysis::axisymmetric;
  const double r = s.X[j].x(), h = spacing(s, j), modulus = effective_modulus(problem, contact);
  const bool ball = axisymmetric && r < h;
  if (axisymmetric && !ball) force = *force / (2.0 * std::numbers::pi * r);
  if (!own || !other || *own + *other <= 0.0) return;
  const double length = hertz_length(*force, 1.0 / (*own + *other), modulus, ball);
  if (length * std::max(std::abs(*own), std::abs(*other)) > 0.5) {  // not half spaces: the sides conform
    if (!ball)
      warn_of_facets(problem.warnings, setup.options.name, sagitta(s, j) + sagitta(setup.primary, touch.primary),
                     2.0 * *force / modulus, h);
    return;
  }
  if (!touch_alone(s, touch, length, *own + *other)) return;
  const bool primary_rigid = problem.rigid[contact.primary.front().body];
  const double longer = std::max(h, primary_rigid ? 0.0 : spacing(setup.primary, touch.primary));
  warn_of_resolution(problem.warnings, setup.options.name, length / longer, wanted_across(problem, setup.options),
                     length, base::formatted("by Hertz, %.3g mm of contact under the full load", length));
}

}  // namespace

void warn_of_meshes(Problem& problem, const solver::System& system) {
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    const Touch touch = touch_of(setup, problem.contacts[c].drawn);
    warn_of_zone(problem, setup, touch, problem.contacts[c]);
    warn_of_load(problem, setup, touch, problem.contacts[c]);
  }
}

}  // namespace reye::sim
