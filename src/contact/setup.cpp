#include "contact/setup.hpp"

#include "contact/fields.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <unordered_map>

namespace reye::contact {

namespace {

std::vector<SurfaceNode> located(int body, const std::vector<int>& mesh_nodes, const body::Operator& op) {
  const auto& retained = body::contact_nodes(op);
  std::unordered_map<int, body::ContactIndex> index;
  for (std::size_t k = 0; k < retained.size(); ++k) index[retained[k]] = body::ContactIndex(k);
  std::vector<SurfaceNode> nodes;
  for (int node : mesh_nodes) nodes.push_back({body, node, index.at(node)});
  return nodes;
}

/// A fifth of the side's extent; where the sides are drawn farther apart, one and a half times that distance, since
/// normals need not point along the shortest way.
double chosen_search(const mortar::Surface& s, double drawn_mm) {
  Eigen::AlignedBox2d box;
  for (const auto& x : s.X) box.extend(x);
  const double usual = 0.2 * box.diagonal().norm();
  return drawn_mm > usual ? 1.5 * drawn_mm : usual;
}

/// A node that a support holds in the direction contact pushes carries no multiplier; nor does a control point where
/// multipliers are linear.
void cut_down(Setup& setup, const std::vector<body::Operator>& operators) {
  const auto& s = setup.secondary;
  for (int j = 0; j < s.node_count(); ++j) {
    const auto& node = setup.secondary_nodes[j];
    const auto freedom = std::visit([&](const auto& o) { return o.freedom(node.contact_node); }, operators[node.body]);
    setup.freedom.push_back(freedom);
    const int facet = s.before[j] >= 0 ? s.before[j] : s.after[j];
    const Vec2 normal = base::right_of(s.X[s.facets[facet][1]] - s.X[s.facets[facet][0]]).normalized();
    const bool held = freedom.free == 0 || (freedom.free == 1 && std::abs(freedom.direction.dot(normal)) < 0.7);
    const bool skipped = setup.options.dual == DualOrder::linear && s.is_control_point(j);
    setup.cut.push_back(held || skipped);
  }
}

}  // namespace

Setup make_setup(const ContactOptions& options, base::Analysis analysis, const BoundaryRef& secondary,
                 const std::vector<BoundaryRef>& primary, const std::vector<body::ShapePtr>& shapes,
                 const std::vector<body::Operator>& operators, double modulus_MPa, base::Kinematics measure) {
  Setup setup;
  setup.options = options;
  setup.analysis = analysis;
  setup.measure = measure;
  std::vector<int> nodes;
  const auto surface_of = [&](const BoundaryRef& ref) {
    const auto& mesh = shapes[ref.body]->mesh;
    return mortar::make_surface(mesh.X, mesh.boundaries.at(ref.boundary), analysis, nodes, mesh::order(mesh.kind));
  };
  setup.secondary = surface_of(secondary);
  setup.secondary_nodes = located(secondary.body, nodes, operators[secondary.body]);
  std::vector<mortar::Surface> parts;
  for (const auto& ref : primary) {
    parts.push_back(surface_of(ref));
    const auto found = located(ref.body, nodes, operators[ref.body]);
    setup.primary_nodes.insert(setup.primary_nodes.end(), found.begin(), found.end());
  }
  setup.primary = mortar::joined(parts);
  setup.search = options.search_mm > 0.0 ? options.search_mm : chosen_search(setup.secondary, options.drawn_mm);
  setup.faint = 1e-30 * modulus_MPa;
  cut_down(setup, operators);
  const auto& s = setup.secondary;
  for (int j = 0; j < s.node_count(); ++j) {
    double h = 0.0;
    for (int facet : {s.before[j], s.after[j]})
      if (facet >= 0) h += 0.5 / s.order * (s.X[s.facets[facet][1]] - s.X[s.facets[facet][0]]).norm();
    setup.length.push_back(h);
    setup.stiffness.push_back(modulus_MPa / h);
  }
  return setup;
}

ContactState fresh_state(const Setup& setup) {
  const auto ns = static_cast<std::size_t>(setup.secondary_count()),
             nm = static_cast<std::size_t>(setup.primary_count());
  ContactState state;
  clear_fields(state, ns, nm, [](const Field&) { return true; });
  return state;
}

}  // namespace reye::contact
