#include <algorithm>
#include <map>
#include <numeric>

#include "mesh/measure.hpp"
#include "sim/measure.hpp"

namespace reye::sim {

using contact::ContactStatus;

namespace {

/// Traction and slip per node of one side.
struct NodalValues {
  std::vector<double> pressure, shear, slip;
  std::vector<int> status;
};

/// Averaged outward normals on X.
std::vector<Vec2> normals(const mortar::Surface& s) {
  std::vector<Vec2> n(s.X.size(), Vec2::Zero());
  for (int f = 0; f < s.facet_count(); ++f) {
    const auto [a, b, mid] = s.facets[f];
    n[a] += mesh::outward_normal(s.X[a], s.X[s.beside(f, 0)]);
    n[b] += mesh::outward_normal(s.X[s.beside(f, 1)], s.X[b]);
    if (mid >= 0) n[mid] = mesh::outward_normal(s.X[a], s.X[b]);
  }
  for (auto& v : n) v.normalize();
  return n;
}

/// +1 when arc length grows with the chain's direction (its first end has the smaller x).
std::vector<double> direction(const mesh::Boundary& boundary, const base::Points& X) {
  std::vector<double> sign;
  std::map<int, double> of;
  for (const auto& chain : boundary) {
    const auto s = mesh::arc_lengths(X, chain);
    for (int node : chain) of[node] = s.back() >= s.front() ? 1.0 : -1.0;
  }
  for (int node : mesh::nodes_of(boundary)) sign.push_back(of[node]);
  return sign;
}

/// Where multipliers are linear, what lies between two nodes: the mean of both, open where one of them is.
void fill_between(const contact::Setup& setup, NodalValues& v) {
  for (const auto& [a, b, c] : setup.secondary.facets) {
    if (c < 0 || !setup.between(c)) continue;
    for (auto* values : {&v.pressure, &v.shear, &v.slip}) (*values)[c] = 0.5 * ((*values)[a] + (*values)[b]);
    v.status[c] = std::min(v.status[a], v.status[b]) == 0 ? 0 : std::max(v.status[a], v.status[b]);
  }
}

/// Multiplier of a node as it is shown.
Vec2 shown(const contact::Setup& setup, const contact::ContactState& state, int j) {
  const double D = state.reference[j].D, A = setup.secondary.area[j];
  return (D < 0.5 * A ? D / A : 1.0) * state.lambda[j];
}

NodalValues secondary_values(const contact::Setup& setup, const contact::ContactState& state, const std::vector<double>& along) {
  NodalValues v;
  const auto& n = state.normal;  // those that the friction law saw
  for (int j = 0; j < setup.secondary_count(); ++j) {
    const Vec2 lambda = shown(setup, state, j);
    const Vec2 tangent(-n[j].y(), n[j].x());
    v.pressure.push_back(lambda.dot(n[j]));
    v.shear.push_back(-lambda.dot(tangent) * along[j]);
    v.slip.push_back(state.slip[j]);
    v.status.push_back(static_cast<int>(state.status[j]));
  }
  fill_between(setup, v);
  v.slip = at_nodes(setup.secondary, std::move(v.slip));
  return v;
}

NodalValues primary_values(const contact::Setup& setup, const contact::ContactState& state, const std::vector<double>& along) {
  const auto count = static_cast<std::size_t>(setup.primary_count());
  NodalValues v;
  v.pressure.assign(count, 0.0);
  v.shear = v.slip = v.pressure;
  v.status.assign(count, 0);
  std::vector<Vec2> force(count, Vec2::Zero());
  std::vector<double> cover(count, 0.0);
  for (int j = 0; j < setup.secondary_count(); ++j)
    for (const auto& [l, M] : state.reference[j].M) {
      force[l] += M * state.lambda[j];  // the traction on the primary body is +lambda
      if (state.status[j] == ContactStatus::inactive || M <= 0.0) continue;
      v.slip[l] += M * state.slip[j];
      cover[l] += M;
      v.status[l] = std::max(v.status[l], static_cast<int>(state.status[j]));
    }
  const auto n = normals(setup.primary);
  for (std::size_t l = 0; l < count; ++l) {
    const double A = setup.primary.area[l];
    const Vec2 tangent(-n[l].y(), n[l].x());
    v.pressure[l] = -force[l].dot(n[l]) / A;
    v.shear[l] = force[l].dot(tangent) / A * along[l];
    if (cover[l] > 0.0) v.slip[l] /= cover[l];
  }
  return v;
}

/// Rows of one boundary in the order of arc length; `first` is its first node among the side's nodes.
void append(SurfaceRecord& record, const mesh::Mesh& mesh, const mesh::Boundary& boundary, std::size_t first,
            const NodalValues& v, const std::vector<double>& depth) {
  const auto nodes = mesh::nodes_of(boundary);
  const auto arc = mesh::arc_lengths(mesh.X, boundary, mesh::order(mesh.kind));
  std::vector<std::size_t> order(nodes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return arc[a] < arc[b]; });
  const double start = record.arc_length_mm.empty() ? 0.0 : record.arc_length_mm.back();
  for (std::size_t i : order) {
    record.node.push_back(nodes[i]);
    record.arc_length_mm.push_back(start + arc[i]);
    record.x_mm.push_back(mesh.X[nodes[i]].x());
    record.y_mm.push_back(mesh.X[nodes[i]].y());
    record.pressure_MPa.push_back(v.pressure[first + i]);
    record.shear_MPa.push_back(v.shear[first + i]);
    record.slip_mm.push_back(v.slip[first + i]);
    record.wear_depth_mm.push_back(depth[first + i]);
    record.status.push_back(v.status[first + i]);
  }
}

}  // namespace

double peak_pressure(const contact::Setup& setup, const contact::ContactState& state) {
  double peak = 0.0;
  for (int j = 0; j < setup.secondary_count(); ++j)
    if (!setup.between(j)) peak = std::max(peak, shown(setup, state, j).dot(state.normal[j]));
  return peak;
}

std::array<SurfaceRecord, 2> surface_records(const contact::Setup& setup, const contact::ContactState& state,
                                             const std::vector<body::ShapePtr>& shapes, const PlacedContact& placed) {
  const auto boundary = [&](const contact::BoundaryRef& ref) -> const mesh::Boundary& {
    return shapes[ref.body]->mesh.boundaries.at(ref.boundary);
  };
  std::array<SurfaceRecord, 2> records;
  for (auto& record : records) record.contact = setup.options.name;
  records[0].body = placed.secondary.body;
  const auto& mesh = shapes[placed.secondary.body]->mesh;
  append(records[0], mesh, boundary(placed.secondary), 0,
         secondary_values(setup, state, direction(boundary(placed.secondary), mesh.X)),
         depths(setup.secondary, state.removed_secondary));
  records[1].side = Side::primary;
  std::vector<double> along;
  for (const auto& ref : placed.primary) {
    const auto part = direction(boundary(ref), shapes[ref.body]->mesh.X);
    along.insert(along.end(), part.begin(), part.end());
  }
  const auto values = primary_values(setup, state, along);
  const auto depth = depths(setup.primary, state.removed_primary);
  std::size_t first = 0;
  for (const auto& ref : placed.primary) {
    records[1].body = ref.body;
    append(records[1], shapes[ref.body]->mesh, boundary(ref), first, values, depth);
    first += mesh::nodes_of(boundary(ref)).size();
  }
  return records;
}

}  // namespace reye::sim
