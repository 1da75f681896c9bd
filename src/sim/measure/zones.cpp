#include "sim/measure/zones.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>

#include "base/formatted.hpp"
#include "cad/part/zone.hpp"
#include "sim/measure/sides.hpp"

namespace reye::sim {

namespace {

constexpr double margin_elements = 3.0;  ///< elements that a zone keeps free at each end
constexpr double room = 1.5;             ///< width of a new zone over that of the contact

Vec2 direction(const cad::FineZone& zone) {
  const double angle = zone.angle_deg * std::numbers::pi / 180.0;
  return {std::cos(angle), std::sin(angle)};
}

/// Per primary node: a node that touches meets it.
std::vector<char> met_primary(const contact::ContactState& s) {
  std::vector<char> met(s.pending_primary.size(), 0);
  for (std::size_t j = 0; j < s.status.size(); ++j) {
    if (s.status[j] == contact::ContactStatus::inactive) continue;
    for (const auto& [l, M] : s.reference[j].M) met[l] = 1;
  }
  return met;
}

/// Mesh nodes of the body that touch in this contact, or have worn in this block, on the sides that lie on the body.
std::set<int> nodes_in_use(const Problem& problem, const State& state, int contact, int body) {
  const auto& placed = problem.contacts[contact];
  const auto& s = state.solution.contacts[contact];
  std::set<int> used;
  const auto met = met_primary(s);
  if (placed.secondary.body == body) {
    const auto own = side_nodes(state.shapes, placed.secondary);
    for (std::size_t j = 0; j < own.size(); ++j)
      if (s.status[j] != contact::ContactStatus::inactive || s.pending_secondary[j] > 0.0) used.insert(own[j]);
  }
  std::size_t l = 0;
  for (const auto& ref : placed.primary)
    for (int node : side_nodes(state.shapes, ref)) {
      if (ref.body == body && (met[l] || s.pending_primary[l] > 0.0)) used.insert(node);
      ++l;
    }
  return used;
}

/// Whether this zone is the nearest to X of those of its contact on this body: each follows the contact nearest to it.
bool is_at(const cad::Drawing& drawing, const cad::FineZone& zone, const Vec2& X) {
  const auto zones = zones_of(drawing, zone.contact);
  return zones[cad::zone_at(zones, X)] == &zone;
}

/// Range along the zone, from its centre, that the contact uses round it on this body.
std::optional<std::array<double, 2>> range_in_use(const Problem& problem, const State& state, int body,
                                                  const cad::FineZone& zone, const body::Shape& shape) {
  std::optional<std::array<double, 2>> range;
  const Vec2 along = direction(zone);
  const auto& X = shape.mesh.X;
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    if (problem.contacts[c].options.name != zone.contact) continue;
    for (int node : nodes_in_use(problem, state, static_cast<int>(c), body)) {
      if (!is_at(*shape.drawing, zone, X[node])) continue;
      const double t = along.dot(X[node] - zone.centre_mm);
      if (!range) range = {t, t};
      range = {std::min((*range)[0], t), std::max((*range)[1], t)};
    }
  }
  return range;
}

/// The part of the zone that its contact can use: the boundaries it lies on may end inside it.
std::array<double, 2> extent(const Problem& problem, const cad::FineZone& zone, int body, const body::Shape& shape) {
  const Vec2 along = direction(zone);
  const auto& mesh = shape.mesh;
  std::array<double, 2> all{1e300, -1e300};
  const auto add = [&](const contact::BoundaryRef& ref) {
    if (ref.body != body) return;
    for (int node : mesh::nodes_of(mesh.boundaries.at(ref.boundary))) {
      if (!is_at(*shape.drawing, zone, mesh.X[node])) continue;
      const double t = along.dot(mesh.X[node] - zone.centre_mm);
      all = {std::min(all[0], t), std::max(all[1], t)};
    }
  };
  for (const auto& contact : problem.contacts) {
    if (contact.options.name != zone.contact) continue;
    add(contact.secondary);
    for (const auto& ref : contact.primary) add(ref);
  }
  return all;
}

/// Length by which the contact enters the margin at an end of the zone behind which the boundary continues; <= 0: it
/// does not.
double excess(const Problem& problem, const State& state, int body, const cad::FineZone& zone,
              const body::Shape& shape) {
  if (zone.turns) return 0.0;
  const auto range = range_in_use(problem, state, body, zone, shape);
  if (!range) return 0.0;
  const auto all = extent(problem, zone, body, shape);
  const double half = zone.half_width_mm, kept = half - margin_elements * zone.size_mm;
  double most = 0.0;
  if (all[0] < -half) most = std::max(most, -(*range)[0] - kept);
  if (all[1] > half) most = std::max(most, (*range)[1] - kept);
  return most;
}

bool is_of(const PlacedContact& contact, int body, const std::string& boundary) {
  const auto is = [&](const contact::BoundaryRef& ref) { return ref.body == body && ref.boundary == boundary; };
  return is(contact.secondary) || std::any_of(contact.primary.begin(), contact.primary.end(), is);
}

/// The zone's centre, moved across the zone onto the boundary of its contact: wear has moved the outline away from it,
/// and a zone starts at the outline point nearest to its centre. Unchanged where the boundary does not pass the zone.
Vec2 on_outline(const Problem& problem, const cad::FineZone& zone, int body, const mesh::Mesh& mesh) {
  const Vec2 along = direction(zone);
  Vec2 centre = zone.centre_mm;
  double nearest = std::numeric_limits<double>::infinity();
  const auto look = [&](const Vec2& a, const Vec2& b) {
    const double ta = along.dot(a - zone.centre_mm), tb = along.dot(b - zone.centre_mm);
    if (ta * tb > 0.0 || ta == tb) return;
    const Vec2 p = a + ta / (ta - tb) * (b - a);
    if (const double d = (p - zone.centre_mm).norm(); d < nearest) {
      nearest = d;
      centre = p;
    }
  };
  for (const auto& contact : problem.contacts)
    for (const auto& [name, boundary] : mesh.boundaries)
      if (contact.options.name == zone.contact && is_of(contact, body, name))
        for (const auto& chain : boundary)
          for (std::size_t k = 1; k < chain.size(); ++k) look(mesh.X[chain[k - 1]], mesh.X[chain[k]]);
  const bool moved = (centre - zone.centre_mm).norm() > 1e-9 * zone.size_mm;
  return moved ? centre : zone.centre_mm;
}

}  // namespace

