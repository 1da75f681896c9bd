#include "sim/study/solid_discretisation.hpp"

#include <algorithm>
#include <cmath>

#include "adapt/solid/skin_locator.hpp"
#include "base/errors.hpp"
#include "mesh/solid/solid_measure.hpp"
#include "sim/solid/solid_march.hpp"
#include "sim/solid/solid_measure.hpp"
#include "sim/solid/solid_player.hpp"
#include "sim/study/known_orders.hpp"

namespace reye::sim {

namespace {

using mesh::Facet;
using mesh::FacetKind;

/// The facets of a record as flat ones of first order over the same rows: a tri6 is four triangles.
std::vector<Facet> flat_facets(const std::vector<Facet>& facets) {
  constexpr std::array<std::array<int, 3>, 4> parts{{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}};
  std::vector<Facet> flat;
  for (const Facet& facet : facets) {
    if (facet.kind != FacetKind::tri6) {
      flat.push_back(facet);
      continue;
    }
    for (const auto& part : parts) {
      Facet& triangle = flat.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) triangle.nodes[k] = facet.nodes[static_cast<std::size_t>(part[k])];
    }
  }
  return flat;
}

/// A surface on which values of rows can be looked up.
class Surface {
 public:
  explicit Surface(const SkinRecord& record) : skin_{flat_facets(record.facets), record.x_mm}, locator_(skin_) {}

  /// Weights of rows at the place nearest to x.
  struct Place {
    std::array<int, 4> row{};
    std::array<double, 4> weight{};

    template <class Values>
    auto of(const Values& values) const {
      std::decay_t<decltype(values[0])> sum = weight[0] * values[static_cast<std::size_t>(row[0])];
      for (std::size_t k = 1; k < 4; ++k) sum += weight[k] * values[static_cast<std::size_t>(row[k])];
      return sum;
    }
  };
  Place nearest(const Vec3& x) const {
    const auto foot = locator_.nearest(x);
    const Facet& facet = skin_.facets[static_cast<std::size_t>(foot.facet)];
    const double a = foot.xi.x(), b = foot.xi.y();
    Place place;
    if (facet.kind == FacetKind::tri3)
      place.weight = {1.0 - a - b, a, b, 0.0};
    else
      place.weight = {0.25 * (1 - a) * (1 - b), 0.25 * (1 + a) * (1 - b), 0.25 * (1 + a) * (1 + b),
                      0.25 * (1 - a) * (1 + b)};
    for (std::size_t k = 0; k < 4; ++k) place.row[k] = std::max(0, facet.nodes[k]);
    return place;
  }
  /// The area that each row stands for.
  std::vector<double> shares() const {
    std::vector<double> share(skin_.x.size(), 0.0);
    for (const Facet& facet : skin_.facets)
      for (int k = 0; k < facet.count(); ++k)
        share[static_cast<std::size_t>(facet.nodes[k])] += mesh::facet_area(skin_.x, facet) / facet.count();
    return share;
  }

