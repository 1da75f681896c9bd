#include "body/edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "base/errors.hpp"
#include "fem/places.hpp"
#include "mesh/facet.hpp"
#include "mesh/quadratic_edge.hpp"

namespace reye::body {

using base::Vec2;
using mesh::Boundary;
using mesh::Mesh;

namespace {

/// Calls visit(first node, second node) for every facet of the boundary.
template <class Visit>
void for_each_facet(const Boundary& boundary, Visit visit) {
  for (const auto& chain : boundary)
    for (size_t k = 0; k + 1 < chain.size(); ++k) visit(chain[k], chain[k + 1]);
}

/// Calls visit(edge, its three nodes) for every facet of second order.
template <class Visit>
void for_each_quadratic_facet(const Mesh& mesh, const Boundary& boundary, Visit visit) {
  for (const auto& chain : boundary)
    for (size_t k = 0; k + 2 < chain.size(); k += 2) {
      const std::array<int, 3> nodes{chain[k], chain[k + 1], chain[k + 2]};
      visit(mesh::QuadraticEdge{mesh.X[nodes[0]], mesh.X[nodes[1]], mesh.X[nodes[2]]}, nodes);
    }
}

Vec2 centroid(const Mesh& mesh, const Boundary& boundary) {
  Vec2 sum{0.0, 0.0};
  double total = 0.0;
  if (mesh::order(mesh.kind) == 2) {
    for_each_quadratic_facet(mesh, boundary, [&](const mesh::QuadraticEdge& edge, const auto&) {
      for (const auto& [xi, weight] : mesh::gauss5) {
        const double ds = weight * edge.tangent(xi).norm();
        sum += ds * edge.at(xi);
        total += ds;
      }
    });
    return sum / total;
  }
  for_each_facet(boundary, [&](int a, int b) {
    const double h = (mesh.X[b] - mesh.X[a]).norm();
    sum += 0.5 * h * (mesh.X[a] + mesh.X[b]);
    total += h;
  });
  return sum / total;
}

/// Tangent at every node: the mean of the unit tangents of its facets there, or that of the whole edge when rigid.
std::vector<Vec2> tangents(const Mesh& mesh, const Boundary& boundary, const SupportPlace& place) {
  std::map<int, Vec2> at_node;
  Vec2 whole{0.0, 0.0};
  const auto add = [&](int node, const Vec2& tangent) {
    at_node.try_emplace(node, Vec2::Zero()).first->second += tangent.normalized();
  };
  if (mesh::order(mesh.kind) == 1)
    for_each_facet(boundary, [&](int a, int b) {
      const Vec2 chord = mesh.X[b] - mesh.X[a];
      for (int node : {a, b}) add(node, chord);
      whole += chord;
    });
  else
    for_each_quadratic_facet(mesh, boundary, [&](const mesh::QuadraticEdge& edge, const std::array<int, 3>& nodes) {
      for (int j = 0; j < 3; ++j) add(nodes[j], edge.tangent(j - 1.0));
      whole += edge.last - edge.first;
    });
  std::vector<Vec2> result;
  for (int node : place.nodes) result.push_back((place.rigid ? whole : at_node.at(node)).normalized());
  return result;
}

void set_turned_axes(SupportPlace& place, double angle_deg) {
  const double angle = angle_deg * std::numbers::pi / 180.0;
  const bool turned = angle_deg != 0.0;  // keeps x and y free of round-off
  const Vec2 x = turned ? Vec2{std::cos(angle), std::sin(angle)} : Vec2{1.0, 0.0};
  place.x_axis.assign(place.nodes.size(), x);
  place.y_axis.assign(place.nodes.size(), Vec2{-x.y(), x.x()});
}

SupportPlace place_at_point(const Mesh& mesh, const Support& support) {
  if (support.rotation.drive != Drive::free)
    throw base::InputError({{"support." + support.name + ".rotation", "", "a point has no rotation; support an edge"}});
  SupportPlace place;
  place.nodes = {fem::nearest_node(mesh, *support.point_mm)};
  place.centre = mesh.X[place.nodes.front()];
  set_turned_axes(place, support.angle_deg);
  return place;
}

}  // namespace

bool is_rigid(const Support& s) {
  if (s.point_mm) return false;
  return s.rigid || s.rotation.drive != Drive::free || s.x.drive == Drive::loaded || s.y.drive == Drive::loaded;
}

bool SupportPlace::straight() const {
  for (const Vec2& axis : x_axis)
    if ((axis - x_axis.front()).norm() > 1e-9) return false;
  return true;
}

SupportPlace place_support(const Mesh& mesh, const Support& support) {
  if (support.point_mm) return place_at_point(mesh, support);
  const Boundary& boundary = fem::boundary_of(mesh, support.edge, "support." + support.name + ".edge");
  SupportPlace place;
  place.rigid = is_rigid(support);
  place.nodes = mesh::nodes_of(boundary);
  place.centre = centroid(mesh, boundary);
  set_turned_axes(place, support.angle_deg);
  if (!support.edge_axes) return place;
  place.x_axis = tangents(mesh, boundary, place);
  for (size_t k = 0; k < place.nodes.size(); ++k) place.y_axis[k] = base::right_of(place.x_axis[k]);
  return place;
}

bool holds_rotation(const Mesh& mesh, const Support& support, const SupportPlace& place) {
  const Vec2& origin = mesh.X[place.nodes.front()];
  double size = 0.0;
  for (const Vec2& X : mesh.X) size = std::max(size, (X - origin).norm());
  const auto holds = [&](const Motion& m, const Vec2& d) {
    if (m.drive != Drive::fixed && m.drive != Drive::moved) return false;
    double low = 0.0, high = 0.0;
    for (int node : place.nodes) {
      const double lever = base::cross(mesh.X[node] - origin, d);
      low = std::min(low, lever);
      high = std::max(high, lever);
    }
    return high - low > 1e-9 * size;
  };
  return holds(support.x, place.x_axis.front()) || holds(support.y, place.y_axis.front());
}

}  // namespace reye::body
