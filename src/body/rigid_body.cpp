#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/errors.hpp"
#include "body/edges.hpp"
#include "body/operator.hpp"
#include "body/resultant.hpp"
#include "body/turning.hpp"
#include "fem/places.hpp"

namespace reye::body {

using Rotation = Eigen::Matrix2d;

namespace {

double contract(const Eigen::Matrix2d& a, const Eigen::Matrix2d& b) { return a.cwiseProduct(b).sum(); }

/// All supports of a rigid body act along its own axes; edges count as rigid lines.
std::vector<SupportPlace> place_all(const mesh::Mesh& mesh, const std::vector<Support>& supports) {
  std::vector<SupportPlace> places;
  for (Support support : supports) {
    if (!support.point_mm) support.rigid = true;
    places.push_back(place_support(mesh, support));
  }
  return places;
}

}  // namespace

struct RigidBody::Impl {
  ShapePtr shape;
  bool axisymmetric = false;
  Vec2 centre{0.0, 0.0};
  std::array<Vec2, 2> axes{Vec2{1.0, 0.0}, Vec2{0.0, 1.0}};
  std::array<bool, 3> held{};  ///< by the body itself, at zero
  std::vector<int> contact_nodes;
  base::Points contact_X;  ///< contact nodes, control points in place of mid nodes
  std::vector<SupportColumn> supports;
  std::vector<LoadColumn> names;
  std::vector<Resultant> loads;

  Impl(ShapePtr s, const BodyInput& input)
      : shape(std::move(s)), axisymmetric(input.analysis == base::Analysis::axisymmetric) {
    held = {axisymmetric, false, axisymmetric};
    set_supports(input);
    for (const auto& name : input.contact_boundaries)
      for (int node : mesh::nodes_of(fem::boundary_of(shape->mesh, name, "body." + input.name + ".contact")))
        if (std::find(contact_nodes.begin(), contact_nodes.end(), node) == contact_nodes.end())
          contact_nodes.push_back(node);
    const auto points = mesh::control_points(curved_edges(shape->mesh, input.contact_boundaries), shape->mesh.X);
    for (int node : contact_nodes) contact_X.push_back(points[node]);
    for_each_load(input, [&](const auto& load) {
      names.push_back({load.name, load.history});
      loads.push_back(resultant(shape->mesh, input.analysis, load, centre));
    });
  }

  void set_supports(const BodyInput& input) {
    const auto places = place_all(shape->mesh, input.supports);
    centre = places.empty() ? box_centre(shape->mesh) : places.front().centre;
    if (!places.empty() && !axisymmetric) axes = {places.front().x_axis.front(), places.front().y_axis.front()};
    // Held, moved and loaded motions come first; free ones of rigid edges get a column only where nothing else acts.
    for (bool idle : {false, true})
      for (int s = 0; s < static_cast<int>(places.size()); ++s) add_columns(s, input.supports[s], places[s], idle);
    for (size_t s = 0; s < places.size(); ++s)
      if (!is_rigid(input.supports[s]) && holds_rotation(shape->mesh, input.supports[s], places[s])) held[2] = true;
  }

  void add_columns(int s, const Support& support, const SupportPlace& place, bool idle) {
    const std::array<const Motion*, 3> motions{&support.x, &support.y, &support.rotation};
    for (int m = 0; m < 3; ++m) {
      if ((motions[m]->drive == Drive::free) != idle || (idle && !is_rigid(support))) continue;
      const Vec2 direction = m == 0 ? place.x_axis.front() : m == 1 ? place.y_axis.front() : Vec2{0.0, 0.0};
      const int column = m == 2 ? 2 : column_along(direction, support);
      if (held[column]) continue;
      const auto taken = [&](const SupportColumn& c) { return c.column == column; };
      if (std::any_of(supports.begin(), supports.end(), taken)) continue;
      supports.push_back({s, m, column, direction});
    }
  }

  int column_along(const Vec2& direction, const Support& support) const {
    for (int k : {0, 1})
      if ((axes[k] - direction).norm() < 1e-9) return k;
    throw base::InputError({{"support." + support.name + ".angle_deg", "",
                             "all supports of a rigid body must have the same axes (x and y in axisymmetry)"}});
  }

  Vec2 translation(const Vector& q) const {
    return (held[0] ? 0.0 : q[0]) * axes[0] + (held[1] ? 0.0 : q[1]) * axes[1];
  }
  double angle(const Vector& q) const { return held[2] ? 0.0 : q[2]; }
  Vec2 current(const Vec2& X, const Vector& q) const {
    return centre + translation(q) + rotation(angle(q)) * (X - centre);
  }
};

RigidBody::RigidBody(ShapePtr shape, const BodyInput& input)
    : impl_(std::make_shared<const Impl>(std::move(shape), input)) {}

const std::vector<int>& RigidBody::contact_nodes() const { return impl_->contact_nodes; }
const std::vector<SupportColumn>& RigidBody::support_columns() const { return impl_->supports; }
const std::vector<LoadColumn>& RigidBody::loads() const { return impl_->names; }
/// No node can move by itself under a multiplier.
NodeFreedom RigidBody::freedom(ContactIndex) const { return {0, {0.0, 0.0}}; }

NodePosition RigidBody::position(ContactIndex node, const Vector& q) const {
  const Vec2& X = impl_->contact_X[static_cast<std::size_t>(node)];
  NodePosition p;
  p.x = impl_->current(X, q);
  const Vec2 turning = rotation_rate(impl_->angle(q)) * (X - impl_->centre);
  const std::array<Vec2, 3> directions{impl_->axes[0], impl_->axes[1], turning};
  for (int k = 0; k < 3; ++k)
    if (!impl_->held[k]) p.terms[p.count++] = {k, directions[k]};
  return p;
}

Vector RigidBody::residual(const Vector& q, const Vector& load_factors) const {
  Vector r = Vector::Zero(3);
  const Rotation rate = rotation_rate(impl_->angle(q));
  for (size_t i = 0; i < impl_->loads.size(); ++i) {
    const Resultant& load = impl_->loads[i];
    for (int k : {0, 1}) r[k] -= load_factors[i] * load.force.dot(impl_->axes[k]);
    r[2] -= load_factors[i] * contract(rate, load.spread);
  }
  for (int k = 0; k < 3; ++k)
    if (impl_->held[k]) r[k] = q[k];
  return r;
}

Matrix RigidBody::tangent(const Vector& q, const Vector& load_factors) const {
  Matrix K = Matrix::Zero(3, 3);
  const Rotation R = rotation(impl_->angle(q));  // d^2 R / d theta^2 = -R
  for (Eigen::Index i = 0; i < load_factors.size(); ++i)
    K(2, 2) += load_factors[i] * contract(R, impl_->loads[i].spread);
  for (int k = 0; k < 3; ++k)
    if (impl_->held[k]) K(k, k) = 1.0;
  return K;
}

std::vector<Vec2> RigidBody::recover(const Vector& q, const Vector&) const {
  std::vector<Vec2> u;
  for (const Vec2& X : impl_->shape->mesh.X) u.push_back(impl_->current(X, q) - X);
  return u;
}

double RigidBody::geometric(const Vector& q, const std::vector<Vec2>& contact_forces) const {
  if (impl_->held[2]) return 0.0;
  const Rotation R = rotation(q[2]);
  double sum = 0.0;
  for (size_t k = 0; k < impl_->contact_nodes.size(); ++k)
    sum -= contact_forces[k].dot(R * (impl_->contact_X[k] - impl_->centre));
  return sum;
}

}  // namespace reye::body
