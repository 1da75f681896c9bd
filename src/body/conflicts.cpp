#include "body/conflicts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "base/formatted.hpp"
#include "body/columns.hpp"
#include "body/edges.hpp"
#include "body/imposed.hpp"

namespace reye::body {

namespace {

std::string at(const Vec2& X) { return base::formatted("(%.4g, %.4g)", X.x() + 0.0, X.y() + 0.0); }

/// One direction along which a support holds, moves or loads a node.
struct Demand {
  int support = -1;  ///< -1: the axis of symmetry
  int motion = 0;
  Vec2 direction{1.0, 0.0};
  bool loaded = false;
  Imposed value;
};

/// The motion of a node on a rigid edge along a direction.
struct RigidValue {
  Imposed value;
  std::optional<int> undetermined;  ///< a motion of the edge that is free or loaded and moves the node along it
};

class Search {
 public:
  Search(const mesh::Mesh& mesh, const BodyInput& input)
      : mesh_(mesh), input_(input), axisymmetric_(input.analysis == base::Analysis::axisymmetric) {
    for (const Vec2& X : mesh.X) size_ = std::max(size_, X.cwiseAbs().maxCoeff());
    std::map<int, std::set<int>> supports_at;
    for (int s = 0; s < static_cast<int>(input.supports.size()); ++s) {
      places_.push_back(place_support(mesh, input.supports[s]));
      for (int node : places_.back().nodes) supports_at[node].insert(s);
    }
    for (int s = 0; s < static_cast<int>(places_.size()); ++s) check_turn(s);
    for (const auto& [node, supports] : supports_at) check(node, supports);
  }

  std::vector<SupportConflict> found;

 private:
  const Support& support(int s) const { return input_.supports[s]; }

  void check_turn(int s) {
    const Drive drive = support(s).rotation.drive;
    if (axisymmetric_ && (drive == Drive::moved || drive == Drive::loaded))
      found.push_back({s, "rotation", "an edge cannot turn in axisymmetry"});
  }

  /// Notes one conflict per pair of supports; a refusal takes the place of a warning.
  void note(int s, int other, const std::string& motion, const std::string& text, bool refused) {
    const auto [place, fresh] = pairs_.try_emplace({s, other}, found.size());
    SupportConflict conflict{s, motion, text, refused};
    if (fresh)
      found.push_back(std::move(conflict));
    else if (refused && !found[place->second].refused)
      found[place->second] = std::move(conflict);
  }

  void check(int node, const std::set<int>& supports) {
    std::vector<int> rigid, by_node;
    for (int s : supports) (places_[s].rigid ? rigid : by_node).push_back(s);
    if (rigid.empty()) return check_by_node(node, by_node);
    for (std::size_t k = 1; k < rigid.size(); ++k)
      if (!all_fixed(rigid.front()) || !all_fixed(rigid[k]))
        note(rigid[k], rigid.front(), "",
             "shares the node at " + at(mesh_.X[node]) + " with support " + base::quoted(support(rigid.front()).name) +
                 ", and both are rigid edges; name what moves as one in one boundary, and say in one "
                 "support how it moves",
             true);
    if (on_axis(node)) check_axis(node, rigid.front());
    for (int s : by_node) check_on_rigid(node, s, rigid.front());
  }

  bool all_fixed(int s) const {
    const Support& own = support(s);
    return own.x.drive == Drive::fixed && own.y.drive == Drive::fixed &&
           (axisymmetric_ || own.rotation.drive == Drive::fixed);
  }

  bool on_axis(int node) const { return axisymmetric_ && std::abs(mesh_.X[node].x()) <= 1e-9 * size_; }

  void check_axis(int node, int s) {
    for (int m : {0, 1}) {
      const Motion& motion = motion_of(support(s), m);
      const auto& axis = m == 0 ? places_[s].x_axis : places_[s].y_axis;
      const bool acts = motion.drive == Drive::loaded || motion.drive == Drive::moved;
      if (acts && nonzero(motion) && std::abs(axis.front().x()) > parallel)
        note(s, -1, motion_names[m],
             "the edge runs to the axis of symmetry at " + at(mesh_.X[node]) + ", where nothing moves along x", true);
    }
  }

  std::vector<Demand> demands(int node, int s) const {
    std::vector<Demand> list;
    const auto& nodes = places_[s].nodes;
    const auto k = static_cast<std::size_t>(std::find(nodes.begin(), nodes.end(), node) - nodes.begin());
    for (int m : {0, 1}) {
      const Motion& motion = motion_of(support(s), m);
      if (motion.drive == Drive::free) continue;
      Demand demand{s, m, (m == 0 ? places_[s].x_axis : places_[s].y_axis)[k], motion.drive == Drive::loaded, {}};
      add(demand.value, motion, 1.0);
      list.push_back(std::move(demand));
    }
    return list;
  }

