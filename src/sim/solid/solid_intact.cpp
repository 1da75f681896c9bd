#include "sim/solid/solid_intact.hpp"

#include <type_traits>

#include "scene/check.hpp"
#include "sim/problem/finite.hpp"
#include "sim/problem/intact_wear.hpp"
#include "sim/solid/solid_increments.hpp"

namespace reye::sim {

namespace {

/// What contact may touch are nodes of its faces, those of the start at least.
void check_touchable(const SolidProblem& problem, const SolidMeshes& meshes, const Touchable& touchable) {
  const Touchable most = contact_nodes(problem, meshes);
  const Touchable least = meshes == drawn_meshes(problem) ? touchable_nodes(problem, meshes) : Touchable(most.size());
  require(touchable.size() == problem.inputs.size(), "it has another number of bodies");
  for (std::size_t b = 0; b < touchable.size(); ++b) {
    const std::string body = "body " + problem.inputs[b].name;
    require(touchable[b].size() == most[b].size(), body + " has a node too many or too few");
    for (std::size_t n = 0; n < most[b].size(); ++n)
      require((least[b].empty() || touchable[b][n] >= least[b][n]) && touchable[b][n] <= most[b][n],
              body + " is prepared for contact where it has none");
  }
}

bool at_all_histories(const SolidProblem& problem, const std::map<std::string, double>& factors) {
  const auto& histories = problem.scene.histories;
  return factors.size() == histories.size() && std::all_of(factors.begin(), factors.end(), [&](const auto& factor) {
           return histories.contains(factor.first) && finite(factor.second);
         });
}

void check_place_in_steps(const SolidProblem& problem, const SolidRunState& state) {
  const auto& steps = problem.scene.steps;
  require(counted(state.step, static_cast<int>(steps.size())), "it is in a step that the scene lacks");
  const auto* step =
      state.step < static_cast<int>(steps.size()) ? &steps[static_cast<std::size_t>(state.step)] : nullptr;
  const double most = step ? step->cycles : 0.0;
  require(finite(state.step_cycles) && state.step_cycles >= 0.0 && state.step_cycles <= most && state.step_blocks >= 0,
          "it has done more cycles than the step has");
  const int ends = step ? static_cast<int>(solid_increment_ends(problem.scene, *step).size()) : 0;
  require(state.increment == 0 || (counted(state.increment, ends - 1) && !is_over(*step, state)),
          "it is at an increment that the step lacks");
  require(finite(state.cycle) && state.cycle >= 0.0, "its number of cycles is not a number");
  require(finite(state.jump) && finite(state.jump_rate) && finite(state.block_cycles) &&
              finite(state.share_per_cycle) && state.jump >= 0.0 && state.block_cycles >= 0.0,
          "its blocks have no number of cycles");
}

void check_numbers(const SolidProblem& problem, const SolidRunState& state) {
  require(at_all_histories(problem, state.factors), "a history is at no factor");
  require(state.energy_last_cycle_mJ.size() == problem.contacts.size() && finite(state.energy_last_cycle_mJ),
          "the energy of a contact is not a number");
  const auto known = [](const StickZone& z) {
    return finite(z.stick_mm) && finite(z.contact_mm) && finite(z.element_mm);
  };
  require(state.widest_stick.size() == problem.contacts.size() &&
              std::all_of(state.widest_stick.begin(), state.widest_stick.end(), known),
          "the stick zone of a contact is not a number");
  const auto& c = state.counts;
  require(c.blocks >= 0 && c.increments >= 0 && c.newton_iterations >= 0 && c.factorisations >= 0 && c.cutbacks >= 0 &&
              c.cycles_solved >= 0 && c.equilibrium_iterations >= 0 && state.retained >= 0 && finite(state.balance),
          "its counts are below zero");
}

void check_wear(const std::vector<contact::SkinWear>& wear, const solver::SolidSystem& system) {
  require(wear.size() == system.contacts.size(), "it has a contact too many or too few");
  for (std::size_t c = 0; c < wear.size(); ++c) {
    const auto& setup = system.contacts[c];
    contact::for_each_field(wear[c], [&](const contact::Field& field, const auto& member) {
      const std::string what = "contact " + setup.options.name + ": " + std::string(field.name);
      require(finite(member), what + " is not a number");
      if constexpr (!std::is_arithmetic_v<std::remove_cvref_t<decltype(member)>>)
        require(
            member.size() == (field.site == contact::Site::secondary ? setup.secondary : setup.primary).points.size(),
            what + " has a value too many or too few");
    });
  }
}

void check_meshes(const SolidProblem& problem, const SolidMeshes& meshes) {
  require(meshes.size() == problem.inputs.size(), "it has another number of bodies");
  for (std::size_t b = 0; b < meshes.size(); ++b)
    require(meshes[b] && meshes[b]->kind == problem.inputs[b].mesh->kind &&
                meshes[b]->faces.size() == problem.inputs[b].mesh->faces.size(),
            "body " + problem.inputs[b].name + " has another mesh");
}

void check_solid_state(const solver::SolidState& state, const solver::SolidSystem& system) {
  require(state.traction.size() == system.contacts.size() && state.status.size() == system.contacts.size(),
          "it has a contact too many or too few");
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const std::string name = "contact " + system.contacts[c].options.name;
    const auto count = static_cast<std::size_t>(system.contacts[c].count());
    require(state.traction[c].size() == count && state.status[c].size() == count,
            name + " has a value too many or too few");
    require(finite(state.traction[c]), name + " has a traction that is not a number");
    for (const auto status : state.status[c])
      require(status >= contact::SkinStatus::open && status <= contact::SkinStatus::slip,
              "a point of " + name + " is neither open nor sticks nor slips");
  }
  check_wear(state.wear, system);
  require(state.a.size() == system.free() && state.s.size() == system.driven() &&
              state.u.size() == 3 * system.points() && finite(state.a) && finite(state.s) && finite(state.u),
          "its displacements are not those of its meshes");
  require(state.turn.size() == system.bodies.size(), "it has another number of bodies");
  for (const auto& turn : state.turn)
    require(finite(turn.coeffs()) && std::abs(turn.norm() - 1.0) < 1e-9, "a body is turned by what is no rotation");
}

void check_skin_place(const contact::SkinPlace& place, const contact::SkinSetup& setup, int points) {
  const std::string name = "contact " + setup.options.name;
  const auto count = static_cast<std::size_t>(setup.count());
  require(place.Q.rows() == setup.count() && place.Q.cols() == points && place.covered.size() == setup.count() &&
              place.area.size() == setup.count() && place.frame.size() == count && place.carries.size() == count,
          name + " has integrals too many or too few");
  require(finite(place.covered) && finite(place.area) && place.Q.coeffs().isFinite().all() &&
              place.D.coeffs().isFinite().all() && place.M.coeffs().isFinite().all() &&
              place.T.coeffs().isFinite().all(),
          name + " has an integral that is not a number");
  for (const auto& frame : place.frame)
    require(finite(frame.normal) && finite(frame.tangent) && counted(frame.free, 2),
            name + " has a normal that is none");
}

void check_solution(const solver::SolidSolution& solution, const solver::SolidSystem& system) {
  check_solid_state(solution.state, system);
  require(solution.converged && solution.place.size() == system.contacts.size() &&
              solution.nodes.size() == system.contacts.size(),
          "its last increment was not solved");
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    check_skin_place(solution.place[c], system.contacts[c], system.points());
    require(solution.nodes[c].size() == static_cast<std::size_t>(system.contacts[c].count()),
            "contact " + system.contacts[c].options.name + " has a value too many or too few");
    for (const auto& node : solution.nodes[c])
      require(finite(node.traction) && finite(node.gap) && finite(node.slip) && finite(node.own_wear),
              "contact " + system.contacts[c].options.name + " has a value that is not a number");
  }
}

}  // namespace

