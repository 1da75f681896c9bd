#pragma once
#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "material/parameters.hpp"
#include "sim/solid/solid_march.hpp"
#include "support/solid_blocks.hpp"

/// Problems of solids for tests, without a scene file.
namespace reye::support {

using base::Mat3;
using base::Vec3;

/// Maps the unit cube onto the block [lo, hi].
inline std::function<Vec3(const Vec3&)> box(const Vec3& lo, const Vec3& hi) {
  return [lo, hi](const Vec3& x) { return Vec3(lo + (hi - lo).cwiseProduct(x)); };
}

inline body::Motion fixed_motion() { return {body::Drive::fixed, {}, 0.0}; }
inline body::Motion moved(double value, const std::string& history) {
  return {body::Drive::moved, {{value, history}}, 0.0};
}
inline body::Motion loaded(double value, const std::string& history) {
  return {body::Drive::loaded, {{value, history}}, 0.0};
}

/// A support by node that holds the motions it is given.
inline body::SolidSupport by_node(const std::string& name, const std::string& face, std::array<body::Motion, 3> along,
                                  const Mat3& axes = Mat3::Identity()) {
  body::SolidSupport support;
  support.name = name;
  support.face = face;
  support.along = std::move(along);
  support.axes = axes;
  return support;
}

/// A plane of symmetry.
inline body::SolidSupport symmetry(const std::string& name, const std::string& face) {
  body::SolidSupport support;
  support.name = name;
  support.face = face;
  support.normal = fixed_motion();
  return support;
}

inline body::SolidInput solid(const std::string& name, mesh::SolidMesh mesh, double E_MPa, double nu) {
  body::SolidInput input;
  input.name = name;
  input.mesh = std::make_shared<const mesh::SolidMesh>(std::move(mesh));
  input.material = material::LinearElastic{E_MPa, nu};
  return input;
}

/// A problem of these bodies, with one contact between a face of the one and of the other.
inline sim::SolidProblem problem_of(std::vector<body::SolidInput> inputs, contact::FaceRef secondary,
                                    contact::FaceRef primary, double friction, double search_mm) {
  sim::SolidProblem problem;
  problem.inputs = std::move(inputs);
  for (int b = 0; b < problem.body_count(); ++b)
    for (int k = 0; k < static_cast<int>(problem.inputs[b].supports.size()); ++k) {
      problem.support_of.push_back({b, k});
      problem.scene.supports.push_back(problem.inputs[b].supports[k]);
    }
  sim::PlacedSkins contact;
  contact.options.name = "pad";
  contact.options.secondary = secondary.face;
  contact.options.primary = {primary.face};
  contact.options.friction = friction;
  contact.secondary = secondary;
  contact.primary = {primary};
  contact.modulus_MPa = std::numeric_limits<double>::infinity();
  for (const int body : {secondary.body, primary.body})
    if (const auto& input = problem.inputs[body]; !input.rigid)
      contact.modulus_MPa = std::min(contact.modulus_MPa, material::young(input.material));
  contact.search_mm = search_mm;
  problem.inputs[secondary.body].contact_faces.push_back(secondary.face);
  problem.inputs[primary.body].contact_faces.push_back(primary.face);
  problem.contacts.push_back(std::move(contact));
  return problem;
}

inline scene::Step step_of(int increments, std::vector<std::string> play = {}, double cycles = 0.0) {
  scene::Step step;
  step.name = "step";
  step.play = std::move(play);
  step.increments = increments;
  step.cycles = cycles;
  step.wear = false;
  return step;
}

/// All that a run shows.
struct PlayedSolids {
  sim::SolidSummary summary;
  std::vector<sim::SolidIncrement> rows;
  std::vector<sim::SolidFrame> frames;
};

inline PlayedSolids play(const sim::SolidProblem& problem) {
  PlayedSolids played;
  sim::SolidObserver observer;
  observer.increment = [&](const sim::SolidIncrement& row) { played.rows.push_back(row); };
  observer.frame = [&](const sim::SolidFrame& frame) { played.frames.push_back(frame); };
  played.summary = sim::run_solid(problem, observer);
  return played;
}

}  // namespace reye::support
