#include "scene/scars.hpp"

#include <algorithm>
#include <optional>

#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "scene/check.hpp"
#include "scene/entry.hpp"
#include "scene/geometry_files.hpp"
#include "scene/located.hpp"
#include "scene/read.hpp"
#include "scene/scar_file.hpp"
#include "scene/shared_keys.hpp"
#include "scene/solid/solid_keys.hpp"
#include "scene/spec.hpp"

namespace reye::scene {

namespace {

// One key a paragraph.
// clang-format off
constexpr Key scar_table[] = {
    {"scar[].file", Type::text, "", "required", rows::any,
     "CSV file of a profile across the scar or of a map of it, with a line of names; the path counts from this file"},
    {"scar[].contact", Type::text, "", "", rows::any, "contact of the scene; may be left out where only one wears"},
    {"scar[].side", Type::text, "", "", rows::one_of("secondary|primary"),
     "side of the contact; may be left out where only one side wears"},
    {"scar[].cycles", Type::number, "", "", rows::positive,
     "cycles of the scene when the scar was measured; by default those of --at"},
    {"scar[].scatter_mm", Type::number, "mm", "", rows::positive,
     "standard deviation of one depth; without it, and without a column of the file, it is found from the fit"},
    {"scar[].level", Type::flag, "", "true", rows::any,
     "the instrument's offset and tilt are unknown and fitted; false: depths count from the unworn surface"},
    {"scar[].origin", Type::text, "", "unknown", rows::one_of("unknown|known"),
     "unknown: the scar is moved along the surface until it fits; known: places count from the scene's origin"},
    {"loop[].file", Type::text, "", "required", rows::any,
     "CSV file of one cycle of friction, stroke_mm and force_N_per_mm (plane scenes) or force_N in the order of time"},
    {"loop[].contact", Type::text, "", "", rows::any, "contact of the scene; may be left out where only one wears"},
    {"loop[].cycles", Type::number, "", "", rows::positive,
     "cycles of the scene when it was measured; by default those of --at"},
    {"loop[].scatter", Type::number, "", "", {.low = 0.0, .high = 1.0, .low_open = true},
     "standard deviation of the energy in the loop, as a share of it"},
    {"figure[].contact", Type::text, "", "", rows::any, "contact of the scene; may be left out where only one wears"},
    {"figure[].side", Type::text, "", "", rows::one_of("secondary|primary"),
     "side of the contact; may be left out where only one side wears"},
    {"figure[].cycles", Type::number, "", "", rows::positive,
     "cycles of the scene when it was measured; by default those of --at"},
    {"figure[].depth_mm", Type::number, "mm", "", rows::positive, "largest worn depth"},
    {"figure[].width_mm", Type::number, "mm", "", rows::positive, "width of the scar, plane and axisymmetric scenes"},
    {"figure[].area_mm2", Type::number, "mm^2", "", rows::positive, "worn area of a plane scene"},
    {"figure[].volume_mm3", Type::number, "mm^3", "", rows::positive, "worn volume of a solid or axisymmetric scene"},
    {"figure[].energy_mJ_per_mm", Type::number, "mJ/mm", "", rows::positive,
     "energy dissipated in one cycle of a plane scene"},
    {"figure[].energy_mJ", Type::number, "mJ", "", rows::positive,
     "energy dissipated in one cycle of a solid or axisymmetric scene"},
    {"figure[].scatter", Type::number, "", "", {.low = 0.0, .high = 1.0, .low_open = true},
     "standard deviation of the number, as a share of it"},
};
// clang-format on

const Spec& scar_spec() {
  static const Spec root = tree_of(scar_table);
  return root;
}

std::string list_of(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "\"" : ", \"") + name + '"';
  return text;
}

/// Which contact and side a measurement belongs to; an issue where that is open.
class Places {
 public:
  Places(const ScarContext& scene, Issues& issues) : scene_(scene), issues_(issues) {
    for (const auto& contact : scene.contacts)
      if (contact.secondary || contact.primary) wearing_.push_back(contact.name);
  }

  /// `entry`: of the TOML file; none for a CSV file.
  ScarPlace of(const std::optional<Entry>& entry, bool sided = true) {
    ScarPlace place;
    const auto given = [&](const char* key) { return entry && entry->given(key); };
    const auto key = [&](const char* name) { return entry ? entry->key(name) : std::string(name); };
    place.key = entry ? entry->key() : "";
    place.contact = given("contact") ? entry->text("contact") : scene_.contact;
    if (place.contact.empty() && wearing_.size() == 1) place.contact = wearing_.front();
    const auto found = std::find_if(scene_.contacts.begin(), scene_.contacts.end(),
                                    [&](const auto& contact) { return contact.name == place.contact; });
    if (!place.contact.empty() && found == scene_.contacts.end())
      issues_.push_back({key("contact"), base::quoted(place.contact),
                         "no contact of that name wears in the scene; " + list_of(wearing_) + " do"});
    if (place.contact.empty())
      issues_.push_back({key("contact"), "", "is missing: contacts " + list_of(wearing_) + " wear"});
    if (sided && found != scene_.contacts.end())
      set_side(*found, given("side") ? entry->text("side") : scene_.side, key("side"), place);
    place.cycles = given("cycles") ? entry->number("cycles") : scene_.at_cycles;
    if (!(place.cycles > 0.0))
      issues_.push_back(
          {key("cycles"), "", "is missing: give the cycles after which it was measured here, or by --at CYCLES"});
    return place;
  }

