#include "sim/measure/surfaces.hpp"

#include <algorithm>
#include <unordered_map>

#include "mesh/arc.hpp"
#include "sim/measure/nodal_depth.hpp"

namespace reye::sim {

using contact::ContactStatus;

namespace {

/// Traction and slip per node of one side.
struct NodalValues {
  std::vector<double> pressure, shear, slip;
  std::vector<int> status;
};

/// A chain of one side with the surface node of each of its nodes.
struct Row {
  int body = 0;
  const mesh::Mesh* mesh = nullptr;
  mesh::ArcChain chain;
  std::vector<int> surface_node;
};

/// The chains of the boundaries of one side as its table lists them.
std::vector<Row> rows_of(const std::vector<contact::BoundaryRef>& side, const std::vector<body::ShapePtr>& shapes) {
  std::vector<Row> rows;
  int first = 0;
  for (const auto& ref : side) {
    const mesh::Mesh& mesh = shapes[ref.body]->mesh;
    const auto nodes = mesh::nodes_of(mesh.boundaries.at(ref.boundary));
    std::unordered_map<int, int> number;
    for (int node : nodes) number.emplace(node, first + static_cast<int>(number.size()));
    for (auto& chain : mesh::arc_chains(mesh, ref.boundary)) {
      std::vector<int> surface_node;
      for (int node : chain.nodes) surface_node.push_back(number.at(node));
      rows.push_back({ref.body, &mesh, std::move(chain), std::move(surface_node)});
    }
    first += static_cast<int>(nodes.size());
  }
  return rows;
}

/// Per surface node +1 where arc length grows with the body on the left, else -1.
std::vector<double> direction(const std::vector<Row>& rows, int count) {
  std::vector<double> sign(static_cast<std::size_t>(count), 1.0);
  for (const Row& row : rows)
    for (int node : row.surface_node) sign[node] = row.chain.along ? 1.0 : -1.0;
  return sign;
}

/// Where multipliers are linear, the values between two nodes: the mean of both, open where one of them is.
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

NodalValues secondary_values(const contact::Setup& setup, const contact::ContactState& state,
                             const std::vector<double>& along) {
  NodalValues v;
  const auto& n = state.normal;  // normals of the friction law
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

/// Near an end of contact the forces M^T lambda change sign from node to node, as M does, though nothing pulls there:
/// nodes that would show tension are set to zero, and the others are reduced so that the sum stays.
void without_tension(NodalValues& v, const std::vector<double>& area) {
  double force = 0.0, pressing = 0.0;
  for (std::size_t l = 0; l < area.size(); ++l) {
    force += v.pressure[l] * area[l];
    pressing += std::max(v.pressure[l], 0.0) * area[l];
  }
  const double kept = pressing > 0.0 ? std::max(force / pressing, 0.0) : 0.0;
  for (std::size_t l = 0; l < area.size(); ++l) {
    const double factor = v.pressure[l] > 0.0 ? kept : 0.0;
    v.pressure[l] *= factor;
    v.shear[l] *= factor;
  }
}

/// Tractions are those that the secondary side carries, in its own normals and tangents: pressure there is pressure
/// here.
NodalValues primary_values(const contact::Setup& setup, const contact::ContactState& state,
                           const std::vector<double>& along) {
  const auto count = static_cast<std::size_t>(setup.primary_count());
  NodalValues v;
  v.pressure.assign(count, 0.0);
  v.shear = v.slip = v.pressure;
  v.status.assign(count, 0);
  std::vector<double> cover(count, 0.0);
  for (int j = 0; j < setup.secondary_count(); ++j) {
    const Vec2 lambda = state.lambda[j], n = state.normal[j], tangent(-n.y(), n.x());
    for (const auto& [l, M] : state.reference[j].M) {
      v.pressure[l] += M * lambda.dot(n) / setup.primary.area[l];
      v.shear[l] -= M * lambda.dot(tangent) / setup.primary.area[l] * along[l];  // its own tangent runs the other way
      if (state.status[j] == ContactStatus::inactive || M <= 0.0) continue;
      v.slip[l] += M * state.slip[j];
      cover[l] += M;
      v.status[l] = std::max(v.status[l], static_cast<int>(state.status[j]));
    }
  }
  without_tension(v, setup.primary.area);
  for (std::size_t l = 0; l < count; ++l)
    if (cover[l] > 0.0) v.slip[l] /= cover[l];
  return v;
}

/// Adds a chain to the table, its arc length after that of the chains before.
void append(SurfaceRecord& record, const Row& row, const NodalValues& v, const std::vector<double>& depth) {
  const double start = record.arc_length_mm.empty() ? 0.0 : record.arc_length_mm.back();
  for (std::size_t i = 0; i < row.surface_node.size(); ++i) {
    const int node = row.chain.nodes[i];
    const auto j = static_cast<std::size_t>(row.surface_node[i]);
    record.body.push_back(row.body);
    record.node.push_back(node);
    record.body_on_left.push_back(row.chain.along);
    record.arc_length_mm.push_back(start + row.chain.arc[i]);
    record.x_mm.push_back(row.mesh->X[node].x());
    record.y_mm.push_back(row.mesh->X[node].y());
    record.pressure_MPa.push_back(v.pressure[j]);
    record.shear_MPa.push_back(v.shear[j]);
    record.slip_mm.push_back(v.slip[j]);
    record.wear_depth_mm.push_back(depth[j]);
    record.status.push_back(v.status[j]);
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
  std::array<SurfaceRecord, 2> records;
  for (auto& record : records) record.contact = setup.options.name;
  const auto secondary = rows_of({placed.secondary}, shapes), primary = rows_of(placed.primary, shapes);
  const auto upper = secondary_values(setup, state, direction(secondary, setup.secondary_count()));
  for (const Row& row : secondary) append(records[0], row, upper, depths(setup.secondary, state.removed_secondary));
  records[1].side = Side::primary;
  const auto lower = primary_values(setup, state, direction(primary, setup.primary_count()));
  for (const Row& row : primary) append(records[1], row, lower, depths(setup.primary, state.removed_primary));
  return records;
}

}  // namespace reye::sim
