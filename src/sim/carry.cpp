#include "sim/carry.hpp"

#include "adapt/surface_transfer.hpp"

namespace reye::sim {

mortar::Surface surface_of(const contact::BoundaryRef& ref, base::Analysis analysis,
                           const std::vector<body::ShapePtr>& shapes) {
  const auto& mesh = shapes[ref.body]->mesh;
  std::vector<int> nodes;
  return mortar::make_surface(mesh.X, mesh.boundaries.at(ref.boundary), analysis, nodes, mesh::order(mesh.kind));
}

namespace {

using adapt::SurfaceKind;

template <class Get>
std::vector<double> column(std::size_t count, Get get) {
  std::vector<double> values(count);
  for (std::size_t j = 0; j < count; ++j) values[j] = get(j);
  return values;
}

std::vector<double> carry_volume(const mortar::Surface& from, const std::vector<double>& volume,
                                 const mortar::Surface& to) {
  return adapt::carry(from, {{"removed volume", SurfaceKind::summed, volume}}, to).fields[0].values;
}

/// Volumes at the nodes of a primary side, part by part.
std::vector<double> carry_parts(const PlacedContact& placed, base::Analysis analysis,
                                const std::vector<body::ShapePtr>& from, const std::vector<body::ShapePtr>& to,
                                const std::vector<double>& volume) {
  std::vector<double> carried;
  auto first = volume.begin();
  for (const auto& ref : placed.primary) {
    const auto old = surface_of(ref, analysis, from);
    const auto last = first + old.node_count();
    std::vector<double> part(first, last);
    first = last;
    if (from[ref.body] != to[ref.body]) part = carry_volume(old, part, surface_of(ref, analysis, to));
    carried.insert(carried.end(), part.begin(), part.end());
  }
  return carried;
}

void carry_secondary(const mortar::Surface& from, const mortar::Surface& to, contact::ContactState& s,
                     HeldTraction& held) {
  if (!s.others_secondary.empty()) s.others_secondary = carry_volume(from, s.others_secondary, to);
  const std::size_t n = s.lambda.size();
  auto fields =
      adapt::carry(from,
                   {{"normal force", SurfaceKind::summed, held.normal},
                    {"tangential force", SurfaceKind::summed, held.tangential},
                    {"removed volume", SurfaceKind::summed, s.removed_secondary},
                    {"frictional work", SurfaceKind::summed, s.energy_secondary},
                    {"slip", SurfaceKind::interpolated, s.slip},
                    {"normal x", SurfaceKind::interpolated, column(n, [&](auto j) { return s.normal[j].x(); })},
                    {"normal y", SurfaceKind::interpolated, column(n, [&](auto j) { return s.normal[j].y(); })},
                    {"status", SurfaceKind::nearest, column(n, [&](auto j) { return double(s.status[j]); })}},
                   to)
          .fields;
  held.normal = std::move(fields[0].values);
  held.tangential = std::move(fields[1].values);
  s.removed_secondary = std::move(fields[2].values);
  s.energy_secondary = std::move(fields[3].values);
  s.slip = std::move(fields[4].values);
  const std::size_t m = s.slip.size();
  s.pending_secondary.assign(m, 0.0);
  s.lambda.assign(m, Vec2::Zero());
  s.normal.assign(m, Vec2::Zero());
  s.status.assign(m, contact::ContactStatus::inactive);
  for (std::size_t k = 0; k < m; ++k) {
    const Vec2 n_k(fields[5].values[k], fields[6].values[k]);
    if (n_k.norm() > 0.0) s.normal[k] = n_k.normalized();
    s.status[k] = static_cast<contact::ContactStatus>(static_cast<int>(fields[7].values[k]));
    if (s.status[k] == contact::ContactStatus::inactive) held.normal[k] = held.tangential[k] = 0.0;
    const Vec2 t(-s.normal[k].y(), s.normal[k].x());
    s.lambda[k] = (held.normal[k] * s.normal[k] + held.tangential[k] * t) / to.area[k];
  }
}

}  // namespace

void carry_contact(const PlacedContact& placed, base::Analysis analysis, const std::vector<body::ShapePtr>& from,
                   const std::vector<body::ShapePtr>& to, contact::ContactState& state, HeldTraction& held) {
  const auto fresh = [&](const contact::BoundaryRef& ref) { return from[ref.body] != to[ref.body]; };
  bool any = fresh(placed.secondary);
  if (any)
    carry_secondary(surface_of(placed.secondary, analysis, from), surface_of(placed.secondary, analysis, to), state,
                    held);
  for (const auto& ref : placed.primary) any = any || fresh(ref);
  if (!any) return;
  state.removed_primary = carry_parts(placed, analysis, from, to, state.removed_primary);
  if (!state.others_primary.empty())
    state.others_primary = carry_parts(placed, analysis, from, to, state.others_primary);
  state.pending_primary.assign(state.removed_primary.size(), 0.0);
  state.reference.assign(state.lambda.size(), contact::MortarRow{});
}

}  // namespace reye::sim