 private:
  void set_side(const WearingContact& contact, const std::string& side, const std::string& key, ScarPlace& place) {
    const bool both = contact.secondary && contact.primary;
    if (side.empty() && both)
      issues_.push_back(
          {key, "", "is missing: both sides of contact \"" + contact.name + "\" wear; \"secondary\" or \"primary\""});
    place.side = side == "primary" || (side.empty() && !contact.secondary) ? ScarSide::primary : ScarSide::secondary;
    if (!side.empty() && !(place.side == ScarSide::secondary ? contact.secondary : contact.primary))
      issues_.push_back(
          {key, '"' + side + '"',
           "that side of contact \"" + contact.name + "\" does not wear in the scene: its coefficient is 0"});
  }

  const ScarContext& scene_;
  Issues& issues_;
  std::vector<std::string> wearing_;
};

/// Depths of more than a tenth of the length on which they were measured are mostly in another unit.
void warn_of_units(const MeasuredScar& scar, std::vector<std::string>& warnings) {
  const auto [low, high] =
      std::minmax_element(scar.at.begin(), scar.at.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); });
  const double length = high->x() - low->x(), range = scar.depth_mm.maxCoeff() - scar.depth_mm.minCoeff();
  if (range > 0.1 * length)
    warnings.push_back(scar.file + ": its depths span " + shown(range) + " mm over a length of " + shown(length) +
                       " mm; is the unit of the column right?");
}

void add_scar(const std::string& file, const std::optional<Entry>& entry, const ScarContext& scene, Places& places,
              Issues& issues, MeasuredScars& result) {
  MeasuredScar scar{.of = places.of(entry), .axes = {}, .at = {}, .depth_mm = {}, .scatter_mm = {}, .file = file};
  read_scar_file(file, scene.dimension == 3, entry ? entry->key("file") : "", scar, issues);
  if (entry) {
    scar.level = entry->flag("level");
    scar.origin_known = entry->text("origin") == "known";
    if (const auto scatter = entry->maybe_number("scatter_mm")) {
      if (scar.scatter_mm.size() > 0)
        issues.push_back(
            {entry->key("scatter_mm"), entry->written("scatter_mm"), "the file has a column of scatter as well"});
      scar.scatter_mm = base::Vector::Constant(scar.depth_mm.size(), *scatter);
    }
  }
  if (scar.depth_mm.size() > 0) warn_of_units(scar, result.warnings);
  result.scars.push_back(std::move(scar));
}

/// What a figure may be, and the unit that goes with what is worn or dissipated in a scene.
struct FigureKey {
  const char* key;
  ScarFigure what;
  std::optional<bool> volumes{};  ///< only where the scene has volumes, or only where it has none
};

constexpr FigureKey figure_keys[] = {{"depth_mm", ScarFigure::depth},
                                     {"width_mm", ScarFigure::width},
                                     {"area_mm2", ScarFigure::area, false},
                                     {"volume_mm3", ScarFigure::area, true},
                                     {"energy_mJ_per_mm", ScarFigure::energy, false},
                                     {"energy_mJ", ScarFigure::energy, true}};

void add_figure(const Entry& entry, const ScarContext& scene, Places& places, Issues& issues, MeasuredScars& result) {
  MeasuredFigure figure;
  int given = 0;
  for (const auto& [key, what, volumes] : figure_keys) {
    if (!entry.given(key)) continue;
    ++given;
    figure.what = what;
    figure.value = entry.number(key);
    if (volumes.value_or(scene.volumes) != scene.volumes)
      issues.push_back({entry.key(key), entry.written(key),
                        scene.volumes ? "this scene counts volumes and whole energies: volume_mm3, energy_mJ"
                                      : "a plane scene counts per mm of thickness: area_mm2, energy_mJ_per_mm"});
    if (what == ScarFigure::width && scene.dimension == 3)
      issues.push_back({entry.key(key), entry.written(key),
                        "a scar of solids has no one width; give depth_mm, volume_mm3 or a map"});
  }
  figure.of = places.of(entry, figure.what != ScarFigure::energy);
  if (given != 1)
    issues.push_back({entry.key(), "",
                      "takes one number: depth_mm, width_mm, area_mm2 or volume_mm3, energy_mJ_per_mm "
                      "or energy_mJ; give more numbers as more [[figure]]"});
  figure.scatter = entry.maybe_number("scatter").value_or(0.0);
  result.figures.push_back(figure);
}

void add_loop(const std::string& file, const Entry& entry, const ScarContext& scene, Places& places, Issues& issues,
              MeasuredScars& result) {
  MeasuredFigure figure{.of = places.of(entry, false), .what = ScarFigure::energy};
  figure.value = energy_of_loop(file, scene.volumes, entry.key("file"), issues);
  figure.scatter = entry.maybe_number("scatter").value_or(0.0);
  result.figures.push_back(figure);
}

}  // namespace

std::string scar_reference() { return reference(scar_table); }

MeasuredScars read_scars(const std::string& path, const ScarContext& scene) {
  MeasuredScars result;
  Issues issues;
  Places places(scene, issues);
  Lines lines;
  if (path.ends_with(".csv")) {
    add_scar(path, {}, scene, places, issues, result);
  } else {
    const auto document = document_of(text_of(path), path);
    lines = lines_of(document);
    check(document, scar_spec(), issues);
    const Entry root(&document, &scar_spec());
    for (const auto& entry : root.all("scar"))
      add_scar(beside(path, entry.text("file")), entry, scene, places, issues, result);
    for (const auto& entry : root.all("loop"))
      add_loop(beside(path, entry.text("file")), entry, scene, places, issues, result);
    for (const auto& entry : root.all("figure")) add_figure(entry, scene, places, issues, result);
    if (result.scars.empty() && result.figures.empty())
      issues.push_back({"scar", "", "is missing: nothing was measured; needs [[scar]], [[loop]] or [[figure]]"});
  }
  if (!issues.empty()) throw located(std::move(issues), lines, path);
  return result;
}

}  // namespace reye::scene
