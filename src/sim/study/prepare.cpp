#include "sim/study/prepare.hpp"

#include <filesystem>

#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "scene/read.hpp"
#include "sim/study/accuracy.hpp"
#include "sim/study/decide.hpp"

namespace reye::sim {

namespace {

using base::Issue;

/// Geometry files by their path from the scene, which is how the user wrote them.
std::vector<Issue> as_written(const scene::Scene& scene, std::vector<Issue> issues) {
  const auto folder = std::filesystem::absolute(scene.path).parent_path();
  for (auto& issue : issues)
    for (const auto& file : scene.geometry.files)
      if (issue.value == base::quoted(file))
        issue.value = base::quoted(std::filesystem::path(file).lexically_proximate(folder).string());
  return issues;
}

Problem sized(scene::Scene scene, Cache& cache) {
  const auto sizes = choose_sizes(scene, cache);
  Problem problem = decide(scene, cache);
  problem.plan.lines.insert(problem.plan.lines.begin(), sizes.begin(), sizes.end());
  return problem;
}

}  // namespace

Problem prepare(const scene::Scene& scene, Cache* cache) {
  Cache own;
  try {
    return sized(scene, cache ? *cache : own);
  } catch (const base::InputError& error) {
    throw scene::located(scene, as_written(scene, error.issues()));
  } catch (const base::MeshError& error) {
    throw scene::located(scene, {{"geometry", "", error.what()}});
  } catch (const base::SolveError& error) {
    throw scene::located(scene,
                         {{"", "", std::string("the scene has no equilibrium that can be computed: ") + error.what()}});
  }
}

}  // namespace reye::sim
