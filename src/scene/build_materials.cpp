#include <algorithm>
#include <array>
#include <cstdio>

#include "scene/build.hpp"

namespace reye::scene {

namespace {

using Names = std::initializer_list<std::string_view>;

constexpr std::array<std::string_view, 8> parameters = {"yield_MPa",    "modulus_MPa", "saturation_MPa", "rate",
                                                        "strength_MPa", "offset",      "exponent",       "points"};

/// A hardening law takes `needed` and `optional`, and nothing else of its table.
void check_parameters(const Entry& entry, Names needed, Names optional, Issues& issues) {
  const auto in = [](Names names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const auto name : parameters) {
    if (in(needed, name) && !entry.given(name))
      issues.push_back({entry.key(name), "", "missing; hardening by " + entry.text("law") + " needs it"});
    if (!in(needed, name) && !in(optional, name))
      refuse(entry, {name}, "hardening by " + entry.text("law") + " takes none", issues);
  }
}

material::Hardening voce_of(const Entry& entry, Issues& issues) {
  check_parameters(entry, {"yield_MPa", "saturation_MPa", "rate"}, {"modulus_MPa"}, issues);
  if (entry.given("saturation_MPa") && entry.number("saturation_MPa") < entry.number("yield_MPa"))
    issues.push_back({entry.key("saturation_MPa"), entry.written("saturation_MPa"), "must be >= yield_MPa"});
  return material::VoceHardening{.yield_MPa = entry.number("yield_MPa"),
                                 .saturation_MPa = entry.number("saturation_MPa"),
                                 .rate = entry.number("rate"),
                                 .modulus_MPa = entry.number("modulus_MPa")};
}

material::Hardening swift_of(const Entry& entry, Issues& issues) {
  check_parameters(entry, {"strength_MPa", "offset", "exponent"}, {}, issues);
  return material::SwiftHardening{.strength_MPa = entry.number("strength_MPa"),
                                  .offset = entry.number("offset"),
                                  .exponent = entry.number("exponent")};
}

material::Hardening hardening_table_of(const Entry& entry, Issues& issues) {
  check_parameters(entry, {"points"}, {}, issues);
  auto points = entry.curve("points");
  const auto softens = [](const auto& a, const auto& b) { return b[1] < a[1]; };
  if (!points.empty() && (points.front()[0] != 0.0 || points.front()[1] <= 0.0))
    issues.push_back({entry.key("points"), entry.written("points"), "must start at p = 0 with a yield stress > 0"});
  if (std::adjacent_find(points.begin(), points.end(), softens) != points.end())
    issues.push_back({entry.key("points"), entry.written("points"), "the yield stress must not fall"});
  return material::TableHardening{.points = std::move(points)};
}

material::Hardening hardening_of(const Entry& entry, Issues& issues) {
  const auto law = entry.text("law");
  if (law == "voce") return voce_of(entry, issues);
  if (law == "swift") return swift_of(entry, issues);
  if (law == "table") return hardening_table_of(entry, issues);
  check_parameters(entry, {"yield_MPa"}, {"modulus_MPa"}, issues);
  return material::LinearHardening{.yield_MPa = entry.number("yield_MPa"), .modulus_MPa = entry.number("modulus_MPa")};
}

material::Volumetric volumetric_of(const std::string& name) {
  if (name == "quadratic") return material::Volumetric::quadratic;
  if (name == "mixed") return material::Volumetric::mixed;
  if (name == "power") return material::Volumetric::power;
  return material::Volumetric::log_squared;
}

material::Material material_of(const Entry& entry, Issues& issues) {
  const auto law = entry.text("law");
  const double E = entry.number("E_MPa"), nu = entry.number("nu");
  if (law != "neo_hookean") refuse(entry, {"volumetric"}, "only neo_hookean takes one", issues);
  if (law != "hencky_j2") refuse(entry, {"hardening"}, "only hencky_j2 takes one", issues);
  if (law == "st_venant_kirchhoff") return material::StVenantKirchhoff{.E_MPa = E, .nu = nu};
  if (law == "hencky" || law == "hencky_cauchy")
    return material::Hencky{.E_MPa = E, .nu = nu, .cauchy = law == "hencky_cauchy"};
  if (law == "hencky_j2") {
    const auto hardening = entry.at("hardening");
    if (hardening.is_table())
      return material::HenckyJ2{.E_MPa = E, .nu = nu, .hardening = hardening_of(hardening, issues)};
    if (!entry.given("hardening"))
      issues.push_back({entry.key("hardening"), "", "missing; hencky_j2 needs a table of it"});
  }
  if (law == "neo_hookean") {
    const auto volumetric = volumetric_of(entry.text("volumetric"));
    if (volumetric == material::Volumetric::power && nu <= 0.0)
      issues.push_back({entry.key("volumetric"), entry.written("volumetric"), "needs nu > 0"});
    return material::NeoHookean{.E_MPa = E, .nu = nu, .volumetric = volumetric};
  }
  return material::LinearElastic{.E_MPa = E, .nu = nu};
}

}  // namespace

std::map<std::string, material::Material> materials_of(const Entry& root, Issues& issues) {
  std::map<std::string, material::Material> materials;
  for (const auto& entry : root.all("material")) materials[entry.name()] = material_of(entry, issues);
  return materials;
}

}  // namespace reye::scene
