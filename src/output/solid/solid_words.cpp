#include "output/solid/solid_words.hpp"

#include <array>
#include <cmath>

#include "base/formatted.hpp"
#include "output/folder/text.hpp"
#include "output/picture/actions.hpp"

namespace reye::output {

namespace {

constexpr std::array axis_names{"x", "y", "z"};

/// Adds a phrase of a list.
void add_phrase(std::string& words, const std::string& phrase) { words += (words.empty() ? "" : ", ") + phrase; }

/// The motions of one sort; those that are free are left out.
void add_motions(const std::array<body::Motion, 3>& motions, const std::string& before, const char* length,
                 const char* force, std::string& words) {
  const auto is_fixed = [](const body::Motion& m) { return m.drive == body::Drive::fixed; };
  if (std::all_of(motions.begin(), motions.end(), is_fixed)) return add_phrase(words, before + "x, y, z fixed");
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const std::string said = motion_in_words(motions[i], length, force);
    if (said != "free") add_phrase(words, before + axis_names[i] + ' ' + said);
  }
}

std::string played(const std::string& history) { return history.empty() ? "" : " × " + history; }

}  // namespace

std::string direction_in_words(const base::Vec3& v) {
  const base::Vec3 d = v.normalized();
  for (int i = 0; i < 3; ++i)
    if (std::abs(std::abs(d[i]) - 1.0) < 1e-9) return (d[i] < 0.0 ? "-" : "") + std::string(axis_names[i]);
  return base::formatted("(%.3g, %.3g, %.3g)", d.x(), d.y(), d.z());
}

std::string place_in_words(const base::Vec3& v) { return base::formatted("(%.4g, %.4g, %.4g)", v.x(), v.y(), v.z()); }

std::string solid_material_in_words(const scene::SolidScene& scene, const cad::SolidBodyOptions& body) {
  if (body.rigid) return "rigid";
  const auto name = scene.body_material.find(body.name);
  if (name == scene.body_material.end()) return "no material";
  const auto found = scene.materials.find(name->second);
  if (found == scene.materials.end()) return name->second;
  return name->second +
         std::visit([](const auto& m) { return base::formatted(", E %.6g MPa, nu %g", m.E_MPa, m.nu); }, found->second);
}

std::string place_of(const std::string& face, const std::string& body) {
  return face.empty() ? "body " + body : "face " + face;
}

std::string solid_support_in_words(const body::SolidSupport& support) {
  std::string words;
  const std::string normal = motion_in_words(support.normal, "mm", "N");
  if (normal != "free") add_phrase(words, "normal " + normal);
  add_motions(support.along, "", "mm", "N", words);
  if (support.rigid) add_motions(support.about, "rotation about ", "rad", "N mm", words);
  if (words.empty()) words = "free";
  if (support.rigid) words += "; as one rigid face";
  if (!support.axes.isIdentity(1e-12))
    words += "; axes x " + direction_in_words(support.axes.col(0)) + ", y " + direction_in_words(support.axes.col(1));
  if (support.centre_mm) words += "; centre " + place_in_words(*support.centre_mm) + " mm";
  return words;
}

std::string solid_load_in_words(const body::SolidLoad& load) {
  std::string words;
  if (load.pressure_MPa != 0.0) add_phrase(words, "pressure " + rounded(load.pressure_MPa) + " MPa");
  if (!load.traction_MPa.isZero()) add_phrase(words, "traction " + place_in_words(load.traction_MPa) + " MPa");
  if (!load.force_N.isZero()) add_phrase(words, "force " + place_in_words(load.force_N) + " N");
  if (!load.force_N_per_mm3.isZero())
    add_phrase(words, "force per volume " + place_in_words(load.force_N_per_mm3) + " N/mm³");
  return (words.empty() ? "zero" : words) + played(load.history);
}

std::string sliding_in_words(const contact::ImposedSliding& sliding) {
  const bool turns = sliding.direction.isZero();
  std::string words;
  for (const auto& part : sliding.parts)
    words += (words.empty() ? "" : " and ") + rounded(part.value) + (turns ? " rad" : " mm") + played(part.history);
  if (words.empty()) return words;
  return words + (turns ? " about " + direction_in_words(sliding.axis) + " through " + place_in_words(sliding.point_mm)
                        : " along " + direction_in_words(sliding.direction));
}

}  // namespace reye::output
