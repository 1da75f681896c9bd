#include "sim/solid/whole_patch.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algebra/decompose.hpp"
#include "mesh/solid/solid_measure.hpp"

namespace reye::sim {

namespace {

using contact::SkinStatus;

struct Plane {
  Vec3 point, normal;
};

bool plane_of_symmetry(const body::SolidSupport& support) {
  const auto still = [](const body::Motion& motion) { return motion.drive == body::Drive::free; };
  return support.normal.drive == body::Drive::fixed && !support.rigid &&
         std::all_of(support.along.begin(), support.along.end(), still);
}

/// The plane in which all facets of a face lie; a curved face has none.
bool plane_of_face(const mesh::SolidMesh& mesh, const std::string& face, Plane& plane) {
  const auto& facets = mesh.faces.at(face);
  if (facets.empty()) return false;
  plane.normal = mesh::facet_normal(mesh.X, mesh.skin[facets.front()]);
  plane.point = mesh.X[mesh.skin[facets.front()].nodes[0]];
  const double size = mesh::box_diagonal(mesh.X);
  const auto nodes = mesh::nodes_of(mesh::facets_of(mesh, face));
  return std::all_of(nodes.begin(), nodes.end(),
                     [&](int n) { return std::abs((mesh.X[n] - plane.point).dot(plane.normal)) < 1e-6 * size; });
}

std::vector<Plane> planes_of(const SolidProblem& problem, int body) {
  std::vector<Plane> planes;
  for (const auto& support : problem.inputs[body].supports) {
    Plane plane;
    if (plane_of_symmetry(support) && plane_of_face(*problem.inputs[body].mesh, support.face, plane))
      planes.push_back(plane);
  }
  return planes;
}

bool reaches(const WholePatch& patch, const Plane& plane) {
  for (std::size_t i = 0; i < patch.x.size(); ++i)
    if (std::abs((patch.x[i] - plane.point).dot(plane.normal)) < 1e-3 * std::sqrt(patch.area_mm2[i])) return true;
  return false;
}

void mirror(WholePatch& patch, const Plane& plane) {
  const std::size_t count = patch.x.size();
  for (std::size_t i = 0; i < count; ++i) {
    patch.x.push_back(patch.x[i] - 2.0 * (patch.x[i] - plane.point).dot(plane.normal) * plane.normal);
    patch.area_mm2.push_back(patch.area_mm2[i]);
    patch.sticks.push_back(patch.sticks[i]);
  }
}

}  // namespace

double WholePatch::area() const { return std::accumulate(area_mm2.begin(), area_mm2.end(), 0.0); }

double WholePatch::stick_area() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < sticks.size(); ++i)
    if (sticks[i]) sum += area_mm2[i];
  return sum;
}

double WholePatch::element() const {
  return area_mm2.empty() ? 0.0 : std::sqrt(*std::max_element(area_mm2.begin(), area_mm2.end()));
}

std::array<double, 2> WholePatch::half_widths() const {
  const double whole = area();
  if (!(whole > 0.0)) return {0.0, 0.0};
  Vec3 middle = Vec3::Zero();
  for (std::size_t i = 0; i < x.size(); ++i) middle += area_mm2[i] / whole * x[i];
  base::Mat3 moments = base::Mat3::Zero();
  for (std::size_t i = 0; i < x.size(); ++i)
    moments += area_mm2[i] / whole * (x[i] - middle) * (x[i] - middle).transpose();
  const auto values = algebra::eigenpairs(moments).values;
  const auto half = [&](int k) { return 2.0 * std::sqrt(std::max(0.0, values[k])); };
  return {half(2), half(1)};
}

WholePatch whole_patch(const SolidProblem& problem, const solver::SolidSystem& system,
                       const solver::SolidSolution& solution, std::size_t c, const std::vector<char>& slid) {
  WholePatch patch;
  const auto& setup = system.contacts[c];
  for (int j = 0; j < setup.count(); ++j) {
    if (solution.state.status[c][j] == SkinStatus::open) continue;
    patch.x.push_back(setup.secondary.skin.x[j]);
    patch.area_mm2.push_back(solution.place[c].covered[j]);
    patch.sticks.push_back(!slid[j]);
  }
  for (const auto& plane : planes_of(problem, problem.contacts[c].secondary.body))
    if (reaches(patch, plane)) mirror(patch, plane);
  return patch;
}

WholePatch whole_patch(const SolidProblem& problem, const solver::SolidSystem& system,
                       const solver::SolidSolution& solution, std::size_t c) {
  const auto& status = solution.state.status[c];
  const bool rubs = system.contacts[c].options.friction > 0.0;
  std::vector<char> slid(status.size());
  std::transform(status.begin(), status.end(), slid.begin(),
                 [rubs](SkinStatus s) { return !(rubs && s == SkinStatus::stick); });
  return whole_patch(problem, system, solution, c, slid);
}

}  // namespace reye::sim
