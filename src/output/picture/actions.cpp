#include "output/picture/actions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/formatted.hpp"
#include "mesh/measure.hpp"
#include "output/folder/text.hpp"
#include "output/picture/canvas.hpp"

namespace reye::output {

namespace {

std::string parts_in_words(const base::Parts& parts, const std::string& unit) {
  std::string words;
  for (const auto& part : parts)
    words += (words.empty() ? "" : " and ") + rounded(part.value) + ' ' + unit +
             (part.history.empty() ? "" : " × " + part.history);
  return words;
}

}  // namespace

std::string motion_in_words(const body::Motion& motion, const std::string& length, const std::string& force) {
  switch (motion.drive) {
    case body::Drive::free:
      return "free";
    case body::Drive::fixed:
      return "fixed";
    case body::Drive::moved:
      return parts_in_words(motion.parts, length);
    case body::Drive::loaded:
      break;
  }
  std::string words = body::nonzero(motion) ? parts_in_words(motion.parts, force) : "";
  if (motion.stiffness > 0.0)
    words +=
        (words.empty() ? "" : " and ") + ("a spring of " + rounded(motion.stiffness)) + ' ' + force + " per " + length;
  return words.empty() ? "free" : words;
}

namespace {

/// The middle of a boundary, and the normal there.
void place_on_edge(const mesh::Mesh& mesh, Action& action) {
  const auto found = mesh.boundaries.find(action.edge);
  if (found == mesh.boundaries.end() || found->second.empty()) return;
  const auto& chain = found->second.front();
  const std::size_t i = std::max<std::size_t>(1, chain.size() / 2);
  const Vec2 &a = mesh.X[chain[i - 1]], &b = mesh.X[chain[i]];
  action.at = 0.5 * (a + b);
  action.out = mesh::outward_normal(a, b);
}

void add_arrows(const body::Support& support, Action& action) {
  const double angle = support.angle_deg * std::numbers::pi / 180.0;
  Vec2 x(std::cos(angle), std::sin(angle));
  if (support.edge_axes) x = Vec2(action.out.y(), -action.out.x());
  const Vec2 y = support.edge_axes ? action.out : Vec2(-x.y(), x.x());
  for (const auto& [motion, axis] : {std::pair{&support.x, x}, std::pair{&support.y, y}}) {
    const bool moved = motion->drive == body::Drive::moved;
    if ((!moved && motion->drive != body::Drive::loaded) || !body::nonzero(*motion)) continue;
    double sum = 0.0;
    for (const auto& part : motion->parts) sum += part.value;
    action.arrows.emplace_back(sum < 0.0 ? Vec2(-axis) : axis, moved);
  }
}

std::vector<Action> supports_of(const sim::Problem& p) {
  const bool ring = p.scene.analysis == base::Analysis::axisymmetric;
  const std::string force = ring ? "N" : "N/mm", moment = ring ? "N mm" : "N mm/mm";
  std::vector<Action> all;
  for (std::size_t s = 0; s < p.scene.supports.size(); ++s) {
    const auto& support = p.scene.supports[s];
    Action action;
    action.body = p.support_body[s];
    action.edge = support.edge;
    if (support.point_mm)
      action.at = *support.point_mm;
    else
      place_on_edge(p.shapes[action.body]->mesh, action);
    const char *x = support.edge_axes ? "tangent " : "x ", *y = support.edge_axes ? "normal " : "y ";
    action.words = "support " + support.name + (support.edge.empty() ? " at a point" : " on " + support.edge) + ": " +
                   x + motion_in_words(support.x, "mm", force) + ", " + y + motion_in_words(support.y, "mm", force);
    if (support.rigid) action.words += ", rotation " + motion_in_words(support.rotation, "rad", moment);
    if (support.angle_deg != 0.0) action.words += base::formatted(", axes turned by %g degrees", support.angle_deg);
    add_arrows(support, action);
    all.push_back(std::move(action));
  }
  return all;
}

std::string times(const std::string& history) { return history.empty() ? "" : " × " + history; }

std::string pair_in_words(const Vec2& v) { return base::formatted("(%.4g, %.4g)", v.x(), v.y()); }

void add_loads(const sim::Problem& p, std::vector<Action>& all) {
  const char* force = p.scene.analysis == base::Analysis::axisymmetric ? "N" : "N/mm";
  for (int b = 0; b < p.body_count(); ++b) {
    const auto& input = p.inputs[b];
    Action action;
    action.colour = load_colour;
    action.body = b;
    for (const auto& load : input.boundary_loads) {
      Action one = action;
      one.edge = load.edge;
      place_on_edge(p.shapes[b]->mesh, one);
      one.words = "load " + load.name + " on " + load.edge + ":";
      if (load.pressure_MPa != 0.0) one.words += " pressure " + rounded(load.pressure_MPa) + " MPa";
      if (!load.traction_MPa.isZero()) one.words += " traction " + pair_in_words(load.traction_MPa) + " MPa";
      one.words += times(load.history);
      const Vec2 pull = load.traction_MPa - load.pressure_MPa * one.out;
      if (!pull.isZero()) one.arrows.emplace_back(pull.normalized(), false);
      all.push_back(std::move(one));
    }
    for (const auto& load : input.point_loads) {
      Action one = action;
      one.at = load.point_mm;
      one.words = "load " + load.name + ": " + pair_in_words(load.force_N_per_mm) + ' ' + force + times(load.history);
      if (!load.force_N_per_mm.isZero()) one.arrows.emplace_back(load.force_N_per_mm.normalized(), false);
      all.push_back(std::move(one));
    }
    for (const auto& load : input.body_forces) {
      Action one = action;
      const Box box = box_of(p.shapes[b]->mesh.X);
      one.at = 0.5 * (box.low + box.high);
      one.words = "load " + load.name + " in " + input.name + ": " + pair_in_words(load.force_N_per_mm3) + " N/mm³" +
                  times(load.history);
      if (!load.force_N_per_mm3.isZero()) one.arrows.emplace_back(load.force_N_per_mm3.normalized(), false);
      all.push_back(std::move(one));
    }
  }
}

}  // namespace

std::vector<Action> actions_of(const sim::Problem& p) {
  auto all = supports_of(p);
  add_loads(p, all);
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i].letter = i < 26 ? std::string(1, static_cast<char>('A' + i)) : std::to_string(i + 1);
  return all;
}

}  // namespace reye::output
