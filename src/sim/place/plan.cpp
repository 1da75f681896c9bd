#include "sim/place/plan.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/formatted.hpp"
#include "body/turning.hpp"
#include "material/parameters.hpp"
#include "scene/choose_elements.hpp"
#include "sim/measure/drawn_gap.hpp"
#include "sim/measure/figures.hpp"
#include "sim/measure/renewable.hpp"
#include "sim/measure/shared_wear.hpp"
#include "sim/measure/small_strain.hpp"
#include "sim/place/widen_zones.hpp"
#include "sim/problem/drive.hpp"

namespace reye::sim {

namespace {

const char* cell_name(mesh::CellKind kind) {
  switch (kind) {
    case mesh::CellKind::tri3:
      return "triangles";
    case mesh::CellKind::quad4:
      return "quads";
    case mesh::CellKind::tri6:
      return "triangles of second order";
    case mesh::CellKind::quad8:
      break;
  }
  return "quads of second order";
}

const char* law_name(const material::Material& material) {
  constexpr const char* names[] = {"linear elastic", "St Venant-Kirchhoff", "neo-Hookean", "Hencky",
                                   "Hencky with J2 plasticity"};
  return names[material.index()];
}

/// Reports why a body that leaves its kinematics to the run has small or finite strain.
void tell_kinematics(const Problem& p, int b, Plan& plan) {
  if (!p.kinematics[b]) return;
  const auto& [largest, failure] = *p.kinematics[b];
  const bool finite = p.inputs[b].kinematics == base::Kinematics::finite;
  const std::string start = "  kinematics auto: " + std::string(finite ? "finite strain, for " : "small strain, for ");
  if (!failure.empty() && largest.error() <= small_strain_bound)
    plan.lines.push_back(start + "the trial at small strain failed: " + failure);
  else
    plan.lines.push_back(start +
                         base::formatted("the estimated error of small strain is %.2g %%%s (strain %.2g %% + rotation "
                                         "%.2g %%), bound %g %%",
                                         100.0 * largest.error(), finite ? " or more" : "", 100.0 * largest.strain,
                                         100.0 * largest.rotation, 100.0 * small_strain_bound));
}

/// Whether wear moves the boundary of a body.
bool wears(const Problem& p, int b) {
  return p.scene.shape && std::any_of(p.contacts.begin(), p.contacts.end(), [&](const PlacedContact& contact) {
           const auto here = [b](const contact::BoundaryRef& ref) { return ref.body == b; };
           const auto& wear = contact.options.wear;
           return (wear.secondary > 0.0 && here(contact.secondary)) ||
                  (wear.primary > 0.0 && std::any_of(contact.primary.begin(), contact.primary.end(), here));
         });
}

/// The purpose for which displacements inside a linear body are recovered.
std::string solved_back_for(const Problem& p, int b) {
  const bool triggers = wears(p, b) && p.scene.remesh.automatic, estimate = p.kinematics[b].has_value();
  const auto& output = p.scene.output;
  std::string uses = output.frames.paraview ? "only for frames" : output.probes.empty() ? "never" : "only for probes";
  if (triggers || estimate)
    uses += (uses == "never" ? " but, at most once a block, for " : " and, at most once a block, for ");
  if (triggers) uses += "the triggers of remeshing";
  if (estimate) uses += triggers ? " and the estimate of small strain" : "the estimate of small strain";
  return uses;
}

/// Reports the pivot of a linear body, or why its rotation is taken as small.
void tell_turning(const Problem& p, const body::LinearBody& linear, int b, Plan& plan) {
  const auto& mesh = p.shapes[b]->mesh;
  if (linear.turning()) {
    const auto pivot = body::pivot_of(mesh, p.inputs[b]);
    plan.lines.push_back(
        base::formatted("  turns by any angle about (%.6g, %.6g) mm, ", pivot->centre.x(), pivot->centre.y()) +
        (pivot->support >= 0 ? "where support " + p.inputs[b].supports[pivot->support].name + " is"
                             : "guided by contact alone"));
  } else if (const std::string support = body::keeps_direction(mesh, p.inputs[b]); !support.empty()) {
    plan.lines.push_back("  its rotation is taken as small: support " + support +
                         " acts along a fixed direction; kinematics = \"finite\" lets it turn");
  }
}

void tell_rigid(const std::string& name, const mesh::Mesh& mesh, Plan& plan) {
  plan.lines.push_back(base::formatted("body %s: rigid, outline of %d nodes, 3 dofs", name.c_str(), mesh.node_count()));
  plan.skipped.push_back("body " + name + " is rigid: no elements, no stiffness");
}

void tell_nonlinear(const Problem& p, const body::NonlinearBody& body, int b, Plan& plan) {
  const auto& [name, mesh] = std::tie(p.inputs[b].name, p.shapes[b]->mesh);
  const bool finite = p.inputs[b].kinematics == base::Kinematics::finite;
  plan.lines.push_back(base::formatted("body %s: %s, %s strain, %d %s, %d dofs condensed to %d in every iteration",
                                       name.c_str(), law_name(p.inputs[b].material), finite ? "finite" : "small",
                                       mesh.cell_count(), cell_name(mesh.kind), body.full_dofs(), body.dofs()));
  if (finite && !can_renew(p, b))
    plan.skipped.push_back(
        "body " + name +
        " keeps its reference configuration even if deformation degrades its elements: it wears, or loads or "
        "supports are counted on the shape it started from");
  if (body.symmetric()) plan.skipped.push_back("body " + name + " has a symmetric tangent: half of it is factorised");
  if (!material::has_history(p.inputs[b].material)) plan.skipped.push_back("body " + name + " is elastic: no history");
}

void tell_linear(const Problem& p, const body::LinearBody& linear, int b, Plan& plan) {
  const auto& [name, mesh] = std::tie(p.inputs[b].name, p.shapes[b]->mesh);
  plan.lines.push_back(base::formatted("body %s: linear elastic, small strain, %d %s, %d dofs condensed to %d",
                                       name.c_str(), mesh.cell_count(), cell_name(mesh.kind), linear.full_dofs(),
                                       linear.dofs()));
  tell_turning(p, linear, b, plan);
  plan.skipped.push_back("body " + name + " is linear: factorised once per shape, interior solved back " +
                         solved_back_for(p, b));
}

void tell_body(const Problem& p, const solver::System& system, int b, Plan& plan) {
  if (p.rigid[b])
    tell_rigid(p.inputs[b].name, p.shapes[b]->mesh, plan);
  else if (const auto* body = std::get_if<body::NonlinearBody>(&system.bodies[b]))
    tell_nonlinear(p, *body, b, plan);
  else
    tell_linear(p, std::get<body::LinearBody>(system.bodies[b]), b, plan);
}

std::string friction_of(const contact::ContactOptions& o) {
  const auto& table = o.friction_over_cycles;
  if (o.friction_formula) return "friction " + o.friction_formula.text();
  if (table.empty()) return base::formatted("friction %g", o.friction);
  return base::formatted("friction from %g at cycle %g to %g at cycle %g (%d values)", table.front()[1],
                         table.front()[0], table.back()[1], table.back()[0], static_cast<int>(table.size()));
}

std::string wear_of(const wear::Law& law) {
  if (law.kind == wear::LawKind::none) return "no wear";
  std::string words = law.kind == wear::LawKind::energy    ? "wear by dissipated energy"
                      : law.kind == wear::LawKind::archard ? "wear by Archard's law"
                                                           : "wear by a rate per sliding distance";
  if (law.secondary_formula) words += ", secondary " + law.secondary_formula.text();
  if (law.primary_formula) words += ", primary " + law.primary_formula.text();
  if (law.threshold > 0.0) words += base::formatted(" beyond %g mJ/mm^2", law.threshold);
  if (law.pressure_exponent != 0.0)
    words += base::formatted(" x (pressure / %g MPa)^%g", law.pressure_ref, law.pressure_exponent);
  if (law.speed_exponent != 0.0) words += base::formatted(" x (speed / %g mm/s)^%g", law.speed_ref, law.speed_exponent);
  return words;
}

std::string blocks_of(const Problem& p, const scene::Step& step) {
  if (step.jump_tolerance == 0.0) {
    const bool parts = step.wear && step.jump > 1.0 && may_yield(p);
    return base::formatted("of %g%s", step.jump,
                           parts ? " (the first in parts that double, from one cycle on, while a body yields)" : "");
  }
  return base::formatted("chosen for an error of %g %%, the first of %g", 100.0 * step.jump_tolerance, step.jump);
}

/// Whether some of its nodes lie on linear bodies, where those out of reach need not be iterated on.
bool condenses(const Problem& p, const contact::Setup& setup) {
  const auto linear = [&](const contact::SurfaceNode& node) {
    return !p.rigid[node.body] && !is_nonlinear(p.inputs[node.body]);
  };
  return std::any_of(setup.secondary_nodes.begin(), setup.secondary_nodes.end(), linear) ||
         std::any_of(setup.primary_nodes.begin(), setup.primary_nodes.end(), linear);
}

/// Why no node of a contact sticks, if none does.
void tell_sliding(const contact::ContactOptions& o, Plan& plan) {
  if (o.friction == 0.0)
    plan.skipped.push_back("contact " + o.name + " is frictionless: no node sticks, its shear is zero");
  else if (o.out_of_plane)
    plan.skipped.push_back("contact " + o.name +
                           " slides out of the plane: no node sticks, its shear in the plane is zero");
  else if (o.imposed)
    plan.skipped.push_back("contact " + o.name + " has its sliding imposed: no node sticks");
}

void tell_contact(const Problem& p, const contact::Setup& setup, Plan& plan) {
  const auto& o = setup.options;
  plan.lines.push_back(base::formatted("contact %s: %d secondary nodes on %s, %d primary nodes, %s, %s", o.name.c_str(),
                                       setup.secondary_count(), o.secondary.c_str(), setup.primary_count(),
                                       friction_of(o).c_str(), wear_of(o.wear).c_str()));
  tell_sliding(o, plan);
  if (condenses(p, setup))
    plan.skipped.push_back("contact " + o.name +
                           ": nodes far from where it touches are condensed out until it comes near");
  if (!o.wear.wears())
    plan.skipped.push_back("contact " + o.name + " does not wear: no shape step");
  else if (!p.scene.shape)
    plan.skipped.push_back("shape = \"off\": wear stays in the gap, no shape step");
  else if (outlines_may_wait(p))
    plan.skipped.push_back("contact " + o.name +
                           ": no shape step until its wear is a hundredth of a facet deep, or is shown");
  if (o.wear.wears() && o.wear.primary == 0.0)
    plan.skipped.push_back("contact " + o.name + ": the primary side does not wear");
}

void tell_bond(const contact::Setup& setup, Plan& plan) {
  const auto& o = setup.options;
  plan.lines.push_back(base::formatted("bond %s: %d secondary nodes on %s, %d primary nodes, neither opens nor slips",
                                       o.name.c_str(), setup.secondary_count(), o.secondary.c_str(),
                                       setup.primary_count()));
}

void tell_remeshing(const Problem& p, Plan& plan) {
  if (p.scene.remesh.every_blocks > 0) return;
  bool possible = false;
  for (int b = 0; b < p.body_count(); ++b) possible = possible || (!p.rigid[b] && (wears(p, b) || can_renew(p, b)));
  if (!p.scene.remesh.automatic)
    plan.skipped.push_back("remesh.automatic = false: no trigger is evaluated, no body is remeshed");
  else if (!possible)
    plan.skipped.push_back("no boundary moves by wear and no reference may be renewed: no body is remeshed");
}

void tell_output(const Problem& p, Plan& plan) {
  const auto& [per_step, cycles, blocks, decade, remeshes, increments, last_block, paraview] = p.scene.output.frames;
  if (!paraview)
    plan.skipped.push_back("no files for ParaView: frames are rows of the surface tables alone");
  else if (per_step == 0 && cycles == 0.0 && blocks == 0 && decade == 0 && !remeshes && !increments && !last_block)
    plan.skipped.push_back("frames only of the start and of the end of each step: stress is recovered only there");
  const auto passes = [&](const scene::Step& step) {
    return step.cycles > 0.0 && (step.jump_tolerance > 0.0 || std::fmod(cycles, step.jump) != 0.0);
  };
  if (cycles > 0.0 && std::any_of(p.scene.steps.begin(), p.scene.steps.end(), passes))
    plan.skipped.push_back(
        base::formatted("frames every %g cycles come at the ends of blocks: a block under a tolerance ends at such a "
                        "cycle where one is near and passes over others, a fixed one ends where it ends",
                        cycles));
  if (const int n = p.scene.output.history_every_blocks; n > 1)
    plan.skipped.push_back(base::formatted("history: rows of every %dth block of a step, of its first and last", n));
}

void tell_step(const Problem& p, const scene::Step& step, Plan& plan) {
  const auto increments = static_cast<int>(increment_ends(p.scene, step).size());
  std::string more = step.wear ? "" : ", no wear";
  if (step.level != 1.0) more += base::formatted(", its factors times %g", step.level);
  if (step.cycles > 0.0)
    plan.lines.push_back(base::formatted("step \"%s\": %g cycles in blocks %s, %d increments a cycle%s",
                                         step.name.c_str(), step.cycles, blocks_of(p, step).c_str(), increments,
                                         more.c_str()));
  else
    plan.lines.push_back(base::formatted("step \"%s\": %d increments%s", step.name.c_str(), increments, more.c_str()));
}

void tell_history(const std::string& name, const scene::Measured& measured, Plan& plan) {
  plan.lines.push_back(base::formatted(
      "history \"%s\": %zu of the %zu points of %s; straight lines between them stay within %g %% of its range, and "
      "their way up and down is %.3g %% shorter",
      name.c_str(), measured.corners.size(), measured.points, measured.file.c_str(), 100.0 * measured.tolerance,
      100.0 * measured.way_lost));
}

void tell_limit(const scene::Limit& limit, Plan& plan) {
  if (!limit.wear_factor) return;
  plan.lines.push_back(
      base::formatted("limit \"%s\": all wear coefficients times %g to %g; the band is life / factor, since one step "
                      "wears, without threshold and at constant friction: its states depend on coefficient x cycles "
                      "alone",
                      limit.name.c_str(), (*limit.wear_factor)[0], (*limit.wear_factor)[1]));
}

}  // namespace

Plan make_plan(const Problem& p, const solver::System& system) {
  Plan plan;
  for (int b = 0; b < p.body_count(); ++b) {
    tell_body(p, system, b, plan);
    for (auto& line : widened_zones(p, b)) plan.lines.push_back(std::move(line));
    tell_kinematics(p, b, plan);
  }
  for (const auto& choice : scene::element_choices(p.scene)) plan.lines.push_back(scene::in_words(p.scene, choice));
  for (std::size_t c = 0; c < p.contacts.size(); ++c) {
    tell_contact(p, system.contacts[c], plan);
    plan.lines.push_back(in_words(p, p.contacts[c]));
  }
  for (auto& line : told_shared(p)) plan.lines.push_back(std::move(line));
  for (std::size_t b = 0; b < p.bonds.size(); ++b) tell_bond(system.contacts[p.contacts.size() + b], plan);
  for (const auto& [name, measured] : p.scene.measured) tell_history(name, measured, plan);
  for (const auto& step : p.scene.steps) tell_step(p, step, plan);
  tell_remeshing(p, plan);
  tell_output(p, plan);
  for (const auto& limit : p.scene.limits) tell_limit(limit, plan);
  return plan;
}

}  // namespace reye::sim
