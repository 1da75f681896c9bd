#include "sim/solid/solid_reshape.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "adapt/solid/solid_remesh.hpp"
#include "adapt/solid/solid_step.hpp"
#include "adapt/solid/solid_triggers.hpp"
#include "mesh/solid/solid_measure.hpp"
#include "sim/problem/timer.hpp"
#include "sim/solid/skin_depth.hpp"
#include "sim/solid/solid_redraw.hpp"
#include "sim/solid/solid_state.hpp"

namespace reye::sim {

namespace {

/// Shape of an element, below which the run ends.
constexpr double least_quality = 0.05;

double share_of_side(const contact::SkinSide& side, const std::vector<double>& pending) {
  const auto depth = skin_depths(side, pending);
  std::vector<double> size(depth.size(), 0.0);
  for (const auto& facet : side.skin.facets)
    for (int k = 0; k < facet.count(); ++k) {
      double& least = size[static_cast<std::size_t>(facet.nodes[k])];
      const double own = std::sqrt(mesh::facet_area(side.skin.x, facet));
      least = least > 0.0 ? std::min(least, own) : own;
    }
  double share = 0.0;
  for (std::size_t j = 0; j < depth.size(); ++j)
    if (size[j] > 0.0) share = std::max(share, depth[j] / size[j]);
  return share;
}

/// Volumes per node of each face that a body loses.
class WornFaces {
 public:
  WornFaces(const SolidRunState& state, int body) : mesh_(*state.meshes[static_cast<std::size_t>(body)]), body_(body) {}

  /// Adds the volumes of the points of a side that lie on one face of the body.
  void add(const contact::SkinSide& side, const contact::FaceRef& face, const std::vector<double>& pending) {
    if (face.body != body_) return;
    auto& removed = of_node_[face.face];
    const auto nodes = mesh::nodes_of(mesh::facets_of(mesh_, face.face));
    for (std::size_t i = 0; i < side.points.size(); ++i) {
      const auto& point = side.points[i];
      if (point.body != body_ || pending[i] == 0.0 || taken_.contains({&side, i})) continue;
      if (!std::binary_search(nodes.begin(), nodes.end(), point.node)) continue;
      taken_.insert({&side, i});  // a node that two faces of one side share wears once
      removed[point.node] += pending[i];
      total_ += pending[i];
    }
  }

  double total() const { return total_; }

  std::vector<adapt::WornFace> take() const {
    std::vector<adapt::WornFace> faces;
    for (const auto& [name, removed] : of_node_) {
      adapt::WornFace face{name, {}};
      for (const int node : mesh::nodes_of(mesh::facets_of(mesh_, name))) {
        const auto found = removed.find(node);
        face.removed.push_back(found == removed.end() ? 0.0 : found->second);
      }
      faces.push_back(std::move(face));
    }
    return faces;
  }

 private:
  const mesh::SolidMesh& mesh_;
  int body_;
  double total_ = 0.0;
  std::map<std::string, std::map<int, double>> of_node_;
  std::set<std::pair<const contact::SkinSide*, std::size_t>> taken_;
};

WornFaces worn_faces(const SolidProblem& problem, const solver::SolidSystem& system, const SolidRunState& state,
                     int body) {
  WornFaces worn(state, body);
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const auto& wear = state.solution.wear[c];
    worn.add(system.contacts[c].secondary, problem.contacts[c].secondary, wear.pending_secondary);
    for (const auto& face : problem.contacts[c].primary)
      worn.add(system.contacts[c].primary, face, wear.pending_primary);
  }
  return worn;
}

/// Enters the strips in the ledger, their depth at the points, and empties the gaps; `ratio` per body: strip over
/// waiting volume.
void book_strips(const solver::SolidSystem& system, const std::vector<double>& ratio, SolidRunState& state) {
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    auto& wear = state.solution.wear[c];
    const auto book = [&](const contact::SkinSide& side, std::vector<double>& pending, std::vector<double>& moved,
                          double& strip) {
      const auto area = point_areas(side);
      for (std::size_t i = 0; i < pending.size(); ++i) {
        if (area[i] > 0.0) moved[i] += pending[i] / area[i];
        strip += pending[i] * ratio[static_cast<std::size_t>(side.points[i].body)];
        pending[i] = 0.0;
      }
    };
    book(system.contacts[c].secondary, wear.pending_secondary, wear.moved_secondary, wear.strip_secondary);
    book(system.contacts[c].primary, wear.pending_primary, wear.moved_primary, wear.strip_primary);
  }
}

