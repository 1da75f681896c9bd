#include "sim/place/place.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "body/resultant.hpp"
#include "cad/build/geometry.hpp"
#include "mortar/inset.hpp"
#include "scene/read.hpp"
#include "sim/measure/corners.hpp"
#include "sim/measure/drawn_gap.hpp"
#include "sim/measure/overlap.hpp"
#include "sim/measure/shared_wear.hpp"
#include "sim/measure/sizes.hpp"
#include "sim/place/bonds.hpp"
#include "sim/place/held.hpp"
#include "sim/place/joints.hpp"
#include "sim/place/points.hpp"
#include "sim/place/profiles.hpp"
#include "sim/place/resolver.hpp"
#include "sim/place/warn_setup.hpp"
#include "sim/place/widen_zones.hpp"
#include "sim/problem/drive.hpp"
#include "sim/problem/scene_line.hpp"
#include "sim/problem/timer.hpp"
#include "sim/problem/warnings.hpp"

namespace reye::sim {

namespace {

using base::Issue;

void place_supports(Problem& p, Resolver& resolve) {
  for (auto support : p.scene.supports) {
    int body = -1;
    if (support.point_mm) {
      body = resolve.body_at(support.body, *support.point_mm);
    } else {
      const auto ref = resolve.boundary(support.edge, "support." + support.name + ".edge");
      body = ref.body;
      support.edge = ref.boundary;
    }
    if (body >= 0) {
      p.inputs[body].supports.push_back(support);
      p.support_of[body].push_back(static_cast<int>(p.support_body.size()));
    }
    p.support_body.push_back(body);
  }
}

void place_loads(Problem& p, Resolver& resolve) {
  for (auto load : p.scene.boundary_loads) {
    const auto ref = resolve.boundary(load.edge, "load." + load.name + ".edge");
    load.edge = ref.boundary;
    if (ref.body >= 0) p.inputs[ref.body].boundary_loads.push_back(load);
  }
  for (const auto& load : p.scene.point_loads)
    if (const int b = resolve.body_at(load.body, load.point_mm); b >= 0) p.inputs[b].point_loads.push_back(load);
  for (const auto& load : p.scene.body_forces)
    if (const int b = resolve.body_at(load.body, Vec2::Zero()); b >= 0) p.inputs[b].body_forces.push_back(load);
}

/// Whether a whole facet of a boundary lies between nodes of the list.
bool has_facet_between(const mesh::Boundary& boundary, const std::vector<int>& list) {
  const std::set<int> nodes(list.begin(), list.end());
  for (const auto& chain : boundary)
    for (std::size_t i = 1; i < chain.size(); ++i)
      if (nodes.contains(chain[i - 1]) && nodes.contains(chain[i])) return true;
  return false;
}

void check_secondary_edges(const Problem& p, std::vector<Issue>& issues) {
  for (const auto& contact : p.contacts) {
    const auto& mesh = p.shapes[contact.secondary.body]->mesh;
    for (const auto& support : p.inputs[contact.secondary.body].supports) {
      if (!support.rigid || support.edge.empty()) continue;
      const auto held = mesh::nodes_of(mesh.boundaries.at(support.edge));
      // A shared end node carries no multiplier; a whole facet on the rigid edge could not take part.
      if (has_facet_between(mesh.boundaries.at(contact.secondary.boundary), held))
        issues.push_back(
            {"contact." + contact.options.name + ".secondary", base::quoted(contact.options.secondary),
             "lies on the rigid edge of support " + base::quoted(support.name) + "; its nodes must be free to move"});
    }
  }
}

std::string shown(double x) { return base::formatted("%.4g", x); }

/// The sides of a contact at the start; an overlap that is let in is not there yet.
mortar::Placement placed_at_start(const contact::Setup& setup, const DrawnGap& drawn) {
  mortar::Placement place;
  place.secondary = &setup.secondary;
  place.primary = &setup.primary;
  place.xs = place.xs_before = setup.secondary.X;
  place.xm = setup.primary.X;
  if (drawn.let_in) place.xm = mortar::inset(setup.primary, place.xm, drawn.overlap_mm);
  place.xm_before = place.xm;
  place.cut = setup.cut;
  place.analysis = setup.analysis;
  place.search = setup.search;
  return place;
}

void check_facing(const Problem& p, const solver::System& system, std::vector<Issue>& issues) {
  mortar::Integrator integrator;
  for (std::size_t c = 0; c < p.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    if (integrator.values(placed_at_start(setup, p.contacts[c].drawn)).empty())
      issues.push_back({"contact." + setup.options.name, "",
                        "no facet of the secondary side faces a primary one within search_mm = " + shown(setup.search) +
                            why_out_of_reach(p, p.contacts[c], setup.search)});
  }
}

body::BodyInput body_input(const scene::Scene& scene, const cad::BodyOptions& body) {
  body::BodyInput input;
  input.name = body.name;
  input.analysis = scene.analysis;
  if (body.rigid) return input;
  take_material(scene, input);
  input.b_bar = scene.body_material.at(body.name).b_bar.value_or(body.mesh.element == mesh::CellKind::quad4 &&
                                                                 scene.analysis != base::Analysis::plane_stress);
  return input;
}

void refuse(const std::vector<Issue>& issues) {
  if (!issues.empty()) throw base::InputError(issues);
}

/// Steps whose rotations would take more increments than any run plays.
void refuse_endless_steps(const scene::Scene& scene) {
  refuse(endless_steps(scene.steps, [&](const scene::Step& step) { return increments_of(scene, step); }));
}

void warn_of_open_reader(const cad::Geometry& geometry, std::vector<Warning>& warnings) {
  if (geometry.guarded) return;
  warn(warnings, {"geometry", "",
                  "this system has no filter of system calls (seccomp) for the program that reads geometry files: "
                  "it is limited only by the commands that scripts may use, and in time and memory"});
}

void place_bodies(Problem& p, cad::Geometry& geometry) {
  for (std::size_t b = 0; b < geometry.bodies.size(); ++b) {
    const auto& options = p.scene.geometry.bodies[b];
    p.shapes.push_back(body::make_shape(std::move(geometry.bodies[b]),
                                        std::make_shared<const cad::Drawing>(std::move(geometry.drawings[b]))));
    p.rigid.push_back(options.rigid);
    p.inputs.push_back(body_input(p.scene, options));
    p.inputs.back().centre = body::box_centre(p.shapes.back()->mesh);
    const bool left_to_run = !options.rigid && !p.scene.body_material.at(options.name).kinematics;
    p.kinematics.push_back(left_to_run ? std::optional<KinematicsChoice>(std::in_place) : std::nullopt);
  }
  p.support_of.resize(p.inputs.size());
}

/// Puts what the scene names onto the bodies; refuses what is not found there.
void place_on_bodies(Problem& p, const std::vector<cad::BodyFacts>& facts) {
  Resolver resolve(p.scene, p.shapes, facts);
  place_supports(p, resolve);
  place_loads(p, resolve);
  place_joints(p, "contact", p.scene.contacts, resolve, p.contacts);
  place_joints(p, "bond", p.scene.bonds, resolve, p.bonds);
  for (auto& issue : points_outside(p)) resolve.issues.push_back(std::move(issue));
  refuse(resolve.issues);
}

void add_issues(std::vector<Issue>& issues, std::vector<Issue> more) {
  for (auto& issue : more) issues.push_back(std::move(issue));
}

/// Refuses what cannot be played, judged by the drawing.
void check_drawn(Problem& p) {
  std::vector<Issue> issues;
  check_secondary_edges(p, issues);
  add_issues(issues, shared_wear_issues(p));
  add_issues(issues, unheld_issues(p));
  add_issues(issues, support_conflicts(p));
  add_issues(issues, place_drawn_gaps(p));
  refuse(issues);
}

/// Refuses what cannot be played, judged by the equations at the start.
void check_at_start(const Problem& p, Cache& cache) {
  std::vector<Issue> issues;
  const auto kept = timed_system(p, initial_state(p), cache);
  const auto& system = *kept;
  check_facing(p, system, issues);
  add_issues(issues, bond_issues(p, system));
  add_issues(issues, corner_issues(p, system));
  refuse(issues);
}

void tell_halves(const std::vector<cad::BodyFacts>& all, Plan& plan) {
  for (const auto& facts : all)
    if (facts.halved)
      plan.lines.push_back("body " + facts.name +
                           ": its file has the whole section through the axis; the half x >= 0 is taken");
}

}  // namespace

void take_material(const scene::Scene& scene, body::BodyInput& input) {
  const auto& choice = scene.body_material.at(input.name);
  input.material = scene.materials.at(choice.material);
  input.kinematics = choice.kinematics.value_or(base::Kinematics::small);
  if (input.kinematics == base::Kinematics::finite)
    if (const auto* linear = std::get_if<material::LinearElastic>(&input.material))
      input.material = material::Hencky{linear->E_MPa, linear->nu};
}

Problem place(const scene::Scene& scene, Cache& cache) {
  refuse_endless_steps(scene);
  Problem p;
  p.scene = scene;
  for (const auto& text : scene.warnings) p.warnings.push_back({"scene", "", text});
  warn_of_steps(scene, p.warnings);
  cad::Geometry geometry = cad::build(scene.geometry);
  warn_of_open_reader(geometry, p.warnings);
  place_bodies(p, geometry);
  place_on_bodies(p, geometry.facts);
  keep_directions(p);
  warn_of_sizes(p);
  warn_of_profiles(p);
  widen_zones(p);
  warn_of_points(p);
  check_drawn(p);
  const double before = cpu_seconds();
  check_at_start(p, cache);
  for (auto& warning : overlap_warnings(p, p.shapes, {})) warn(p.warnings, std::move(warning));
  tell_halves(geometry.facts, p.plan);
  cache.cpu_s += cpu_seconds() - before;
  return p;
}

}  // namespace reye::sim
