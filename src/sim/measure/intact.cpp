#include "sim/measure/intact.hpp"

#include <algorithm>
#include <type_traits>

#include "contact/fields.hpp"
#include "fem/element.hpp"
#include "mesh/quality.hpp"
#include "sim/problem/finite.hpp"
#include "sim/problem/intact_wear.hpp"

namespace reye::sim {

namespace {

/// Checks the mesh of any body.
void check_mesh(const mesh::Mesh& mesh, bool rigid, const std::string& body) {
  require(counted(static_cast<int>(mesh.kind), static_cast<int>(mesh::CellKind::quad8)),
          "body " + body + " has cells of no kind");
  require(mesh.cells.empty() == rigid, "body " + body + (rigid ? " is rigid and has cells" : " has no cells"));
  for (const auto& loop : mesh.outline)
    for (const int node : loop)
      require(counted(node, mesh.node_count() - 1), "the outline of body " + body + " names a node that it lacks");
  for (const int node : mesh.points)
    require(counted(node, mesh.node_count() - 1), "a point of body " + body + " is a node that it lacks");
  for (const auto& [name, origins] : mesh.arc_origin)
    for (const int node : origins)
      require(counted(node, mesh.node_count() - 1), "a boundary of body " + body + " begins at a node that it lacks");
  try {
    mesh::check(mesh);
  } catch (const base::MeshError& error) {
    require(false, "body " + body + ": " + error.what());
  }
}

void check_edge(const cad::Edge& edge, const std::string& body) {
  require(counted(static_cast<int>(edge.type), static_cast<int>(cad::EdgeType::spline)) && edge.knots.size() >= 2 &&
              (edge.tangents.size() == edge.knots.size() || edge.straight) && edge.arc.size() == edge.knots.size(),
          "a curve of body " + body + " has parts missing");
  require(finite(edge.knots) && finite(edge.tangents) && finite(edge.arc) && edge.arc.front() == 0.0 &&
              std::is_sorted(edge.arc.begin(), edge.arc.end()) && edge.arc.back() > 0.0,
          "a curve of body " + body + " leads nowhere");
}

void check_curves(const cad::Drawing& drawing, const std::string& body) {
  require(!drawing.part.loops.empty(), "body " + body + " is drawn without curves");
  for (const auto& loop : drawing.part.loops) {
    require(!loop.empty(), "body " + body + " is drawn with a loop of no curves");
    for (const auto& edge : loop) check_edge(edge, body);
  }
  for (const auto& [name, choice] : drawing.boundaries) {
    require(choice.size() == drawing.part.loops.size(),
            "a boundary of body " + body + " is drawn on loops that it lacks");
    for (std::size_t k = 0; k < choice.size(); ++k)
      require(choice[k].size() == drawing.part.loops[k].size(),
              "a boundary of body " + body + " is drawn on curves that it lacks");
  }
}

void check_drawing(const cad::Drawing& drawing, bool rigid, const std::string& body) {
  check_curves(drawing, body);
  const auto& mesh = drawing.options.mesh;
  require(counted(static_cast<int>(mesh.element), static_cast<int>(mesh::CellKind::quad8)) &&
              (mesh.order == 1 || mesh.order == 2) && finite(mesh.far_size_mm) && mesh.far_size_mm >= 0.0 &&
              finite(mesh.growth) && mesh.growth >= 1.0,
          "the mesh of body " + body + " is to be made of no elements");
  for (const auto& zone : drawing.zones)
    require(finite(zone.centre_mm) && finite(zone.half_width_mm) && finite(zone.depth_mm) && finite(zone.angle_deg) &&
                finite(zone.size_mm) && zone.size_mm > 0.0,
            "a fine zone of body " + body + " has no size");
  require(finite(drawing.options.points_mm) && (!drawing.options.at || finite(*drawing.options.at)),
          "a point of body " + body + " lies nowhere");
  if (drawing.part.mesh) check_mesh(*drawing.part.mesh, rigid, body);
}

/// Checks that the boundaries of supports, loads and contacts are those of the start.
void check_shape(const body::ShapePtr& shape, const body::ShapePtr& start, bool rigid, const std::string& body) {
  require(shape && shape->born, "body " + body + " has no shape");
  require(!shape->drawing == !start->drawing, "body " + body + " has another drawing");
  check_mesh(shape->mesh, rigid, body);
  check_mesh(*shape->born, rigid, body);
  require(shape->born->kind == shape->mesh.kind && shape->born->node_count() == shape->mesh.node_count() &&
              shape->born->cells == shape->mesh.cells,
          "body " + body + " was born as another mesh");
  require(shape->mesh.kind == start->mesh.kind, "body " + body + " has cells of another kind than at the start");
  for (const auto& [name, boundary] : start->mesh.boundaries)
    require(shape->mesh.boundaries.contains(name) && shape->born->boundaries.contains(name),
            "body " + body + " has lost its boundary " + name);
  if (shape->drawing) check_drawing(*shape->drawing, rigid, body);
}

void check_numbers_of_cycles(const State& state) {
  require(state.approached || (state.step == 0 && state.step_blocks == 0 && state.cycle == 0.0),
          "it is under way and has not begun");
  require(finite(state.cycle) && state.cycle >= 0.0 && finite(state.step_cycles) && state.step_cycles >= 0.0 &&
              state.step_blocks >= 0 && finite(state.jump) && state.jump >= 0.0 && finite(state.jump_rate) &&
              finite(state.jump_error) && finite(state.block_cycles) && finite(state.flow) &&
              (state.block_cycles == 0.0 || state.block_cycles >= 1.0),
          "its number of cycles is not a number");
}

void check_progress(const Problem& problem, const State& state) {
  const auto& steps = problem.scene.steps;
  require(counted(state.step, static_cast<int>(steps.size())), "it is in a step that the scene lacks");
  check_numbers_of_cycles(state);
  const double most = state.step < static_cast<int>(steps.size()) ? steps[state.step].cycles : 0.0;
  require(state.step_cycles <= most * (1.0 + 1e-9) + 1e-9 && state.step_cycles <= state.cycle * (1.0 + 1e-9) + 1e-9,
          "it has done more cycles than the step has");
  for (const auto& [name, factor] : state.factors)
    require(problem.scene.histories.contains(name) && finite(factor), "history " + name + " is at no factor");
  for (const auto* numbers : {&state.life_cycles, &state.life_error, &state.limit_measure, &state.limit_rate})
    for (const auto& [name, value] : *numbers)
      require(finite(value) && std::any_of(problem.scene.limits.begin(), problem.scene.limits.end(),
                                           [&](const auto& l) { return l.name == name; }),
              "limit " + name + " has no life");
  const auto& c = state.counts;
  require(c.blocks >= 0 && c.increments >= 0 && c.newton_iterations >= 0 && c.factorisations >= 0 && c.remeshes >= 0 &&
              c.cutbacks >= 0 && c.equilibrium_iterations >= 0,
          "its counts are below zero");
}

void check_statuses(const std::vector<contact::ContactStatus>& statuses) {
  for (const auto status : statuses)
    require(status <= contact::ContactStatus::slip, "a node is neither open nor sticks nor slips");
}

void check_rows(const std::vector<contact::MortarRow>& rows, int secondary, int primary) {
  for (const auto& row : rows) {
    for (const auto& [node, share] : row.off)
      require(counted(node, secondary - 1), "a contact names a node that its secondary side lacks");
    for (const auto& [node, share] : row.M)
      require(counted(node, primary - 1), "a contact names a node that its primary side lacks");
  }
}

void check_contact(const contact::ContactState& s, const contact::Setup& setup) {
  const auto secondary = static_cast<std::size_t>(setup.secondary_count()),
             primary = static_cast<std::size_t>(setup.primary_count());
  const std::string name = "contact " + setup.options.name;
  contact::for_each_field(s, [&](const contact::Field& field, const auto& member) {
    using Member = std::remove_cvref_t<decltype(member)>;
    if constexpr (std::is_arithmetic_v<Member>) {
      require(finite(member), name + " has a sum that is not a number");
    } else {
      const std::size_t count = field.site == contact::Site::secondary ? secondary : primary;
      require(field.optional ? optional(member.size(), count) : member.size() == count,
              name + " has a value too many or too few");
      if constexpr (!std::is_enum_v<typename Member::value_type>)
        require(finite(member), name + " has a value that is not a number");
    }
  });
  check_statuses(s.status);
  check_rows(s.reference, setup.secondary_count(), setup.primary_count());
}

void check_interior(const body::Interior& interior, const body::Operator& op, const mesh::Mesh& mesh,
                    const std::string& body) {
  const auto* nonlinear = std::get_if<body::NonlinearBody>(&op);
  const body::Interior start = nonlinear ? nonlinear->start() : body::Interior{};
  require(interior.y.high.size() == start.y.high.size() && interior.y.low.size() == start.y.low.size() &&
              interior.history.size() == start.history.size(),
          "body " + body + " has a value too many or too few inside");
  const std::size_t points = mesh.cells.size() * fem::stiffness_rule(mesh.kind).size();
  require(interior.F0.empty() || interior.F0.size() == points,
          "body " + body + " has a deformation too many or too few inside");
  require(finite(interior.F0), "body " + body + " has a deformation that is not a number");
  require(finite(interior.y.high) && finite(interior.y.low),
          "body " + body + " has a displacement that is not a number");
  for (const auto& point : interior.history)
    require(finite(point.strain) && finite(point.accumulated) && point.accumulated >= 0.0,
            "body " + body + " has an invalid plastic strain");
}

void check_guess(const solver::Guess& guess, const solver::System& system,
                 const std::vector<body::Interior>& interiors) {
  require(guess.dq.size() == system.dofs && finite(guess.dq) && guess.lambda.size() == system.contacts.size() &&
              guess.status.size() == system.contacts.size() && guess.inside.size() == system.bodies.size(),
          "the recalled end of an increment is impossible");
  for (std::size_t b = 0; b < interiors.size(); ++b)
    require(guess.inside[b].size() == interiors[b].y.size() && finite(guess.inside[b]),
            "the recalled end of an increment is impossible");
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto nodes = static_cast<std::size_t>(system.contacts[c].secondary_count());
    require(guess.lambda[c].size() == nodes && finite(guess.lambda[c]) && guess.status[c].size() == nodes,
            "the recalled end of an increment is impossible");
    check_statuses(guess.status[c]);
  }
}

void check_solution(const Problem& problem, const State& state, const solver::System& system) {
  const auto& s = state.solution;
  require(s.q.high.size() == system.dofs && s.q.low.size() == system.dofs && finite(s.q.high) && finite(s.q.low),
          "its displacements are not those of its meshes");
  require(s.interiors.size() == system.bodies.size() && s.contacts.size() == system.contacts.size(),
          "it has a body or a contact too many or too few");
  for (std::size_t c = 0; c < s.contacts.size(); ++c) check_contact(s.contacts[c], system.contacts[c]);
  for (std::size_t b = 0; b < s.interiors.size(); ++b)
    check_interior(s.interiors[b], system.bodies[b], state.shapes[b]->mesh, problem.inputs[b].name);
}

void check_beside(const Problem& problem, const State& state) {
  require(optional(state.renewed_at.size(), problem.scene.supports.size()) && finite(state.renewed_at),
          "the position of a support is not a number");
  require(optional(state.displaced.size(), state.shapes.size()) && finite(state.displaced),
          "the displacement of a body is not a number");
  for (std::size_t b = 0; b < state.displaced.size(); ++b)
    require(optional(state.displaced[b].size(), state.shapes[b]->mesh.X.size()),
            "a body is displaced at nodes that it lacks");
  require(optional(state.watch.size(), problem.contacts.size()), "it refers to contacts that do not exist");
  require(optional(state.bonds.size(), problem.bonds.size()), "it refers to bonds that do not exist");
  require(finite(state.small_strain_error), "its error of small strain is not a number");
}

}  // namespace

void check_state(const Problem& problem, const State& state, Cache& cache) {
  const auto bodies = static_cast<std::size_t>(problem.body_count());
  require(state.shapes.size() == bodies, "it has another number of bodies");
  for (std::size_t b = 0; b < bodies; ++b)
    check_shape(state.shapes[b], problem.shapes[b], problem.rigid[b] != 0, problem.inputs[b].name);
  check_progress(problem, state);
  check_beside(problem, state);
  const auto kept = system_of(problem, state, cache);
  const auto& system = *kept;
  if (state.approached) check_solution(problem, state, system);
  check_last_wear(state.last_wear, state.solution.contacts);
  for (const auto& [progress, guess] : state.recall.played) {
    require(counted(progress.first, 1.0) && counted(progress.second, 1.0), "an increment was played at no progress");
    check_guess(guess, system, state.solution.interiors);
  }
}

}  // namespace reye::sim
