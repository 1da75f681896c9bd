#include "body/columns.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "body/edges.hpp"
#include "fem/places.hpp"

namespace reye::body {

using mesh::Mesh;

namespace {

constexpr int no_column = -1;  // a motion held at zero without a column

/// One held direction of a node; `group` is the support column it belongs to.
struct Hold {
  Vec2 direction;
  int group = no_column;
};

/// Constraints of one node: on a rigid edge (place >= 0), else up to two holds.
struct Constraint {
  int rigid = -1;
  std::vector<Hold> holds;
  bool on_axis = false;
};

/// A support column before numbering. Columns that no node ends up using are dropped.
struct Group {
  SupportColumn column;
  bool used = false;
};

/// The weighted sum of displacements, one term per column.
std::vector<Term> merged(std::initializer_list<std::pair<double, const std::vector<Term>*>> parts) {
  std::vector<Term> sum;
  for (const auto& [weight, terms] : parts)
    for (const Term& term : *terms) {
      const auto same = std::find_if(sum.begin(), sum.end(), [&](const Term& t) { return t.column == term.column; });
      if (same == sum.end())
        sum.push_back({term.column, weight * term.direction});
      else
        same->direction += weight * term.direction;
    }
  return sum;
}

class Numbering {
 public:
  Numbering(const Mesh& mesh, const BodyInput& input, const std::vector<int>& retained)
      : mesh_(mesh),
        input_(input),
        retained_(retained),
        edges_(curved_edges(mesh, input.contact_boundaries)),
        points_(mesh::control_points(edges_, mesh.X)),
        constraints_(mesh.X.size()),
        first_group_(input.supports.size(), 0) {
    for (const Support& support : input.supports) places_.push_back(place_support(mesh, support));
    hold_axis();
    for (int s = 0; s < support_count(); ++s)
      if (places_[s].rigid) attach_rigid(s);
    for (int s = 0; s < support_count(); ++s)
      if (!places_[s].rigid) attach_by_node(s);
  }

  Columns result() {
    Columns c;
    std::vector<char> listed(mesh_.X.size(), 0);
    for (const auto& name : input_.contact_boundaries)
      for (int node : mesh::nodes_of(mesh_.boundaries.at(name)))
        if (!std::exchange(listed[node], 1)) c.contact_nodes.push_back(node);
    c.contact_nodes.insert(c.contact_nodes.end(), retained_.begin(), retained_.end());
    number(c);
    for (int node = 0; node < mesh_.node_count(); ++node) c.terms.push_back(terms_of(node));
    for (int node : c.contact_nodes) c.seen.push_back({points_[node], c.terms[node], freedom_of(node)});
    for (const auto& [a, b, mid] : edges_)
      c.terms[mid] = merged({{0.25, &c.terms[a]}, {0.25, &c.terms[b]}, {0.5, &c.terms[mid]}});  // (7)
    c.curved_edges = edges_;
    return c;
  }

 private:
  int support_count() const { return static_cast<int>(places_.size()); }

  void hold_axis() {
    if (input_.analysis != base::Analysis::axisymmetric) return;
    double size = 0.0;
    for (const Vec2& X : mesh_.X) size = std::max(size, X.cwiseAbs().maxCoeff());
    for (int node = 0; node < mesh_.node_count(); ++node)
      if (std::abs(mesh_.X[node].x()) <= 1e-9 * size) {
        constraints_[node].on_axis = true;
        constraints_[node].holds.push_back({Vec2{1.0, 0.0}, no_column});
      }
  }

  int add_group(int support, int motion, const Vec2& direction) {
    groups_.push_back({{support, motion, -1, direction}, false});
    return static_cast<int>(groups_.size()) - 1;
  }

  void attach_rigid(int s) {
    const SupportPlace& place = places_[s];
    first_group_[s] = add_group(s, 0, place.x_axis.front());
    add_group(s, 1, place.y_axis.front());
    if (!axisymmetric()) add_group(s, 2, Vec2::Zero());
    for (int node : place.nodes) {
      if (constraints_[node].rigid >= 0) continue;
      constraints_[node].rigid = s;
      for (int m = 0; m < rigid_motions(); ++m) groups_[first_group_[s] + m].used = true;
    }
  }

  void attach_by_node(int s) {
    const SupportPlace& place = places_[s];
    for (int motion : {0, 1}) {
      const Motion& drive = motion == 0 ? input_.supports[s].x : input_.supports[s].y;
      if (drive.drive == Drive::free) continue;
      const auto& axis = motion == 0 ? place.x_axis : place.y_axis;
      const bool shared = place.straight();
      int group = shared ? add_group(s, motion, axis.front()) : no_column;
      for (size_t k = 0; k < place.nodes.size(); ++k) {
        if (!shared) group = add_group(s, motion, axis[k]);
        try_hold(constraints_[place.nodes[k]], {axis[k], group});
      }
    }
  }

  void try_hold(Constraint& c, const Hold& hold) {
    if (c.rigid >= 0 || c.holds.size() == 2) return;
    if (!c.holds.empty() && std::abs(base::cross(c.holds.front().direction, hold.direction)) < parallel) return;
    c.holds.push_back(hold);
    groups_[hold.group].used = true;
  }

  int free_count(int node) const {
    const Constraint& c = constraints_[node];
    return c.rigid >= 0 ? 0 : 2 - static_cast<int>(c.holds.size());
  }