  /// The first two independent directions of a node stand; every other must follow from them.
  void check_by_node(int node, const std::vector<int>& supports) {
    std::vector<Demand> standing;
    if (on_axis(node)) standing.push_back({});
    for (int s : supports)
      for (auto& demand : demands(node, s)) {
        const auto independent = [&](const Demand& other) {
          return std::abs(base::cross(other.direction, demand.direction)) >= parallel;
        };
        if (standing.empty() || (standing.size() == 1 && independent(standing.front())))
          standing.push_back(std::move(demand));
        else
          check_against(node, standing, demand);
      }
  }

  void check_against(int node, const std::vector<Demand>& standing, const Demand& demand) {
    const auto same_line = std::find_if(standing.begin(), standing.end(), [&](const Demand& other) {
      return std::abs(base::cross(other.direction, demand.direction)) < parallel;
    });
    Imposed expected;
    bool loaded = demand.loaded;
    if (same_line != standing.end()) {
      add(expected, same_line->value, same_line->direction.dot(demand.direction));
      loaded = loaded || same_line->loaded;
    } else {
      const auto& [a, b] = std::array{standing[0], standing[1]};
      const double area = base::cross(a.direction, b.direction);
      add(expected, a.value, base::cross(demand.direction, b.direction) / area);
      add(expected, b.value, base::cross(a.direction, demand.direction) / area);
      loaded = loaded || a.loaded || b.loaded;
    }
    if (!loaded && same(expected, demand.value)) return;
    const Demand& other = same_line != standing.end() ? *same_line : standing.back();
    const std::string who =
        other.support < 0 ? "the axis of symmetry" : "support " + base::quoted(support(other.support).name);
    note(demand.support, other.support, motion_names[demand.motion],
         "asks of the node at " + at(mesh_.X[node]) + " another motion than " + who +
             " does; a place can be held, moved or "
             "loaded along a direction once",
         true);
  }

  RigidValue along(const Vec2& direction, int node, int s) const {
    const SupportPlace& place = places_[s];
    const Vec2 arm = mesh_.X[node] - place.centre;
    double length = 0.0;
    for (int other : place.nodes) length = std::max(length, (mesh_.X[other] - place.centre).norm());
    const std::array<double, 3> weights{place.x_axis.front().dot(direction), place.y_axis.front().dot(direction),
                                        axisymmetric_ ? 0.0 : base::cross(arm, direction)};
    RigidValue result;
    for (int m = 0; m < 3; ++m) {
      const Motion& motion = motion_of(support(s), m);
      if (std::abs(weights[m]) <= parallel * (m == 2 ? length : 1.0)) continue;
      if (motion.drive == Drive::free || motion.drive == Drive::loaded) {
        result.undetermined = m;
        if (motion.drive == Drive::loaded) return result;
      }
      add(result.value, motion, weights[m]);
    }
    return result;
  }

  /// A node of a rigid edge moves with it wholly: another support may only prescribe the motion of the edge.
  void check_on_rigid(int node, int s, int edge) {
    const auto& own = places_[s].nodes;
    const auto& of_edge = places_[edge].nodes;
    const bool nothing_left = std::all_of(
        own.begin(), own.end(), [&](int n) { return std::find(of_edge.begin(), of_edge.end(), n) != of_edge.end(); });
    const std::string where = "the node at " + at(mesh_.X[node]) + " moves with the rigid edge of support " +
                              base::quoted(support(edge).name);
    for (const Demand& demand : demands(node, s)) {
      const RigidValue edge_value = along(demand.direction, node, edge);
      if (!edge_value.undetermined && !demand.loaded && same(edge_value.value, demand.value)) continue;
      const int m = edge_value.undetermined.value_or(-1);
      const bool pushed = m >= 0 && motion_of(support(edge), m).drive == Drive::loaded;
      const std::string free =
          m < 0 ? "" : ", whose " + std::string(motion_names[m]) + " is " + (pushed ? "loaded" : "free");
      note(s, edge, motion_names[demand.motion],
           where + free + ", and not as support " + base::quoted(support(s).name) +
               " asks; say it in the support of the rigid edge",
           m < 0 || pushed || demand.loaded || nothing_left);
    }
  }

  const mesh::Mesh& mesh_;
  const BodyInput& input_;
  bool axisymmetric_;
  double size_ = 0.0;  ///< largest coordinate
  std::vector<SupportPlace> places_;
  std::map<std::pair<int, int>, std::size_t> pairs_;
};

}  // namespace

std::vector<SupportConflict> support_conflicts(const mesh::Mesh& mesh, const BodyInput& input) {
  return Search(mesh, input).found;
}

}  // namespace reye::body