 private:
  mortar::Skin skin_;
  adapt::SkinLocator locator_;
};

double peak_of(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

/// Adds the differences of one side of a contact.
void add_differences(const SkinRecord& fine, const SkinRecord& coarse, MeshDifference& most) {
  const auto raise = [](std::optional<double>& to, double value) { to = std::max(to.value_or(0.0), value); };
  if (fine.facets.empty() || coarse.facets.empty()) return;
  const auto share = Surface(fine).shares();
  const Surface other(coarse);
  double apart = 0.0, worn = 0.0, traction_apart = 0.0, traction = 0.0;
  for (std::size_t i = 0; i < share.size(); ++i) {
    const auto place = other.nearest(fine.x_mm[i]);
    const double w = fine.wear_depth_mm.empty() ? 0.0 : fine.wear_depth_mm[i];
    apart += share[i] * std::abs(w - (coarse.wear_depth_mm.empty() ? 0.0 : place.of(coarse.wear_depth_mm)));
    worn += share[i] * w;
    const double p = fine.pressure_MPa[i];
    traction += share[i] * (p * p + fine.shear_MPa[i].squaredNorm());
    traction_apart += share[i] * (std::pow(p - place.of(coarse.pressure_MPa), 2) +
                                  (fine.shear_MPa[i] - place.of(coarse.shear_MPa)).squaredNorm());
  }
  if (worn > 0.0) {
    const double depth = peak_of(fine.wear_depth_mm);
    raise(most.wear, std::max(apart / worn, std::abs(depth - peak_of(coarse.wear_depth_mm)) / depth));
  }
  const double peak = peak_of(fine.pressure_MPa);
  if (fine.side != Side::secondary || !(peak > 0.0)) return;
  raise(most.traction, std::sqrt(traction_apart / traction));
  raise(most.peak, std::abs(peak - peak_of(coarse.pressure_MPa)) / peak);
}

/// The surfaces at the end of a run, and whether loaded points stuck in the last block while others slid.
struct End {
  std::vector<SkinRecord> surfaces;
  bool stick_edge = false;
};

End end_of(const SolidProblem& problem, SolidRunState state) {
  SolidPlayer player(problem, state, {});
  state = player.brought_up(std::move(state));
  if (!state.solved) return {};
  End end;
  end.surfaces = solid_frame(problem, player.assembly(), state, "", {state.cycle, 1.0, false}).surfaces;
  for (std::size_t c = 0; c < state.slid.size() && c < state.solved->state.status.size(); ++c) {
    const auto& status = state.solved->state.status[c];
    const auto& slid = state.slid[c];
    const bool any = std::any_of(slid.begin(), slid.end(), [](char slides) { return slides != 0; });
    for (std::size_t j = 0; any && j < slid.size() && j < status.size(); ++j)
      end.stick_edge = end.stick_edge || (!slid[j] && status[j] != contact::SkinStatus::open);
  }
  return end;
}

/// Whether some secondary side touches with fewer rows than an estimate needs: four elements across a disc.
bool few_rows(const std::vector<SkinRecord>& surfaces) {
  constexpr int fewest = 12;
  return std::any_of(surfaces.begin(), surfaces.end(), [](const SkinRecord& s) {
    const auto loaded = std::count_if(s.pressure_MPa.begin(), s.pressure_MPa.end(), [](double p) { return p > 0.0; });
    return s.side == Side::secondary && loaded > 0 && loaded < fewest;
  });
}

bool same_meshes(const SolidProblem& a, const SolidProblem& b) {
  for (int k = 0; k < a.body_count(); ++k)
    if (a.inputs[k].mesh->node_count() != b.inputs[k].mesh->node_count()) return false;
  return true;
}

DiscretisationError none(RunStatus status, std::string reason) {
  DiscretisationError error;
  error.companion = status;
  error.reason = std::move(reason);
  return error;
}

DiscretisationError compared(const SolidProblem& problem, const SolidRunState& state, const SolidObserver& observer) {
  const SolidProblem coarse = prepare_solid(coarser(problem, state));
  if (same_meshes(problem, coarse)) return none(RunStatus::failed, "the meshes came with their files as they are");
  SolidRunState end = initial_solid_state(coarse);
  SolidObserver aside;
  aside.interrupted = observer.interrupted;
  aside.state = [&end](const SolidRunState& now) { end = now; };
  if (observer.progress)
    aside.progress = [&observer](Progress p) {
      p.step = "coarse: " + p.step;
      observer.progress(p);
    };
  const SolidSummary summary = run_solid(coarse, initial_solid_state(coarse), aside);
  if (summary.status != RunStatus::done) return none(summary.status, "the companion run: " + summary.reason);
  const End rough = end_of(coarse, std::move(end));
  if (few_rows(rough.surfaces))
    return none(RunStatus::done, "fewer than four elements touch where they are twice as long");
  const End fine = end_of(problem, state);
  const auto apart = mesh_difference(fine.surfaces, rough.surfaces);
  if (!apart.wear && !apart.traction) return none(RunStatus::done, "nothing touches at the end");
  DiscretisationError error;
  add_errors(apart, fine.stick_edge, error);
  return error;
}

}  // namespace

scene::SolidScene coarser(const SolidProblem& problem, const SolidRunState& state) {
  constexpr double default_sizes = 15.0;  ///< per diagonal of a body
  auto scene = problem.scene;
  for (auto& zone : scene.geometry.fine_zones) zone.size_mm *= coarsening;
  for (std::size_t b = 0; b < scene.geometry.bodies.size(); ++b) {
    double& size = scene.geometry.bodies[b].mesh.far_size_mm;
    if (size <= 0.0) size = mesh::box_diagonal(problem.inputs[b].mesh->X) / default_sizes;
    size *= coarsening;
  }
  if (state.step < static_cast<int>(scene.steps.size())) {  // a limit has ended the run
    scene.steps.resize(static_cast<std::size_t>(state.step) + 1);
    if (scene.steps.back().cycles > 0.0) scene.steps.back().cycles = state.step_cycles;
  }
  scene.limits.clear();
  scene.probes.clear();
  scene.frames = {};
  scene.frames.paraview = false;
  scene.estimate_error = false;
  return scene;
}

MeshDifference mesh_difference(const std::vector<SkinRecord>& fine, const std::vector<SkinRecord>& coarse) {
  MeshDifference most;
  for (std::size_t k = 0; k < fine.size() && k < coarse.size(); ++k) add_differences(fine[k], coarse[k], most);
  return most;
}

DiscretisationError mesh_error(const SolidProblem& problem, const SolidRunState& state, const SolidObserver& observer) {
  try {
    return compared(problem, state, observer);
  } catch (const std::runtime_error& refusal) {  // the scene or mesh is not valid with longer elements
    return none(RunStatus::failed, refusal.what());
  }
}

}  // namespace reye::sim
