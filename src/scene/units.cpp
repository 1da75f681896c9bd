#include <algorithm>
#include <array>
#include <cmath>

#include "base/formatted.hpp"
#include "scene/histories.hpp"
#include "scene/validate.hpp"

namespace reye::scene {

namespace {

constexpr double stiffest_MPa =
    1e9;  ///< diamond has 1.2e6; a thousand times steel stands for a rigid body in some scenes
constexpr double most_friction = 3.0;      ///< dry rubber and clean metals stay below it
constexpr double cutting_mm3_per_J = 1.0;  ///< a lathe takes 0.3 mm^3 of steel off per joule
constexpr double smallest_mm3_per_J = 1e-12;
constexpr double largest_per_MPa = 1e-2;    ///< of Archard's law: chalk has less
constexpr double smallest_per_MPa = 1e-14;  ///< diamond-like coatings have 1e-11
constexpr double least_motion_mm = 1e-6,
                 smallest_motion_mm =
                     1e-4;  ///< a motion between the two is probably in metres; a smaller one is intended

void look_at_coefficients(const Entry& wear, Issues& found) {
  if (!wear.is_table()) return;
  const auto look = [&](const char* name, double least, double most, const std::string& much, double by,
                        const std::string& small, double up) {
    const auto formula = wear.formula(name);
    const double value = formula ? wear::at_start(formula) : wear.maybe_number(name).value_or(0.0);
    if (value > most) found.push_back({wear.key(name), wear.written(name), much + base::formatted("%.4g", value * by)});
    if (value > 0.0 && value < least)
      found.push_back({wear.key(name), wear.written(name), small + base::formatted("%.4g", value * up)});
  };
  for (const char* name : {"secondary_mm3_per_J", "primary_mm3_per_J"})
    look(name, smallest_mm3_per_J, cutting_mm3_per_J,
         "no wear takes off more than 1 mm^3/J, as metal cutting hardly does; in um^3/mJ it would be ", 1e-6,
         "no wear is measured below 1e-12 mm^3/J; in m^3/J it would be ", 1e9);
  for (const char* name : {"secondary_per_MPa", "primary_per_MPa"})
    look(name, smallest_per_MPa, largest_per_MPa,
         "no wear takes off more than 0.01 of the sliding distance per MPa; in 1e-6 mm^3/(N m) it would be ", 1e-9,
         "no wear is measured below 1e-14 1/MPa; in 1/Pa it would be ", 1e6);
}

void look_at_jump(const Entry& step, Issues& found) {
  const double cycles = step.number("cycles"), jump = step.maybe_number("jump").value_or(1.0);
  if (cycles == 0.0 || jump <= cycles) return;
  found.push_back({step.key("jump"), step.written("jump"),
                   base::formatted("is more than cycles = %g: the step is one block of %g cycles", cycles, cycles)});
}

}  // namespace

void look_at_modulus(const Entry& material, Issues& found) {
  const double E = material.number("E_MPa");
  if (E <= stiffest_MPa) return;
  found.push_back(
      {material.key("E_MPa"), material.written("E_MPa"),
       base::formatted("no solid has more than 1e9 MPa (steel 2.1e5, diamond 1.2e6); in Pa it would be %.4g; for a "
                       "body that does not "
                       "deform write rigid = true",
                       1e-6 * E)});
}

void look_at_friction(const Entry& entry, double friction, Issues& found) {
  if (friction <= most_friction) return;
  found.push_back(
      {entry.key("friction"), entry.written("friction"),
       base::formatted("no dry contact has a coefficient of friction above %g; in per cent it would be %.4g",
                       most_friction, friction / 100.0)});
}

void look_at_motions(const Entry& support, std::span<const char* const> names, const Played& played, Issues& found) {
  for (const char* name : names) {
    for (const auto& part : support.parts(name)) {
      const double way = part.number("motion_mm"), most = std::abs(way) * largest_factor(played, part.text("history"));
      if (most < least_motion_mm || most >= smallest_motion_mm) continue;
      found.push_back(
          {part.key("motion_mm"), part.written("motion_mm"),
           base::formatted("moves by %.4g mm at most, less than a tenth of a micrometre; in metres it would be %.4g",
                           most, way * 1e3)});
    }
  }
}

void suspicious_values(const Entry& root, const Scene& scene, Issues& found) {
  for (const auto& material : root.all("material")) look_at_modulus(material, found);
  const auto contacts = root.all("contact");
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    look_at_friction(contacts[i], scene.contacts[i].friction, found);
    look_at_coefficients(contacts[i].at("wear"), found);
  }
  constexpr std::array shifts = {"x", "y", "tangent", "normal"};
  for (const auto& support : root.all("support"))
    look_at_motions(support, shifts, {scene.histories, scene.steps}, found);
  for (const auto& step : root.all("step")) look_at_jump(step, found);
}

}  // namespace reye::scene
