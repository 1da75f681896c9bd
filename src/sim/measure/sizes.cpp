#include "sim/measure/sizes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/formatted.hpp"
#include "material/parameters.hpp"
#include "mesh/measure.hpp"
#include "scene/histories.hpp"
#include "sim/problem/warnings.hpp"

namespace reye::sim {

namespace {

constexpr double crushing = 0.3, crushing_rubber = 3.0;  ///< pressure over modulus at small and at finite strain

Eigen::AlignedBox2d box_of(const mesh::Mesh& mesh) {
  Eigen::AlignedBox2d box;
  for (const Vec2& X : mesh.X) box.extend(X);
  return box;
}

/// Length of a support's edge, in axisymmetry the area that it sweeps; of a point none.
double size_of(const Problem& problem, int body, const body::Support& support) {
  const auto& mesh = problem.shapes[body]->mesh;
  if (support.edge.empty()) return 0.0;
  const auto& boundary = mesh.boundaries.at(support.edge);
  const double length = mesh::length(mesh.X, boundary, mesh::order(mesh.kind));
  if (problem.scene.analysis != base::Analysis::axisymmetric) return length;
  double radius = 0.0;
  const auto nodes = mesh::nodes_of(boundary);
  for (int node : nodes) radius += mesh.X[node].x() / static_cast<double>(nodes.size());
  return 2.0 * std::numbers::pi * radius * length;
}

void warn_of_motions(Problem& problem) {
  Eigen::AlignedBox2d all;
  for (const auto& shape : problem.shapes) all.extend(box_of(shape->mesh));
  const double reach = all.diagonal().norm();
  for (const auto& support : problem.scene.supports)
    for (const auto* motion : {&support.x, &support.y}) {
      const double way = scene::largest_value(problem.scene, motion->parts);
      if (motion->drive != body::Drive::moved || way <= reach) continue;
      warn(problem.warnings,
           {"units", "support " + support.name,
            base::formatted("It moves by %.4g mm, farther than all bodies reach together (%.4g mm); a motion in "
                            "um must be divided by 1000.",
                            way, reach),
            way / reach});
    }
}

void warn_of_bodies(Problem& problem) {
  for (int b = 0; b < problem.body_count(); ++b) {
    const Vec2 size = box_of(problem.shapes[b]->mesh).sizes();
    const double far = problem.scene.geometry.bodies[b].mesh.far_size_mm;
    if (far <= size.norm()) continue;
    warn(problem.warnings,
         {"units", "body " + problem.inputs[b].name,
          base::formatted("It measures %.4g x %.4g mm, less than one element of far_size_mm = %.4g. A drawing "
                          "in metres must be scaled by "
                          "1000: it would measure %.4g x %.4g mm.",
                          size.x(), size.y(), far, 1e3 * size.x(), 1e3 * size.y()),
          far / size.norm()});
  }
}

/// The support whose force would strain a body beyond what materials bear, in words; `least`: such a pressure.
std::string crushing_support(const Problem& problem, int body, double E, double least) {
  const bool ring = problem.scene.analysis == base::Analysis::axisymmetric;
  for (const auto& support : problem.inputs[body].supports)
    for (const auto* motion : {&support.x, &support.y}) {
      const double size = size_of(problem, body, support), force = scene::largest_value(problem.scene, motion->parts);
      if (motion->drive != body::Drive::loaded || motion->stiffness > 0.0 || size == 0.0 || force <= least * size)
        continue;
      return base::formatted(
          "the force of support %s, %.4g %s %.4g %s of its edge, would strain body %s of E_MPa = %.4g by %.3g %%; ",
          support.name.c_str(), force, ring ? "N on the" : "N/mm on", size, ring ? "mm^2" : "mm",
          problem.inputs[body].name.c_str(), E, 100.0 * force / (E * size));
    }
  return {};
}

/// Likewise, a load.
std::string crushing_load(const Problem& problem, int body, double E, double least) {
  for (const auto& load : problem.inputs[body].boundary_loads) {
    const double pressure = std::max(std::abs(load.pressure_MPa), load.traction_MPa.norm()) *
                            scene::largest_factor(problem.scene, load.history);
    if (pressure > least)
      return base::formatted("load %s, of %.4g MPa, would strain body %s of E_MPa = %.4g by %.3g %%; ",
                             load.name.c_str(), pressure, problem.inputs[body].name.c_str(), E, 100.0 * pressure / E);
  }
  return {};
}

}  // namespace

std::string why_crushed(const Problem& problem, int body) {
  if (problem.rigid[body]) return {};
  const double E = material::young(problem.inputs[body].material);
  const double least = E * (problem.inputs[body].kinematics == base::Kinematics::finite ? crushing_rubber : crushing);
  std::string why = crushing_support(problem, body, E, least);
  if (why.empty()) why = crushing_load(problem, body, E, least);
  return why.empty() ? why : why + "check the load, and E_MPa";
}

void warn_of_sizes(Problem& problem) {
  warn_of_bodies(problem);
  warn_of_motions(problem);
  for (int b = 0; b < problem.body_count(); ++b)
    if (auto why = why_crushed(problem, b); !why.empty()) {
      why.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(why.front())));
      warn(problem.warnings, {"units", "body " + problem.inputs[b].name, why + "."});
    }
}

}  // namespace reye::sim
