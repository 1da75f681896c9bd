#include "stability/solid_members.hpp"

#include <algorithm>
#include <cstdio>

namespace reye::test {

namespace {

using mesh::SolidKind;
using SolidTable = std::vector<SolidMember>;

constexpr std::array kind_names{"tet4", "tet10", "hex8"};

std::string kind_name(SolidKind kind) {
  const auto at = std::find(support::solid_kinds.begin(), support::solid_kinds.end(), kind);
  return kind_names[static_cast<std::size_t>(at - support::solid_kinds.begin())];
}

SolidMember flat_solid(const std::string& group, const std::string& name) {
  SolidMember m;
  m.group = group;
  m.name = name;
  return m;
}

/// Radius of contact about 0.1 mm, three to four elements.
SolidMember crowned_solid(const std::string& group, const std::string& name) {
  SolidMember m = flat_solid(group, name);
  m.crown_mm = 5.0;
  m.upper_parts = {10, 10, 3};
  m.lower_parts = {14, 14, 3};
  m.press_mm = 3e-3;
  m.slide_mm = 2e-3;
  return m;
}

template <class Value>
std::string named(const std::string& what, Value value) {
  char text[64];
  std::snprintf(text, sizeof text, "%s_%g", what.c_str(), static_cast<double>(value));
  return text;
}

void add_friction(SolidTable& t) {
  for (const double mu : {0.0, 0.1, 0.6, 1.0, 1.5}) {
    t.push_back(flat_solid("friction", named("flat_mu", mu)));
    t.back().mu = mu;
    t.push_back(crowned_solid("friction", named("crowned_mu", mu)));
    t.back().mu = mu;
  }
}

void add_meshes(SolidTable& t) {
  for (const bool lower_is_secondary : {true, false})
    for (const bool lower_is_fine : {true, false}) {
      t.push_back(flat_solid("mesh", std::string("one_to_ten_") + (lower_is_fine ? "fine" : "coarse") + "_lower_" +
                                         (lower_is_secondary ? "secondary" : "primary")));
      t.back().lower_is_secondary = lower_is_secondary;
      t.back().lower_parts = lower_is_fine ? std::array{15, 15, 2} : std::array{2, 2, 1};
      t.back().upper_parts = lower_is_fine ? std::array{1, 1, 1} : std::array{13, 13, 1};
    }
  t.push_back(flat_solid("mesh", "on_a_plate_of_one_facet"));  // whose nodes are far from the contact
  t.back().lo = {-6.0, -6.0, 0.0};
  t.back().hi = {6.0, 6.0, 0.5};
  t.back().upper_parts = {1, 1, 1};
  t.back().rigid_upper = true;
  for (const SolidKind lower : support::solid_kinds)
    for (const SolidKind upper : support::solid_kinds) {
      t.push_back(flat_solid("mesh", kind_name(upper) + "_on_" + kind_name(lower)));
      t.back().lower = lower;
      t.back().upper = upper;
    }
  for (const SolidKind kind : support::solid_kinds)
    for (const double noise : {0.1, 0.2}) {
      t.push_back(crowned_solid("distorted", named(kind_name(kind) + "_noise", noise)));
      t.back().lower = t.back().upper = kind;
      if (kind != SolidKind::hex8) t.back().lower_parts = t.back().upper_parts = {8, 8, 2};
      t.back().noise = noise;
    }
  for (const bool crowned : {false, true}) {
    t.push_back(crowned ? crowned_solid("mesh", "crowned_linear") : flat_solid("mesh", "flat_linear"));
    t.back().lower = t.back().upper = SolidKind::tet10;
    if (crowned) t.back().lower_parts = t.back().upper_parts = {8, 8, 2};
    t.back().linear = true;
  }
}

void add_edges(SolidTable& t) {
  for (const auto& [name, shift] : std::array<std::pair<const char*, double>, 5>{{{"edges_meet", 0.2},
                                                                                  {"edges_meet_to_1e-12", 0.2 + 1e-12},
                                                                                  {"edges_meet_to_1e-7", 0.2 + 1e-7},
                                                                                  {"edges_overhang", 0.21},
                                                                                  {"half_over", 0.5}}}) {
    t.push_back(flat_solid("edge", name));
    t.back().lo.x() += shift;
    t.back().hi.x() += shift;
  }
  for (const double mu : {0.3, 1.0}) {
    t.push_back(flat_solid("edge", named("drops_off_mu", mu)));
    t.back().mu = mu;
    t.back().slide_mm = 0.7;
    t.back().increments = 16;
    t.push_back(crowned_solid("edge", named("crowned_drops_off_mu", mu)));
    t.back().mu = mu;
    t.back().lo.x() += 0.5;
    t.back().hi.x() += 0.5;
    t.back().slide_mm = 0.2;
    t.back().increments = 16;
  }
  t.push_back(flat_solid("edge", "leaves_its_primary"));
  t.back().lower_is_secondary = false;
  t.back().slide_mm = 0.7;
  t.back().increments = 16;
}

void add_gaps(SolidTable& t) {
  for (const double gap : {1e-12, 1e-9, 1e-5, 9e-4, 0.02, -1e-4}) {
    t.push_back(flat_solid("gap", named("gap", gap)));
    t.back().gap_mm = gap;
    if (gap > 1e-2) t.back().press_mm += gap;
  }
  for (const double mu : {0.0, 0.3, 1.0}) {
    t.push_back(flat_solid("lift", named("flat_mu", mu) + "_lifted"));
    t.back().mu = mu;
    t.back().path = SolidPath::lift;
    t.push_back(crowned_solid("lift", named("crowned_mu", mu) + "_lifted"));
    t.back().mu = mu;
    t.back().path = SolidPath::lift;
  }
}

void add_ways(SolidTable& t) {
  for (const double mu : {0.1, 0.5, 1.2}) {
    t.push_back(flat_solid("round", named("flat_mu", mu) + "_round"));
    t.back().mu = mu;
    t.back().path = SolidPath::round;
    t.back().increments = 16;
    t.push_back(crowned_solid("round", named("crowned_mu", mu) + "_round"));
    t.back().mu = mu;
    t.back().path = SolidPath::round;
    t.back().increments = 16;
  }
  t.push_back(flat_solid("way", "in_four_increments"));
  t.back().increments = 4;
  t.back().slide_mm = 0.1;
  t.push_back(crowned_solid("way", "crowned_in_four_increments"));
  t.back().increments = 4;
  t.back().slide_mm = 0.1;
}

void add_materials(SolidTable& t) {
  for (const double ratio : {1e-6, 1e-3, 1e3, 1e6}) {
    t.push_back(flat_solid("stiffness", named("upper_E_times", ratio)));
    t.back().E_upper *= ratio;
    if (ratio > 1e5) t.back().balance = 1e-9;  // round-off of the stiff body's own motion
  }
  for (const bool lower_is_secondary : {true, false}) {
    t.push_back(crowned_solid("stiffness", lower_is_secondary ? "rigid_upper" : "rigid_secondary"));
    t.back().rigid_upper = true;
    t.back().lower_is_secondary = lower_is_secondary;
  }
  for (const double nu : {0.0, 0.45, 0.49}) {
    t.push_back(crowned_solid("stiffness", named("nu", nu)));
    t.back().nu = nu;
  }
}

void add_loads(SolidTable& t) {
  t.push_back(flat_solid("load", "pressed_by_a_force"));
  t.back().force_N = -50.0;
  t.push_back(crowned_solid("load", "crowned_pressed_by_a_force"));
  t.back().force_N = -20.0;
  t.push_back(flat_solid("load", "pulled_away"));
  t.back().force_N = 10.0;
  t.back().refusal = "neither supports nor contact hold";
}

void add_units(SolidTable& t) {
  for (const auto& [length, force] :
       {std::array{1e-3, 1.0}, std::array{1e3, 1.0}, std::array{1.0, 1e6}, std::array{1e-3, 1e-6}}) {
    t.push_back(crowned_solid("units", named("length", length) + named("_force", force)));
    t.back().mu = 0.6;
    t.back().length = length;
    t.back().force = force;
    t.back().like = "crowned_mu_0.6";
  }
}

SolidTable all_solid_members() {
  SolidTable t;
  for (const auto add : {add_friction, add_meshes, add_edges, add_gaps, add_ways, add_materials, add_loads, add_units})
    add(t);
  return t;
}

}  // namespace

const std::vector<SolidMember>& solid_members() {
  static const SolidTable table = all_solid_members();
  return table;
}

std::vector<SolidMember> worn_solid_members() {
  std::vector<SolidMember> worn;
  for (SolidMember m : solid_members()) {
    if (!m.refusal.empty() || !m.like.empty() || m.linear || m.length != 1.0 || m.force != 1.0) continue;
    m.name += "_worn";
    m.wear_per_MPa = 2e-8 * 2e5 / std::max(m.E_lower, m.rigid_upper ? 0.0 : m.E_upper);
    worn.push_back(m);
  }
  return worn;
}

std::vector<SolidMember> remeshed_solid_members() {
  std::vector<SolidMember> remeshed;
  for (SolidMember m : worn_solid_members()) {
    for (auto* kind : {&m.lower, &m.upper})
      if (*kind == mesh::SolidKind::hex8) *kind = mesh::SolidKind::tet4;
    m.name += "_and_remeshed";
    m.remesh_every = 1;
    remeshed.push_back(m);
  }
  return remeshed;
}

}  // namespace reye::test