  void number(Columns& c) {
    std::vector<char> in_contact(mesh_.X.size(), 0);
    for (int node : c.contact_nodes) in_contact[node] = 1;
    first_free_.assign(mesh_.X.size(), -1);
    int next = 0;
    const auto give = [&](int node) {
      first_free_[node] = next;
      next += free_count(node);
    };
    for (int node = 0; node < mesh_.node_count(); ++node)
      if (!in_contact[node]) give(node);
    c.interior = interior_ = next;
    for (int node : c.contact_nodes) give(node);
    for (Group& group : groups_) {
      if (!group.used) continue;
      group.column.column = next++ - c.interior;
      c.supports.push_back(group.column);
    }
    c.retained = next - c.interior;
  }

  std::vector<Term> terms_of(int node) const {
    const Constraint& c = constraints_[node];
    if (c.rigid >= 0) return rigid_terms(node);
    const int free = first_free_[node];
    if (c.holds.empty()) return {{free, {1.0, 0.0}}, {free + 1, {0.0, 1.0}}};
    const Vec2 d = c.holds[0].direction;
    const Vec2 other = c.holds.size() == 2 ? c.holds[1].direction : free_direction(d);
    // Columns of [d^T; other^T]^-1, in closed form.
    const double area = base::cross(d, other);
    std::vector<Term> terms;
    add_support_term(terms, c.holds[0].group, Vec2{other.y(), -other.x()} / area);
    const Vec2 second = Vec2{-d.y(), d.x()} / area;
    if (c.holds.size() == 2)
      add_support_term(terms, c.holds[1].group, second);
    else
      terms.push_back({free, second});
    return terms;
  }

  std::vector<Term> rigid_terms(int node) const {
    const Constraint& c = constraints_[node];
    const SupportPlace& place = places_[c.rigid];
    const Vec2 arm = points_[node] - place.centre;
    std::vector<Term> terms;
    for (int m = 0; m < rigid_motions(); ++m) {
      Vec2 direction = m == 0 ? place.x_axis.front() : m == 1 ? place.y_axis.front() : Vec2{-arm.y(), arm.x()};
      if (c.on_axis) direction.x() = 0.0;  // no node leaves the axis of symmetry
      add_support_term(terms, first_group_[c.rigid] + m, direction);
    }
    return terms;
  }

  void add_support_term(std::vector<Term>& terms, int group, const Vec2& direction) const {
    if (group != no_column) terms.push_back({interior_ + groups_[group].column.column, direction});
  }

  NodeFreedom freedom_of(int node) const {
    const int free = free_count(node);
    return {free, free == 1 ? free_direction(constraints_[node].holds[0].direction) : Vec2{0.0, 0.0}};
  }

  static Vec2 free_direction(const Vec2& held) { return {-held.y(), held.x()}; }
  bool axisymmetric() const { return input_.analysis == base::Analysis::axisymmetric; }
  int rigid_motions() const { return axisymmetric() ? 2 : 3; }  // an axisymmetric edge cannot turn

  const Mesh& mesh_;
  const BodyInput& input_;
  const std::vector<int>& retained_;
  std::vector<mesh::LineFacet> edges_;
  base::Points points_;  ///< of nodes, control points in place of mid nodes on contact boundaries
  std::vector<SupportPlace> places_;
  std::vector<Constraint> constraints_;
  std::vector<Group> groups_;
  std::vector<int> first_group_;  ///< of each rigid support
  std::vector<int> first_free_;   ///< of each node
  int interior_ = 0;
};

}  // namespace

base::SparseMatrix Columns::expansion() const {
  std::vector<base::Triplet> entries;
  for (size_t node = 0; node < terms.size(); ++node)
    for (const Term& term : terms[node])
      for (int i = 0; i < 2; ++i)
        if (term.direction[i] != 0.0) entries.emplace_back(2 * node + i, term.column, term.direction[i]);
  base::SparseMatrix B(2 * static_cast<Eigen::Index>(terms.size()), interior + retained);
  B.setFromTriplets(entries.begin(), entries.end());
  return B;
}

Matrix Columns::translations(base::Analysis analysis) const {
  Matrix T = Matrix::Zero(interior + retained, 2);
  for (const auto& node : terms)
    for (const Term& term : node) T.row(term.column) = term.direction;
  for (const ContactNode& node : seen)
    for (const Term& term : node.terms) T.row(term.column) = term.direction;
  for (const SupportColumn& support : supports) T.row(interior + support.column) = support.direction;
  if (analysis == base::Analysis::axisymmetric) T.col(0).setZero();
  return T;
}

bool Columns::turns(int column) const {
  const auto turning = [&](const SupportColumn& s) { return s.motion == 2 && s.column == column - interior; };
  return column >= interior && std::any_of(supports.begin(), supports.end(), turning);
}

Path Columns::path(const Term& term, double value, bool true_rotation) const {
  const Vec2& d = term.direction;
  if (!true_rotation || !turns(term.column)) return {value * d, d, Vec2{0.0, 0.0}};
  const Vec2 across{-d.y(), d.x()};
  const double c = std::cos(value), s = std::sin(value);
  return {s * d + (1.0 - c) * across, c * d + s * across, c * across - s * d};
}

Columns number_columns(const Mesh& mesh, const BodyInput& input, const std::vector<int>& retained) {
  for (const auto& name : input.contact_boundaries) fem::boundary_of(mesh, name, "body." + input.name + ".contact");
  return Numbering(mesh, input, retained).result();
}

}  // namespace reye::body
