#include "sim/study/decide.hpp"

#include "sim/place/place.hpp"
#include "sim/place/plan.hpp"
#include "sim/place/warn_meshes.hpp"
#include "sim/problem/timer.hpp"
#include "sim/study/kinematics.hpp"

namespace reye::sim {

Problem decide(const scene::Scene& scene, Cache& cache) {
  Problem problem = place(scene, cache);
  const double before = cpu_seconds();
  choose_kinematics(problem, cache);
  const auto notes = std::move(problem.plan.lines);
  problem.plan = make_plan(problem, *timed_system(problem, initial_state(problem), cache));
  warn_of_meshes(problem, *timed_system(problem, initial_state(problem), cache));
  problem.plan.lines.insert(problem.plan.lines.end(), notes.begin(), notes.end());
  cache.cpu_s += cpu_seconds() - before;
  return problem;
}

}  // namespace reye::sim