std::optional<SolidAssembly> check_state(const SolidProblem& problem, const SolidRunState& state) {
  check_place_in_steps(problem, state);
  check_numbers(problem, state);
  check_meshes(problem, state.meshes);
  check_meshes(problem, state.born);
  check_touchable(problem, state.meshes, state.touchable);
  if (!state.solved) {
    require(state.step == 0 && state.step_blocks == 0 && state.increment == 0 && state.cycle == 0.0,
            "it is under way and has not begun");
    return {};
  }
  SolidAssembly assembly = assemble(problem, state.meshes, state.touchable);
  require(state.retained == assembly.system.points() && state.points == points_of(assembly.system),
          "it was solved with other points");
  check_wear(state.block_wear, assembly.system);
  check_last_wear(state.last_wear, state.solution.wear);
  require(state.slid.size() == assembly.system.contacts.size(), "it has a contact too many or too few");
  for (std::size_t c = 0; c < state.slid.size(); ++c)
    require(state.slid[c].size() == state.points[c].secondary.size(), "it slid at points that it lacks");
  check_solid_state(state.solution, assembly.system);
  check_solution(*state.solved, assembly.system);
  return assembly;
}

std::vector<base::Issue> extend(const SolidProblem& problem, const std::string& cycles_key,
                                const SolidRunState& state) {
  const auto& steps = problem.scene.steps;
  const double begun = state.step_cycles + (state.increment > 0 ? 1.0 : 0.0);
  if (state.step + 1 != static_cast<int>(steps.size()) || begun <= steps.back().cycles) return {};
  return {{cycles_key, scene::shown(steps.back().cycles),
           "the run has begun " + scene::shown(begun) + " cycles of this step already"}};
}

}  // namespace reye::sim
