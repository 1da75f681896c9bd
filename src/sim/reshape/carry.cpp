#include "sim/reshape/carry.hpp"

#include <algorithm>
#include <concepts>
#include <functional>

#include "adapt/transfer/surface_transfer.hpp"
#include "contact/fields.hpp"

namespace reye::sim {

mortar::Surface surface_of(const contact::BoundaryRef& ref, base::Analysis analysis,
                           const std::vector<body::ShapePtr>& shapes) {
  const auto& mesh = shapes[ref.body]->mesh;
  std::vector<int> nodes;
  return mortar::make_surface(mesh.X, mesh.boundaries.at(ref.boundary), analysis, nodes, mesh::order(mesh.kind));
}

namespace {

using adapt::SurfaceKind;

/// Nodal values as columns of numbers and back.
template <class T, class Get>
std::vector<double> column(const std::vector<T>& values, Get get) {
  std::vector<double> numbers(values.size());
  for (std::size_t j = 0; j < values.size(); ++j) numbers[j] = get(values[j]);
  return numbers;
}

/// Quantities carried from one mesh of a boundary to another: members of a contact's state and further ones.
class Load {
 public:
  void add(SurfaceKind kind, std::vector<double>& values) {
    fields_.push_back({"", kind, values});
    put_.push_back([&values](std::vector<double> carried) { values = std::move(carried); });
  }
  void add(SurfaceKind kind, std::vector<Vec2>& values) {
    for (int i : {0, 1}) {
      fields_.push_back({"", kind, column(values, [i](const Vec2& v) { return v[i]; })});
      put_.push_back([&values, i](const std::vector<double>& carried) {
        values.resize(carried.size(), Vec2::Zero());
        for (std::size_t k = 0; k < carried.size(); ++k) values[k][i] = carried[k];
      });
    }
  }
  void add(SurfaceKind kind, std::vector<contact::ContactStatus>& values) {
    fields_.push_back({"", kind, column(values, [](auto status) { return static_cast<double>(status); })});
    put_.push_back([&values](const std::vector<double>& carried) {
      values.resize(carried.size());
      for (std::size_t k = 0; k < carried.size(); ++k)
        values[k] = static_cast<contact::ContactStatus>(static_cast<int>(carried[k]));
    });
  }
  void carry(const mortar::Surface& from, const mortar::Surface& to) {
    auto carried = adapt::carry(from, fields_, to).fields;
    for (std::size_t k = 0; k < put_.size(); ++k) put_[k](std::move(carried[k].values));
  }

 private:
  std::vector<adapt::SurfaceField> fields_;
  std::vector<std::function<void(std::vector<double>)>> put_;
};

SurfaceKind kind_of(contact::OnFreshMesh way) {
  if (way == contact::OnFreshMesh::summed) return SurfaceKind::summed;
  return way == contact::OnFreshMesh::nearest ? SurfaceKind::nearest : SurfaceKind::interpolated;
}

bool is_carried(const contact::Field& field, contact::Site site) {
  return field.site == site && field.on_fresh_mesh != contact::OnFreshMesh::derived;
}

/// Values at the nodes of a primary side, part by part.
void carry_parts(const PlacedContact& placed, base::Analysis analysis, const std::vector<body::ShapePtr>& from,
                 const std::vector<body::ShapePtr>& to, SurfaceKind kind, std::vector<double>& values) {
  std::vector<double> carried;
  auto first = values.begin();
  for (const auto& ref : placed.primary) {
    const auto old = surface_of(ref, analysis, from);
    const auto last = first + old.node_count();
    std::vector<double> part(first, last);
    first = last;
    if (from[ref.body] != to[ref.body]) {
      Load load;
      load.add(kind, part);
      load.carry(old, surface_of(ref, analysis, to));
    }
    carried.insert(carried.end(), part.begin(), part.end());
  }
  values = std::move(carried);
}

void carry_secondary(const mortar::Surface& from, const mortar::Surface& to, contact::ContactState& s,
                     HeldTraction& held) {
  Load load;
  load.add(SurfaceKind::summed, held.normal);
  load.add(SurfaceKind::summed, held.tangential);
  contact::for_each_field(s, [&](const contact::Field& field, auto& member) {
    if constexpr (requires { load.add(SurfaceKind::summed, member); })
      if (is_carried(field, contact::Site::secondary) && !member.empty())
        load.add(kind_of(field.on_fresh_mesh), member);
  });
  load.carry(from, to);
  contact::for_each_field(s, [](const contact::Field& field, auto& member) {
    if constexpr (std::same_as<std::remove_cvref_t<decltype(member)>, std::vector<Vec2>>)
      if (field.on_fresh_mesh == contact::OnFreshMesh::direction)
        for (Vec2& v : member) v = v.norm() > 0.0 ? v.normalized() : Vec2(Vec2::Zero());
  });
}

/// The multipliers of the held forces.
void derive_tractions(const mortar::Surface& on, contact::ContactState& s, HeldTraction& held) {
  for (std::size_t k = 0; k < s.lambda.size(); ++k) {
    if (s.status[k] == contact::ContactStatus::inactive) held.normal[k] = held.tangential[k] = 0.0;
    const Vec2 t(-s.normal[k].y(), s.normal[k].x());
    s.lambda[k] = (held.normal[k] * s.normal[k] + held.tangential[k] * t) / on.area[k];
  }
}

}  // namespace

void carry_contact(const PlacedContact& placed, base::Analysis analysis, const std::vector<body::ShapePtr>& from,
                   const std::vector<body::ShapePtr>& to, contact::ContactState& state, HeldTraction& held) {
  const auto fresh = [&](const contact::BoundaryRef& ref) { return from[ref.body] != to[ref.body]; };
  const bool secondary = fresh(placed.secondary);
  if (!secondary && std::none_of(placed.primary.begin(), placed.primary.end(), fresh)) return;
  const auto on = surface_of(placed.secondary, analysis, to);
  if (secondary) carry_secondary(surface_of(placed.secondary, analysis, from), on, state, held);
  contact::for_each_field(state, [&](const contact::Field& field, auto& member) {
    if constexpr (std::same_as<std::remove_cvref_t<decltype(member)>, std::vector<double>>)
      if (is_carried(field, contact::Site::primary) && !member.empty())
        carry_parts(placed, analysis, from, to, kind_of(field.on_fresh_mesh), member);
  });
  contact::clear_fields(state, state.slip.size(), state.removed_primary.size(), [&](const contact::Field& field) {
    return field.on_fresh_mesh == contact::OnFreshMesh::derived && (secondary || field.site == contact::Site::primary);
  });
  state.reference.assign(state.slip.size(), contact::MortarRow{});  // of either side
  if (secondary) derive_tractions(on, state, held);
}

}  // namespace reye::sim
