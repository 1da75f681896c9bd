#include "sim/place/warn_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/formatted.hpp"
#include "mesh/measure.hpp"
#include "scene/histories.hpp"
#include "sim/measure/drawn_gap.hpp"
#include "sim/measure/roundness.hpp"
#include "sim/measure/sides.hpp"
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
    const double distance = mesh::distance_to_edge(surface.X[a], surface.X[b], X);
    if (distance < best.distance)
      best = {distance, mesh::nearest_parameter(surface.X[a], surface.X[b], X) < 0.5 ? a : b};
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

/// Whether several contacts share the load of a body.
bool shares_its_load(const Problem& problem, int body) {
  return std::count_if(problem.contacts.begin(), problem.contacts.end(),
                       [&](const PlacedContact& contact) { return lies_on(contact, body); }) > 1;
}

/// The largest force along d with which a support loads a body.
double support_force(const Problem& problem, int body, const Vec2& d) {
  double force = 0.0;
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
  return force;
}

/// Force of a support that presses the two bodies together along d; empty where other contacts share it, or none is
/// known.
std::optional<double> pressing_force(const Problem& problem, const PlacedContact& contact, const Vec2& d) {
  double force = 0.0;
  const auto look = [&](int body) {
    if (!shares_its_load(problem, body)) force = std::max(force, support_force(problem, body, d));
  };
  look(contact.secondary.body);
  for (const auto& ref : contact.primary) look(ref.body);
  return force > 0.0 ? std::optional(force) : std::nullopt;
}

/// The fine zone nearest to a secondary node; null: there is none.
const cad::FineZone* zone_of(const Problem& problem, const contact::Setup& setup, int j) {
  return zone_round(*problem.shapes[setup.secondary_nodes.front().body], setup.options.name, setup.secondary.X[j]);
}

/// Way from where the sides are nearest to the nearest node in a fine zone; 0 where a zone contains, to one of its
/// elements, any of the places at which they are.
double way_to_zone(const Problem& problem, const contact::Setup& setup, const Touch& touch) {
  double way = std::numeric_limits<double>::infinity();
  for (int j = 0; j < setup.secondary_count(); ++j) {
    const double size = zone_of(problem, setup, j)->size_mm;
    if (spacing(setup.secondary, j) > coarse_in_zone * size) continue;
    if (touch.gap[j].distance <= touch.least() + size) return 0.0;
    way = std::min(way, away(setup, j, setup.secondary.X[touch.secondary]));
  }
  return way;
}

/// Warns where the sides are nearest beside the fine zones, and no support brings them there.
void warn_of_zone(Problem& problem, const contact::Setup& setup, const Touch& touch, const PlacedContact& contact) {
  const auto* zone = zone_of(problem, setup, touch.secondary);
  if (!zone || farthest_way(problem, contact) >= way_to_zone(problem, setup, touch)) return;
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

/// Whether the sides touch like a ball on the axis.
bool touch_on_axis(const Problem& problem, const mortar::Surface& s, int node) {
  return problem.scene.analysis == base::Analysis::axisymmetric && s.X[node].x() < spacing(s, node);
}

/// Force that presses the sides together where they touch, of a ring off the axis per length; empty where it is not
/// known.
std::optional<double> force_at(const Problem& problem, const mortar::Surface& s, int node,
                               const PlacedContact& contact) {
  if (s.before[node] < 0 && s.after[node] < 0) return std::nullopt;
  const auto& [a, b, mid] = s.facets[s.before[node] >= 0 ? s.before[node] : s.after[node]];
  auto force = pressing_force(problem, contact, mesh::outward_normal(s.X[a], s.X[b]));
  if (force && problem.scene.analysis == base::Analysis::axisymmetric && !touch_on_axis(problem, s, node))
    force = *force / (2.0 * std::numbers::pi * s.X[node].x());
  return force;
}

/// Length of the elements where the sides touch, of the coarser side.
double longer_spacing(const Problem& problem, const contact::Setup& setup, const Touch& touch,
                      const PlacedContact& contact) {
  const bool primary_rigid = problem.rigid[contact.primary.front().body];
  return std::max(spacing(setup.secondary, touch.secondary),
                  primary_rigid ? 0.0 : spacing(setup.primary, touch.primary));
}

void warn_of_load(Problem& problem, const contact::Setup& setup, const Touch& touch, const PlacedContact& contact) {
  const auto own = curvature(setup.secondary, touch.secondary), other = curvature(setup.primary, touch.primary);
  const auto force = force_at(problem, setup.secondary, touch.secondary, contact);
  if (!force || !own || !other || *own + *other <= 0.0) return;
  const bool ball = touch_on_axis(problem, setup.secondary, touch.secondary);
  const double modulus = effective_modulus(problem, contact);
  const double length = hertz_length(*force, 1.0 / (*own + *other), modulus, ball);
  if (length * std::max(std::abs(*own), std::abs(*other)) > 0.5) {  // not half spaces: the sides conform
    const double chords = sagitta(setup.secondary, touch.secondary) + sagitta(setup.primary, touch.primary);
    if (!ball)
      warn_of_facets(problem.warnings, setup.options.name, chords, 2.0 * *force / modulus,
                     spacing(setup.secondary, touch.secondary));
  } else if (touch_alone(setup.secondary, touch, length, *own + *other)) {
    warn_of_resolution(problem.warnings, setup.options.name, length / longer_spacing(problem, setup, touch, contact),
                       wanted_across(problem, setup.options), length,
                       base::formatted("by Hertz, %.3g mm of contact under the full load", length));
  }
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
