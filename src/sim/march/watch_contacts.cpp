#include "sim/march/watch_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "sim/measure/roundness.hpp"
#include "sim/measure/sides.hpp"
#include "sim/measure/warn_contact.hpp"

namespace reye::sim {

namespace {

/// Continuation of the outline of a body where a contact's boundary ends.
enum class Beyond { corner, another_contact, smooth };

constexpr double harder = 1.001;        ///< a constant force is evaluated once a block
constexpr double smooth_cosine = 0.94;  ///< cosine of the 20 degrees below which an outline continues smoothly

Beyond beyond(const Problem& problem, const State& state, const contact::SurfaceNode& end) {
  const auto& mesh = state.shapes[end.body]->mesh;
  std::set<int> in_contact;
  for (const auto& name : problem.inputs[end.body].contact_boundaries) {
    const auto nodes = mesh::nodes_of(mesh.boundaries.at(name));
    in_contact.insert(nodes.begin(), nodes.end());
  }
  for (const auto& loop : mesh.outline)
    for (std::size_t k = 0; k + 1 < loop.size(); ++k) {
      if (loop[k] != end.mesh_node) continue;
      const int before = loop[k == 0 ? loop.size() - 2 : k - 1], after = loop[k + 1];
      const Vec2 a = (mesh.X[loop[k]] - mesh.X[before]).normalized(),
                 b = (mesh.X[after] - mesh.X[loop[k]]).normalized();
      if (a.dot(b) < smooth_cosine) return Beyond::corner;
      return in_contact.contains(before) && in_contact.contains(after) ? Beyond::another_contact : Beyond::smooth;
    }
  return Beyond::corner;
}

bool ends(const mortar::Surface& s, int node) { return s.before[node] < 0 || s.after[node] < 0; }

/// One observation of a contact.
class Look {
 public:
  Look(const Problem& problem, const State& state, const solver::System& system, std::size_t c)
      : problem_(problem),
        state_(state),
        placed_(problem.contacts[c]),
        setup_(system.contacts[c]),
        contact_(state.solution.contacts[c]),
        met_(setup_.primary.X.size(), 0) {}

  double force() const {
    double sum = 0.0;
    for (int j = 0; j < setup_.secondary_count(); ++j) sum += force_at(j);
    return sum;
  }

  int slipped() const {
    return static_cast<int>(std::count(contact_.status.begin(), contact_.status.end(), contact::ContactStatus::slip));
  }

  Pressed pressed(double force) {
    Pressed p;
    p.force = force;
    for (int j = 1; j < setup_.secondary_count(); ++j)
      if (pressure(j) > pressure(peak_)) peak_ = j;
    p.peak_mm = setup_.secondary.X[peak_].x();
    p.size_mm = p.length_mm = spacing(setup_.secondary, peak_);  // a node at each end counts for half a facet
    walk(p);
    p.beside_zone = beside_zone(force);
    if (contact_.law_volume == 0.0) p.facets_mm = facets();
    return p;
  }

 private:
  double force_at(int j) const { return contact_.reference[j].carried() * contact_.lambda[j].dot(contact_.normal[j]); }
  double pressure(int j) const { return force_at(j) / setup_.secondary.area[j]; }
  bool loaded(int j) const { return contact_.status[j] != contact::ContactStatus::inactive && force_at(j) > 0.0; }

  int facet(int j, int way) const { return way > 0 ? setup_.secondary.after[j] : setup_.secondary.before[j]; }
  int next(int f, int way) const { return setup_.secondary.facets[f][way > 0 ? 1 : 0]; }

  /// The next node of the loaded run, over a single open or cut one; -1: the run ends here.
  int step(int j, int way) const {
    const int f = facet(j, way);
    if (f < 0) return -1;
    const int to = next(f, way);
    if (loaded(to)) return to;
    const int g = facet(to, way);
    return g >= 0 && loaded(next(g, way)) ? to : -1;
  }

  void meet(int j) {
    run_.push_back(j);
    for (const auto& [l, M] : contact_.reference[j].M)
      if (M != 0.0) met_[l] = 1;
  }

  int peak_vertex() const {
    const auto& s = setup_.secondary;
    return s.is_control_point(peak_) ? s.facets[s.before[peak_]][0] : peak_;
  }

  /// Walks over the loaded nodes from `start` on; the last of them, -1 where they make a ring.
  int walk_to_end(int start, int way, double& intervals, Pressed& p) {
    const auto& s = setup_.secondary;
    int at = start;
    for (int to = step(at, way); to >= 0; to = step(at, way)) {
      intervals += s.facets[facet(at, way)][2] >= 0 ? 2.0 : 1.0;
      p.length_mm += (s.X[to] - s.X[at]).norm();
      if (to == start) return -1;
      meet(at = to);
    }
    return at;
  }

