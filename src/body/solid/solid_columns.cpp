#include "body/solid/solid_columns.hpp"

#include <algorithm>

#include "body/solid/rigid_modes.hpp"
#include "mesh/solid/solid_measure.hpp"
#include "mesh/solid/solid_shape.hpp"

namespace reye::body {

namespace {

using Demands = std::map<int, NodeDemands>;

bool is_active(const Motion& m) { return m.drive == Drive::free || m.drive == Drive::loaded; }

class SolidNumbering {
 public:
  SolidNumbering(const SolidInput& input, const std::vector<SolidPlace>& places)
      : input_(input), places_(places), demands_(node_demands(input, places)) {}

  SolidColumns number(const std::vector<int>& retained) {
    const int n = input_.mesh->node_count();
    out_.dofs = fem::plain_dofs(n);
    set_control_points();
    list_motions();
    for (const auto& [node, demands] : demands_) set_special(node, demands);
    out_.dofs.own = 0;
    std::vector<char> last(static_cast<size_t>(n), 0);
    for (int node : retained) last[node] = 1;
    for (int node = 0; node < n; ++node)
      if (!last[node]) number_own(node);
    out_.interior = out_.dofs.own;
    for (int node : retained) number_own(node);
    out_.dofs.shared = static_cast<int>(out_.active.size() + out_.prescribed.size());
    return std::move(out_);
  }

 private:
  void set_control_points() {
    out_.points = contact_points(input_);
    for (const auto& facet : contact_facets(input_))
      for (int e = 0; facet.kind == mesh::FacetKind::tri6 && e < 3; ++e) {
        const auto [i, j] = mesh::edge_of(facet.kind, e);
        out_.dofs.between[facet.nodes[3 + e]] = {facet.nodes[i], facet.nodes[j]};
      }
  }

  bool holds_by_node(int s) const {
    return std::any_of(demands_.begin(), demands_.end(), [&](const auto& entry) {
      const auto& [rigid, by_node] = entry.second;
      return rigid.empty() &&
             std::any_of(by_node.begin(), by_node.end(), [&](const auto& demand) { return demand.support == s; });
    });
  }

  void list_motions() {
    for (int s = 0; s < static_cast<int>(places_.size()); ++s) {
      const SolidSupport& support = input_.supports[s];
      for (int m = 0; m < 6 && support.rigid; ++m)
        (is_active(motion_of(support, m)) ? out_.active : out_.prescribed).push_back({s, m, false});
      if (support.rigid || !holds_by_node(s)) continue;
      for (int m : {0, 1, 2, normal_motion}) {
        const Motion& motion = motion_of(support, m);
        if (motion.drive == Drive::moved && !motion.parts.empty()) out_.prescribed.push_back({s, m, false});
      }
      for (int m = 0; m < 6; ++m) out_.prescribed.push_back({s, m, true});
    }
  }

  /// Calls f(shared dof, motion) for the motions of a support.
  template <class F>
  void each_motion(int s, F f) const {
    const int active = static_cast<int>(out_.active.size());
    for (int k = 0; k < active; ++k)
      if (out_.active[k].support == s) f(k, out_.active[k]);
    for (int k = 0; k < static_cast<int>(out_.prescribed.size()); ++k)
      if (out_.prescribed[k].support == s) f(active + k, out_.prescribed[k]);
  }

  void set_special(int node, const NodeDemands& demands) {
    fem::SpecialNode special;
    if (!demands.rigid.empty())
      out_.dofs.count[node] = move_rigidly(node, demands.rigid.front(), special);
    else if (!demands.by_node.empty())
      out_.dofs.count[node] = hold(node, demands.by_node, special);
    else
      return;
    out_.dofs.special[node] = static_cast<int>(out_.dofs.nodes.size());
    out_.dofs.nodes.push_back(std::move(special));
  }

  int move_rigidly(int node, int s, fem::SpecialNode& special) const {
    const SolidSupport& support = input_.supports[s];
    each_motion(s, [&](int dof, const SharedMotion& motion) {
      const Mode row = row_of(support, s, motion.motion, places_[s].centre, places_[s].centre).row;
      special.shared.push_back({dof, modes_at(out_.points[node], places_[s].centre) * row});
    });
    return 0;
  }

  int hold(int node, const std::vector<SolidDemand>& asked, fem::SpecialNode& special) const {
    const std::vector<int> chosen = independent(asked);
    Matrix d(3, static_cast<Eigen::Index>(chosen.size()));
    for (size_t k = 0; k < chosen.size(); ++k) d.col(static_cast<Eigen::Index>(k)) = asked[chosen[k]].direction;
    const Matrix dual = dual_directions(d), left = orthogonal_directions(d);
    special.basis.leftCols(left.cols()) = left;
    for (size_t k = 0; k < chosen.size(); ++k) {
      const SolidDemand& demand = asked[chosen[k]];
      const Vec3 along = dual.col(static_cast<Eigen::Index>(k));
      each_motion(demand.support, [&](int dof, const SharedMotion& motion) {
        if (!motion.probe && motion.motion != demand.motion) return;
        const double share = motion.probe ? demand.direction.dot(probe(node, motion)) : 1.0;
        if (share != 0.0) special.shared.push_back({dof, share * along});
      });
    }
    return static_cast<int>(left.cols());
  }

  /// The rigid motion of a probe at a node.
  Vec3 probe(int node, const SharedMotion& motion) const {
    return modes_at(out_.points[node], places_[motion.support].centre).col(motion.motion);
  }

  void number_own(int node) {
    out_.dofs.first[node] = out_.dofs.own;
    out_.dofs.own += out_.dofs.count[node];
  }

  const SolidInput& input_;
  const std::vector<SolidPlace>& places_;
  Demands demands_;
  SolidColumns out_;
};

}  // namespace

SolidColumns number_columns(const SolidInput& input, const std::vector<SolidPlace>& places,
                            const std::vector<int>& retained) {
  return SolidNumbering(input, places).number(retained);
}

}  // namespace reye::body
