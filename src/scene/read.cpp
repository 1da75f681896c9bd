#include "scene/read.hpp"

#include <algorithm>
#include <filesystem>

#include "base/printable.hpp"
#include "scene/build.hpp"
#include "scene/choose_elements.hpp"
#include "scene/fixed_part.hpp"
#include "scene/geometry_files.hpp"
#include "scene/located.hpp"
#include "scene/validate.hpp"

namespace reye::scene {

namespace fs = std::filesystem;

namespace {

/// Points of loads and supports become vertices of the body they name; where they name none, of all that hold them.
void note_points(Scene& scene) {
  const auto note = [&](const std::string& body, const base::Vec2& point) {
    for (auto& options : scene.geometry.bodies)
      if (body.empty() || body == options.name) options.points_mm.push_back(point);
  };
  for (const auto& support : scene.supports)
    if (support.point_mm) note(support.body, *support.point_mm);
  for (const auto& load : scene.point_loads) note(load.body, load.point_mm);
}

void build(const Entry& root, Scene& scene, Issues& issues) {
  scene.title = root.given("title") ? root.text("title") : scene.name;
  scene.analysis = analysis_of(root);
  scene.accuracy = root.number("accuracy");
  scene.shape = root.text("shape") == "on";
  scene.max_newton = root.at("solver").whole("max_newton");
  scene.max_cutbacks = root.at("solver").whole("max_cutbacks");
  scene.materials = materials_of(root, issues);
  scene.body_material = body_materials_of(root);
  scene.geometry.axisymmetric = scene.analysis == base::Analysis::axisymmetric;
  scene.geometry.files = geometry_files(root, scene.path, issues);
  scene.geometry.folder = fs::absolute(scene.path).parent_path().lexically_normal().string();
  scene.geometry.bodies = bodies_of(root, issues);
  scene.geometry.section = section_of(root, issues);
  scene.geometry.boundaries = boundaries_of(root, scene.path, issues);
  scene.geometry.fine_zones = fine_zones_of(root, scene.geometry.boundaries, issues);
  scene.contacts = contacts_of(root, issues);
  scene.bonds = bonds_of(root, issues);
  scene.supports = supports_of(root, issues);
  add_loads(root, scene, issues);
  note_points(scene);
  auto histories = histories_of(root, scene.path, issues);
  scene.histories = std::move(histories.corners);
  scene.measured = std::move(histories.measured);
  scene.steps = steps_of(root, scene.path, issues);
  scene.limits = limits_of(root, issues);
  scene.remesh = remesh_of(root);
  require_shape_to_remesh(root, issues);
  scene.output = output_of(root);
  choose_elements(scene);
}

/// The files on which the scene depends: geometry, then profiles, histories and levels.
std::vector<std::string> files_of(const Scene& scene, const Entry& root) {
  auto files = scene.geometry.files;
  for (const auto& boundary : scene.geometry.boundaries)
    if (boundary.profile) files.push_back(beside(scene.path, boundary.profile->file));
  for (const auto& [name, measured] : scene.measured) files.push_back(beside(scene.path, measured.file));
  if (const auto spectrum = root.at("spectrum"); spectrum.given("levels"))
    files.push_back(beside(scene.path, spectrum.text("levels")));
  return files;
}

}  // namespace

std::string text_of(const std::string& path) {
  std::error_code error;
  std::string text;
  if (!fs::is_regular_file(path, error) || !read_bytes(path, text)) {
    const base::Issue issue{"", "", fs::exists(path, error) ? "cannot be read" : "no such file"};
    throw base::InputError({issue}, base::printable(path) + ": " + issue.rule);
  }
  constexpr std::size_t most_bytes = 8 << 20;
  if (text.size() > most_bytes) {
    const base::Issue issue{"", "", "is larger than 8 MB"};
    throw base::InputError({issue}, path + ": " + issue.rule);
  }
  return text;
}

Scene read(const std::string& path) { return read_text(text_of(path), path); }

Scene read_text(const std::string& text, const std::string& path) {
  const auto document = document_of(text, path);
  if (const auto* analysis = document.find("analysis"); analysis && analysis->text == "solid")
    throw located(
        {{analysis->key, analysis->written, "a scene of solids; this command takes plane scenes only so far"}},
        lines_of(document), path);
  Scene scene;
  scene.path = path;
  scene.name = name_of(path);
  scene.lines = lines_of(document);

  Issues issues;
  check(document, spec(), issues);
  const Entry root(&document, &spec());
  build(root, scene, issues);
  validate(root, scene, issues);
  if (!issues.empty()) throw located(std::move(issues), scene.lines, path);

  auto odd = suspicious(root, scene);
  scene.warnings = in_words(odd, scene.lines, path);
  scene.sha256 = digest(text, files_of(scene, root));
  scene.fixed_sha256 = digest(fixed_part(document, text), files_of(scene, root));
  scene.text = text;
  return scene;
}

base::InputError located(const Scene& scene, const std::vector<base::Issue>& issues) {
  return located(issues, scene.lines, scene.path);
}

}  // namespace reye::scene
