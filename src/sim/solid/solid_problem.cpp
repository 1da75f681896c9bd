#include "sim/solid/solid_problem.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "body/solid/solid_conflicts.hpp"
#include "body/solid/solid_place.hpp"
#include "material/parameters.hpp"
#include "mesh/solid/solid_measure.hpp"
#include "scene/solid/solid_located.hpp"
#include "sim/problem/timer.hpp"
#include "sim/solid/refused_contacts.hpp"
#include "sim/solid/turn_issues.hpp"

namespace reye::sim {

namespace {

using base::Issue;
using base::quoted;

/// Puts the tables of the scene onto the bodies of the geometry.
class Preparation {
 public:
  Preparation(scene::SolidScene scene, cad::SolidGeometry geometry) {
    problem_.scene = std::move(scene);
    for (std::size_t b = 0; b < geometry.bodies.size(); ++b) add_body(b, std::move(geometry.bodies[b]));
    for (const auto& text : geometry.warnings) problem_.warnings.push_back({geometry_warning, "", text});
  }

  SolidProblem finish() {
    const auto& scene = problem_.scene;
    for (const auto& support : scene.supports) add_support(support);
    for (const auto& load : scene.loads) add_load(load);
    for (const auto& contact : scene.contacts) add_contact(contact);
    if (issues_.empty()) find_conflicts();
    if (issues_.empty()) issues_ = refused_contacts(problem_.inputs, problem_.contacts, problem_.scene.symmetry);
    if (issues_.empty()) issues_ = turn_issues(scene, problem_.inputs);
    if (!issues_.empty()) throw scene::located(scene, issues_);
    fix_centres();
    return std::move(problem_);
  }

 private:
  void add_body(std::size_t b, mesh::SolidMesh mesh) {
    const auto& scene = problem_.scene;
    const auto& options = scene.geometry.bodies[b];
    body::SolidInput input;
    input.name = options.name;
    input.rigid = options.rigid;
    if (const auto name = scene.body_material.find(options.name); !options.rigid && name != scene.body_material.end())
      input.material = scene.materials.at(name->second);
    for (const auto& [face, facets] : mesh.faces) bodies_of_face_[face].push_back(static_cast<int>(b));
    input.mesh = std::make_shared<const mesh::SolidMesh>(std::move(mesh));
    input.centre_mm = mesh::box_centre(input.mesh->X);
    problem_.inputs.push_back(std::move(input));
  }

  int body_named(const std::string& name) const {
    const auto found = std::find_if(problem_.inputs.begin(), problem_.inputs.end(),
                                    [&](const auto& input) { return input.name == name; });
    return found == problem_.inputs.end() ? -1 : static_cast<int>(found - problem_.inputs.begin());
  }

  /// The body that has a face of this name; -1 with an issue where there is none, or more than one.
  int body_of_face(const std::string& face, const std::string& key) {
    const auto found = bodies_of_face_.find(face);
    if (found != bodies_of_face_.end() && found->second.size() == 1) return found->second.front();
    issues_.push_back({key, quoted(face),
                       found == bodies_of_face_.end()
                           ? "no face has this name: neither a table [face] nor a physical surface"
                           : "several bodies have a face of this name"});
    return -1;
  }

  void add_support(const body::SolidSupport& support) {
    const std::string key = "support." + support.name;
    const int b = support.face.empty() ? body_named(support.body) : body_of_face(support.face, key + ".face");
    problem_.support_of.push_back({b, 0});
    if (b < 0) return;
    problem_.support_of.back()[1] = static_cast<int>(problem_.inputs[b].supports.size());
    problem_.inputs[b].supports.push_back(support);
  }

  /// Supports turn about the middle of their faces as drawn, whatever wears off them.
  void fix_centres() {
    for (auto& input : problem_.inputs)
      for (auto& support : input.supports) support.centre_mm = body::place_support(*input.mesh, support).centre;
  }

  void add_load(const body::SolidLoad& load) {
    const int b = load.face.empty() ? body_named(load.body) : body_of_face(load.face, "load." + load.name + ".face");
    if (b >= 0) problem_.inputs[b].loads.push_back(load);
  }