/// Every body in contact that can be remeshed is to be.
void ask_for_all(const SolidProblem& problem, const solver::SolidSystem& system, MovedSolids& moved) {
  const std::string reason = "every " + std::to_string(problem.scene.remesh.every_blocks) + " blocks, as asked for";
  const auto ask = [&](const contact::SkinSide& side) {
    for (const auto& point : side.points) {
      const auto b = static_cast<std::size_t>(point.body);
      if (moved.reasons[b].empty() && adapt::can_be_remeshed(*moved.meshes[b])) moved.reasons[b] = reason;
    }
  };
  for (const auto& contact : system.contacts) {
    ask(contact.secondary);
    ask(contact.primary);
  }
}

}  // namespace

bool remesh_due(const SolidProblem& problem, const SolidRunState& state) {
  const int every = problem.scene.remesh.every_blocks;
  return every > 0 && state.counts.blocks % every == 0;
}

double pending_share(const solver::SolidSystem& system, const SolidRunState& state) {
  double share = 0.0;
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    if (!system.contacts[c].options.wear.wears()) continue;
    const auto& wear = state.solution.wear[c];
    share = std::max({share, share_of_side(system.contacts[c].secondary, wear.pending_secondary),
                      share_of_side(system.contacts[c].primary, wear.pending_primary)});
  }
  return share;
}

std::string reshape_bodies(const SolidProblem& problem, SolidPlayer& player, SolidRelocations& relocations,
                           const scene::Step& step, const SolidObserver& observer, SolidRunState& state) {
  const double start = cpu_seconds();
  const auto& options = problem.scene.remesh;
  const bool due = remesh_due(problem, state);
  const bool goes_on = !at_end(problem, state);  // else nothing is solved on these shapes but what they show
  MovedSolids moved{state.meshes, std::vector<std::string>(state.meshes.size())};
  std::vector<double> ratio(state.meshes.size(), 1.0);
  for (std::size_t b = 0; b < moved.meshes.size(); ++b) {
    const auto worn = worn_faces(problem, player.system(), state, static_cast<int>(b));
    if (!(worn.total() > 0.0)) continue;
    auto result = adapt::evolve_solid(moved.meshes[b], *state.born[b], worn.take(), least_quality, &relocations[b]);
    if (!result.failure.empty()) return "body " + problem.inputs[b].name + ": " + result.failure;
    ratio[b] = result.removed / worn.total();
    moved.meshes[b] = result.mesh;
    moved.reasons[b] = result.poor;
    if (!options.automatic && !due && !result.poor.empty())
      return "body " + problem.inputs[b].name + ": " + result.poor + ", and remesh.automatic is false";
    if (options.automatic && goes_on && result.poor.empty() && adapt::can_be_remeshed(*result.mesh))
      moved.reasons[b] = adapt::why_remesh(*result.mesh, *state.born[b], options.triggers);
  }
  if (due) ask_for_all(problem, player.system(), moved);
  book_strips(player.system(), ratio, state);
  state.shape_s += cpu_seconds() - start;
  const auto asks = [](const std::string& reason) { return !reason.empty(); };
  if (std::none_of(moved.reasons.begin(), moved.reasons.end(), asks)) {
    if (goes_on)
      player.reshape(state, std::move(moved.meshes));
    else
      player.show_on(state, std::move(moved.meshes));
    return {};
  }
  for (std::size_t b = 0; b < moved.reasons.size(); ++b)
    if (observer.log && asks(moved.reasons[b]))
      observer.log("body " + problem.inputs[b].name + " is remeshed: " + moved.reasons[b]);
  return redraw_bodies(problem, player, std::move(moved), step, observer, state);
}

}  // namespace reye::sim
