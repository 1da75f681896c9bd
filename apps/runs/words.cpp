#include "runs/words.hpp"

#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "mesh/measure.hpp"
#include "mesh/quality.hpp"
#include "mesh/solid/solid_measure.hpp"
#include "sim/problem/scene_line.hpp"
#include "sim/problem/warnings.hpp"

namespace reye::apps {

std::vector<std::string> in_words(const scene::Scene& scene, const std::vector<sim::Warning>& warnings) {
  std::vector<std::string> lines;
  for (const auto& warning : warnings) lines.push_back(sim::scene_line(scene, warning.about) + sim::in_words(warning));
  return lines;
}

std::vector<std::string> in_words(const std::vector<sim::Warning>& warnings) {
  std::vector<std::string> lines;
  for (const auto& warning : warnings) lines.push_back(sim::in_words(warning));
  return lines;
}

std::vector<std::string> body_lines(const sim::Problem& problem) {
  std::vector<std::string> lines;
  for (int b = 0; b < problem.body_count(); ++b) {
    const auto& mesh = problem.shapes[b]->mesh;
    const auto box = mesh::bounding_box(mesh.X);
    lines.push_back(base::formatted("body %s: area %.6g mm^2, box [%.6g, %.6g] x [%.6g, %.6g] mm, %d nodes, %d cells",
                                    problem.inputs[b].name.c_str(), mesh::area(mesh), box[0], box[2], box[1], box[3],
                                    mesh.node_count(), mesh.cell_count()));
    for (const auto& [name, boundary] : mesh.boundaries)
      lines.push_back(base::formatted("  boundary %s: %.6g mm, %zu nodes", name.c_str(), mesh::length(mesh.X, boundary),
                                      mesh::nodes_of(boundary).size()));
  }
  return lines;
}

std::vector<std::string> body_lines(const sim::SolidProblem& problem) {
  std::vector<std::string> lines;
  for (const auto& input : problem.inputs) {
    const auto& mesh = *input.mesh;
    const auto box = mesh::bounding_box(mesh.X);
    lines.push_back(base::formatted(
        "body %s: volume %.6g mm^3, box [%.6g, %.6g] x [%.6g, %.6g] x [%.6g, %.6g] mm, %d nodes, %d cells",
        input.name.c_str(), mesh::volume(mesh), box[0], box[3], box[1], box[4], box[2], box[5], mesh.node_count(),
        mesh.cell_count()));
    for (const auto& [name, facets] : mesh.faces)
      lines.push_back(base::formatted("  face %s: %.6g mm^2, %zu facets", name.c_str(),
                                      mesh::area(mesh.X, mesh::facets_of(mesh, name)), facets.size()));
  }
  return lines;
}

void refuse_what_does_not_fit(const sim::SolidPlan& plan) {
  if (!plan.refusal.empty()) throw base::InputError({{"geometry", "", plan.refusal}});
}

}  // namespace reye::apps