  void add_contact(const contact::SkinContactOptions& options) {
    const std::string key = "contact." + options.name;
    PlacedSkins placed{options, {}, {}, 0.0, 0.0, 0.0};
    const int own = body_of_face(options.secondary, key + ".secondary");
    placed.secondary = {own, options.secondary};
    bool found = own >= 0;
    for (const auto& face : options.primary) {
      const int other = body_of_face(face, key + ".primary");
      found = found && other >= 0;
      if (other >= 0 && other == own)
        issues_.push_back({key + ".primary", quoted(face), "lies on the body of the secondary side"});
      placed.primary.push_back({other, face});
    }
    if (!found) return;
    if (problem_.inputs[own].rigid) {
      issues_.push_back({key + ".secondary", quoted(options.secondary),
                         "its body is rigid; the secondary side lies on a body that deforms"});
      return;
    }
    measure(placed);
    note_faces(placed);
    problem_.contacts.push_back(std::move(placed));
  }

  void note_faces(const PlacedSkins& placed) {
    const auto note = [&](const contact::FaceRef& ref) {
      auto& faces = problem_.inputs[ref.body].contact_faces;
      if (std::find(faces.begin(), faces.end(), ref.face) == faces.end()) faces.push_back(ref.face);
    };
    note(placed.secondary);
    for (const auto& ref : placed.primary) note(ref);
  }

  void measure(PlacedSkins& placed) const {
    placed.modulus_MPa = std::numeric_limits<double>::infinity();
    double size = std::numeric_limits<double>::infinity();
    const auto look = [&](const contact::FaceRef& ref) {
      const auto& input = problem_.inputs[ref.body];
      if (!input.rigid) placed.modulus_MPa = std::min(placed.modulus_MPa, material::young(input.material));
      size = std::min(size, mesh::box_diagonal(input.mesh->X));
    };
    look(placed.secondary);
    for (const auto& ref : placed.primary) look(ref);
    placed.drawn_mm = drawn_distance(placed);
    placed.search_mm =
        placed.options.search_mm > 0.0 ? placed.options.search_mm : std::max(0.05 * size, 1.5 * placed.drawn_mm);
  }

  double drawn_distance(const PlacedSkins& placed) const {
    double least = std::numeric_limits<double>::infinity();
    const auto nodes = [&](const contact::FaceRef& ref) {
      return mesh::nodes_of(mesh::facets_of(*problem_.inputs[ref.body].mesh, ref.face));
    };
    const auto& own = problem_.inputs[placed.secondary.body].mesh->X;
    for (const auto& ref : placed.primary) {
      const auto& other = problem_.inputs[ref.body].mesh->X;
      const auto facing = nodes(ref);
      for (const int i : nodes(placed.secondary))
        for (const int k : facing) least = std::min(least, (own[i] - other[k]).squaredNorm());
    }
    return std::sqrt(least);
  }

  void find_conflicts() {
    for (const auto& input : problem_.inputs)
      for (const auto& conflict : body::solid_support_conflicts(input)) {
        const std::string key = "support." + input.supports[conflict.support].name;
        issues_.push_back({conflict.motion.empty() ? key : key + "." + conflict.motion, "", conflict.text});
      }
  }

  SolidProblem problem_;
  std::map<std::string, std::vector<int>> bodies_of_face_;
  std::vector<Issue> issues_;
};

}  // namespace

SolidProblem prepare_solid(scene::SolidScene scene) {
  const double start = cpu_seconds();
  cad::SolidGeometry geometry;
  try {
    geometry = cad::build_solids(scene.geometry);
  } catch (const base::InputError& error) {
    throw scene::located(scene, error.issues());
  }
  SolidProblem problem = prepare_solid(std::move(scene), std::move(geometry));
  problem.mesh_seconds = cpu_seconds() - start;
  return problem;
}

SolidProblem prepare_solid(scene::SolidScene scene, cad::SolidGeometry geometry) {
  const double start = cpu_seconds();
  SolidProblem problem = Preparation(std::move(scene), std::move(geometry)).finish();
  problem.mesh_seconds = cpu_seconds() - start;
  return problem;
}

}  // namespace reye::sim