  /// From the peak to both ends of the run of loaded nodes.
  void walk(Pressed& p) {
    const int start = peak_vertex();
    double intervals = 0.0;
    int bounded = 0;
    meet(start);
    for (int way : {-1, 1}) {
      const int at = walk_to_end(start, way, intervals, p);
      p.bounded = at < 0;  // loaded all round
      if (p.bounded) return;
      if (ends_at(at, way, p))
        ++bounded;
      else
        intervals += 0.5;
    }
    p.bounded = bounded == 2;
    const double across = std::min(intervals, primary_intervals());
    p.across = bounded == 1 ? 2.0 * across : across;  // half a contact, cut by a symmetry
  }

  /// Whether a run ends where one of the two sides ends; and if that cuts the contact off, what is cut.
  bool ends_at(int j, int way, Pressed& p) const {
    const int f = facet(j, way);
    const bool own_end = f < 0 || (setup_.cut[next(f, way)] && facet(next(f, way), way) < 0);
    std::vector<int> other_ends;
    for (const auto& [l, M] : contact_.reference[j].M)
      if (M != 0.0 && ends(setup_.primary, l)) other_ends.push_back(l);
    if (!own_end && other_ends.empty()) return false;
    if (pressure(j) < 0.1 * pressure(peak_)) return true;
    const Beyond own = f < 0 ? beyond(problem_, state_, setup_.secondary_nodes[j]) : Beyond::corner;
    Beyond other = Beyond::another_contact;  // it continues
    for (int l : other_ends) other = beyond(problem_, state_, setup_.primary_nodes[l]);
    if (own == Beyond::smooth && other != Beyond::corner)
      p.cut = placed_.secondary.boundary;
    else if (other == Beyond::smooth && !(own_end && own == Beyond::corner))
      p.cut = boundary_of(setup_.primary_nodes[other_ends.back()]);
    return true;
  }

  std::string boundary_of(const contact::SurfaceNode& node) const {
    for (const auto& ref : placed_.primary) {
      const auto nodes = side_nodes(state_.shapes, ref);
      if (ref.body == node.body && std::find(nodes.begin(), nodes.end(), node.mesh_node) != nodes.end())
        return ref.boundary;
    }
    return {};
  }

  /// Intervals of the primary side under the run; no bound where that is rigid. The run's outer nodes reach one beyond
  /// it.
  double primary_intervals() const {
    int count = 0;
    for (std::size_t l = 0; l < met_.size(); ++l) {
      if (met_[l] && problem_.rigid[setup_.primary_nodes[l].body]) return 1e300;
      count += met_[l];
    }
    return count - 2.0;
  }

  double beside_zone(double force) const {
    const auto& shape = *state_.shapes[setup_.secondary_nodes.front().body];
    const auto ratio = [&](int j) {
      const auto* zone = zone_round(shape, setup_.options.name, setup_.secondary.X[j]);
      return zone ? spacing(setup_.secondary, j) / zone->size_mm : 0.0;
    };
    if (ratio(peak_) <= coarse_in_zone) return 0.0;
    double beside = 0.0;
    for (int j = 0; j < setup_.secondary_count(); ++j)
      if (ratio(j) > coarse_in_zone) beside += force_at(j);
    return beside > 0.5 * force ? ratio(peak_) : 0.0;
  }

  double facets() const {
    double own = 0.0, other = 0.0;
    for (int j : run_) own = std::max(own, sagitta(setup_.secondary, j));
    for (std::size_t l = 0; l < met_.size(); ++l)
      if (met_[l]) other = std::max(other, sagitta(setup_.primary, static_cast<int>(l)));
    return own + other;
  }

  const Problem& problem_;
  const State& state_;
  const PlacedContact& placed_;
  const contact::Setup& setup_;
  const contact::ContactState& contact_;
  std::vector<char> met_;  ///< primary nodes that a node of the run meets
  std::vector<int> run_;
  int peak_ = 0;
};

}  // namespace

void begin_watch(const Problem& problem, State& state) {
  state.watch.resize(problem.contacts.size());
  for (auto& watch : state.watch) watch.pressed = {};
}

void watch_contacts(const Problem& problem, State& state, const solver::System& system, bool wear) {
  for (std::size_t c = 0; c < state.watch.size(); ++c) {
    Look look(problem, state, system, c);
    auto& watch = state.watch[c];
    if (wear) watch.slipped_most = std::max(watch.slipped_most, look.slipped());
    const double force = look.force();
    if (force <= harder * watch.pressed.force) continue;
    watch.force_most = std::max(watch.force_most, force);
    if (force >= 0.5 * watch.force_most) watch.pressed = look.pressed(force);
  }
}

}  // namespace reye::sim
