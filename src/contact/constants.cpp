#include <cmath>

#include "contact/interface.hpp"

/// What stays fixed at a node while the equations of one increment are solved.
namespace reye::contact {

namespace {

bool follows_formula(const ContactOptions& o) {
  return o.friction_formula || o.wear.secondary_formula || o.wear.primary_formula;
}

}  // namespace

/// What formulas depend on at a node. The depth of the primary side is that of its nodes, weighted as they face the
/// node.
void Interface::note_place(int node, wear::Start& start) const {
  const auto depth = [](const std::vector<double>& removed, const std::vector<double>& others, const auto& surface,
                        std::size_t k) { return (removed[k] + elsewhere(others, k)) / surface.area[k]; };
  const auto j = static_cast<std::size_t>(node);
  start.cycle = options_.cycle;
  start.path = before_->slip[j];
  start.depth_secondary = depth(before_->removed_secondary, before_->others_secondary, setup_->secondary, j);
  double weight = 0.0;
  for (const auto& [l, T] : at_.cover[j]) {
    weight += T;
    start.depth_primary +=
        T * depth(before_->removed_primary, before_->others_primary, setup_->primary, static_cast<std::size_t>(l));
  }
  if (weight > 0.0) start.depth_primary /= weight;
}

NodeConstants Interface::constants(int node) const {
  NodeConstants c;
  const auto& o = setup_->options;
  c.friction = friction_;
  if (o.friction_formula) {
    c.friction_formula = o.friction_formula;
    if (options_.held && !before_->nodal_friction.empty()) c.friction = before_->nodal_friction[node];
  }
  c.sign = decision_.sign[node];
  c.depth = start_.secondary[node];
  c.law = o.wear;
  if (!options_.wear) c.law.kind = wear::LawKind::none;
  // The energy of control points that wear with the node is stored at them: the node's density counts for all of its
  // length.
  const double worn = worn_length_[node], own = worn / setup_->secondary.area[node];
  const double spent =
      before_->energy_secondary[node] + elsewhere(options_.energy_elsewhere, static_cast<std::size_t>(node));
  c.start = {.jump = options_.jump, .duration_s = options_.duration_s, .energy = own * spent, .area = worn};
  if (follows_formula(o)) note_place(node, c.start);
  if (o.implicit_wear) c.depth_per_volume = thickness(options_.thickness_secondary, node) / worn_length_[node];
  // A side that turns by t slides by r t; its motion along the tangent at the end is r sin t.
  if (mobility_.turn != 0.0) c.arc_over_chord = mobility_.turn / std::sin(mobility_.turn);
  c.imposed = o.imposed;
  c.imposed_slip = options_.imposed_slip + options_.imposed_turn * placement_.xs_before[node].x();
  c.out_of_plane = o.out_of_plane;
  c.held = options_.held;
  c.anchor = node == options_.anchor;
  c.unmoved = decision_.unmoved[node] != 0;
  if (c.held)
    c.held_shear = options_.held_shear[node];
  else if (c.unmoved)
    c.held_shear = shear_before(node);
  if (c.held && options_.compliance > 0.0) {
    c.held_pressure = options_.held_pressure[node];
    c.compliance = options_.compliance;
  }
  return c;
}

}  // namespace reye::contact