std::vector<const cad::FineZone*> zones_of(const cad::Drawing& drawing, const std::string& contact) {
  std::vector<const cad::FineZone*> zones;
  for (const auto& zone : drawing.zones)
    if (zone.contact == contact) zones.push_back(&zone);
  return zones;
}

std::string leaves_zone(const Problem& problem, const State& state, int body, const body::Shape& shape) {
  if (!shape.drawing) return {};
  for (const auto& zone : shape.drawing->zones)
    if (excess(problem, state, body, zone, shape) > 0.0) {
      return base::formatted(
          "contact %s comes within %g elements of an end of its fine zone round (%.4g, %.4g), %.4g mm from the centre",
          zone.contact.c_str(), margin_elements, zone.centre_mm.x() + 0.0, zone.centre_mm.y() + 0.0,
          zone.half_width_mm);
    }
  return {};
}

namespace {

/// Moves and widens a zone to the range that its contact uses, with as many elements across as were asked for.
void widen_to(const std::array<double, 2>& range, const cad::FineZone& asked, cad::FineZone& zone) {
  zone.centre_mm += 0.5 * (range[0] + range[1]) * direction(zone);
  zone.half_width_mm =
      std::max(asked.half_width_mm, room * 0.5 * (range[1] - range[0]) + margin_elements * zone.size_mm);
  const double factor = zone.half_width_mm / asked.half_width_mm;
  zone.size_mm = factor * asked.size_mm;
  zone.depth_mm = factor * asked.depth_mm;
}

}  // namespace

std::vector<cad::FineZone> followed_zones(const Problem& problem, const State& state, int body,
                                          const body::Shape& shape) {
  std::vector<cad::FineZone> zones;
  if (!shape.drawing) return zones;
  for (const auto& former : shape.drawing->zones) {
    cad::FineZone zone = former;
    const auto range = range_in_use(problem, state, body, former, shape);
    const auto* asked = asked_for(problem, former);
    if (range && asked && excess(problem, state, body, former, shape) > 0.0) widen_to(*range, *asked, zone);
    zone.centre_mm = on_outline(problem, zone, body, shape.mesh);
    zones.push_back(zone);
  }
  return zones;
}

const cad::FineZone* asked_for(const Problem& problem, const cad::FineZone& zone) {
  for (const auto& asked : problem.scene.geometry.fine_zones)
    if (asked.key == zone.key) return &asked;
  return nullptr;
}

}  // namespace reye::sim
