#include <algorithm>

#include "scene/solid/build_solid.hpp"

namespace reye::scene {

namespace {

constexpr std::string_view volume_force = "force_N_per_mm3";

/// What one part of a load on a face, or of a body force, must and may hold.
void check_solid_part(const Entry& part, bool on_face, Issues& issues) {
  const std::initializer_list<std::string_view> of_face = {"pressure_MPa", "traction_MPa", "force_N"};
  const auto given = [&](auto key) { return part.given(key); };
  if (!on_face) {
    refuse(part, of_face, "does not go with body", issues);
    if (!part.given(volume_force)) issues.push_back({part.key(volume_force), "", "missing"});
    return;
  }
  refuse(part, {volume_force}, "does not go with face", issues);
  if (std::none_of(of_face.begin(), of_face.end(), given))
    issues.push_back({part.key(), "", "needs pressure_MPa, traction_MPa or force_N"});
}

body::SolidLoad solid_load_of(const Entry& load, const Entry& part) {
  const base::Vec3 none = base::Vec3::Zero();
  return {.name = load.name(),
          .face = load.text("face"),
          .body = load.text("body"),
          .pressure_MPa = part.number("pressure_MPa"),
          .traction_MPa = part.triple("traction_MPa").value_or(none),
          .force_N = part.triple("force_N").value_or(none),
          .force_N_per_mm3 = part.triple(volume_force).value_or(none),
          .history = part.text("history")};
}

}  // namespace

std::vector<body::SolidLoad> solid_loads_of(const Entry& root, Issues& issues) {
  std::vector<body::SolidLoad> loads;
  for (const auto& entry : root.all("load")) {
    const bool placed = exactly_one_of_solids(entry, {"face", "body"}, {"edge", "point_mm"}, issues);
    for (const auto& part : parts_of(entry, {"pressure_MPa", "traction_MPa", "force_N", volume_force}, issues)) {
      if (placed) check_solid_part(part, entry.given("face"), issues);
      loads.push_back(solid_load_of(entry, part));
    }
  }
  return loads;
}

}  // namespace reye::scene
