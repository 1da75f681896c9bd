#pragma once
#include <algorithm>

#include "material/parameters.hpp"
#include "solver/newton.hpp"
#include "support/bodies.hpp"
#include "support/meshes.hpp"

/// Bodies in contact built from meshes, with all histories in one factor, for tests of the solver.
namespace reye::support {

struct Touch {
  contact::ContactOptions options;
  contact::BoundaryRef secondary;
  std::vector<contact::BoundaryRef> primary;
};

struct Assembly {
  base::Analysis analysis = base::Analysis::plane_strain;
  std::vector<mesh::Mesh> meshes;
  std::vector<body::BodyInput> inputs;
  std::vector<char> rigid;  ///< per body; may be shorter than the list of bodies
  std::vector<Touch> touches;
  double modulus_MPa = 1000.0;

  bool is_rigid(std::size_t body) const { return body < rigid.size() && rigid[body]; }
};

inline void touch(Assembly& a, const contact::ContactOptions& options, const contact::BoundaryRef& secondary,
                  const contact::BoundaryRef& primary) {
  Touch t;
  t.options = options;
  t.secondary = secondary;
  t.primary.push_back(primary);
  a.touches.push_back(std::move(t));
}

/// Two boundaries in contact, either of them carrying the multipliers.
inline void touch_either(Assembly& a, const contact::ContactOptions& options, bool first_is_secondary,
                         const contact::BoundaryRef& first, const contact::BoundaryRef& second) {
  touch(a, options, first_is_secondary ? first : second, first_is_secondary ? second : first);
}

inline solver::System system_of(Assembly a) {
  for (const auto& t : a.touches) {
    a.inputs[t.secondary.body].contact_boundaries.push_back(t.secondary.boundary);
    for (const auto& p : t.primary) a.inputs[p.body].contact_boundaries.push_back(p.boundary);
  }
  std::vector<body::ShapePtr> shapes;
  std::vector<body::Operator> bodies;
  for (std::size_t b = 0; b < a.meshes.size(); ++b) {
    shapes.push_back(body::make_shape(a.meshes[b]));
    if (a.is_rigid(b))
      bodies.emplace_back(body::RigidBody(shapes[b], a.inputs[b]));
    else if (a.inputs[b].kinematics == base::Kinematics::finite || material::has_history(a.inputs[b].material))
      bodies.emplace_back(body::NonlinearBody(shapes[b], a.inputs[b]));
    else
      bodies.emplace_back(body::LinearBody(shapes[b], a.inputs[b]));
  }
  std::vector<contact::Setup> contacts;
  for (const auto& t : a.touches)
    contacts.push_back(contact::make_setup(t.options, a.analysis, t.secondary, t.primary, shapes, bodies, a.modulus_MPa,
                                           a.inputs[t.secondary.body].kinematics));
  return solver::make_system(std::move(bodies), std::move(contacts));
}

/// Everything that drives the bodies, times `factor`.
inline solver::Controls controls_of(const Assembly& a, const solver::System& system, double factor = 1.0) {
  solver::Controls c;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const auto& columns = std::visit(
        [](const auto& o) -> const auto& { return o.support_columns(); }, system.bodies[b]);
    const auto& loads = std::visit(
        [](const auto& o) -> const auto& { return o.loads(); }, system.bodies[b]);
    for (const auto& column : columns) {
      const auto& m = motion_of(a.inputs[b], column);
      const int at = system.offset[b] + column.column;
      if (m.drive == body::Drive::loaded) c.forces.emplace_back(at, factor * total(m));
      if (m.drive == body::Drive::fixed) c.prescribed.emplace_back(at, 0.0);
      if (m.drive == body::Drive::moved) c.prescribed.emplace_back(at, factor * total(m));
    }
    c.load_factors.push_back(factor * base::Vector::Ones(static_cast<int>(loads.size())));
  }
  c.contacts.resize(system.contacts.size());
  return c;
}

inline solver::SolverState fresh(const solver::System& system) {
  solver::SolverState s;
  s.q = base::Vector::Zero(system.dofs);
  for (const auto& body : system.bodies) {
    const auto* nonlinear = std::get_if<body::NonlinearBody>(&body);
    s.interiors.push_back(nonlinear ? nonlinear->start() : body::Interior{});
  }
  for (const auto& setup : system.contacts) s.contacts.push_back(contact::fresh_state(setup));
  return s;
}

/// The larger of the two relative residuals of an iteration.
inline double residual(const solver::Iteration& row) { return std::max(row.force, row.condition); }

/// Pressure and shear of a secondary node of a state, on the undeformed normals.
inline base::Vec2 traction(const contact::Setup& setup, const contact::ContactState& state, int node) {
  const auto& s = setup.secondary;
  const int facet = s.before[node] >= 0 ? s.before[node] : s.after[node];
  const base::Vec2 t = (s.X[s.facets[facet][1]] - s.X[s.facets[facet][0]]).normalized();
  return {state.lambda[node].dot(base::right_of(t)), state.lambda[node].dot(t)};
}

/// A node-wise support of an edge that holds x or y, in axes turned by `angle_deg`.
inline body::Support guide(const std::string& name, const std::string& edge, char axis,
                           body::Motion motion = {body::Drive::fixed}, double angle_deg = 0.0) {
  body::Support s;
  s.name = name;
  s.edge = edge;
  s.angle_deg = angle_deg;
  (axis == 'x' ? s.x : s.y) = motion;
  return s;
}

/// A support of the node nearest to a point that holds x.
inline body::Support pin(const std::string& name, const base::Vec2& at, body::Motion motion = {body::Drive::fixed},
                         double angle_deg = 0.0) {
  body::Support s = guide(name, "", 'x', motion, angle_deg);
  s.point_mm = at;
  return s;
}

}  // namespace reye::support
