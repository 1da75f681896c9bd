#include <algorithm>
#include <filesystem>

#include "scene/fixed_part.hpp"
#include "scene/geometry_files.hpp"
#include "scene/located.hpp"
#include "scene/read.hpp"
#include "scene/solid/build_solid.hpp"
#include "scene/solid/solid_extension.hpp"
#include "scene/solid/solid_keys.hpp"
#include "scene/solid/solid_located.hpp"
#include "scene/solid/validate_solid.hpp"

namespace reye::scene {

namespace {

cad::SolidGeometryOptions solid_geometry_of(const Entry& root, const std::string& path, Issues& issues) {
  cad::SolidGeometryOptions geometry;
  geometry.files = geometry_files(root, path, issues);
  geometry.folder = std::filesystem::absolute(path).parent_path().lexically_normal().string();
  geometry.bodies = solid_bodies_of(root, issues);
  geometry.faces = faces_of(root, issues);
  geometry.fine_zones = solid_zones_of(root, geometry.faces, issues);
  return geometry;
}

void add_solid_steps(const Entry& root, SolidScene& scene, Issues& issues) {
  auto histories = histories_of(root, scene.path, issues);
  scene.histories = std::move(histories.corners);
  scene.measured = std::move(histories.measured);
  scene.steps = steps_of(root, scene.path, issues);
}

SolidRemesh solid_remesh_of(const Entry& root) {
  const auto entry = root.at("remesh");
  return {.automatic = entry.flag("automatic"),
          .every_blocks = entry.whole("every_blocks"),
          .triggers = {.min_quality = entry.number("min_quality"),
                       .min_facet_shape = entry.number("min_facet_shape"),
                       .size_ratio = entry.number("size_ratio"),
                       .wear_fraction = entry.number("wear_fraction")}};
}

void add_solid_output(const Entry& root, SolidScene& scene) {
  const auto output = root.at("output");
  scene.frames = frames_of(output.at("frames"));
  scene.history_every_blocks = output.at("history").whole("every_blocks");
  scene.checkpoint_s = output.number("checkpoint_s");
  scene.estimate_error = output.maybe_flag("estimate_error").value_or(root.given("accuracy"));
  for (const auto& probe : output.all("probes"))
    scene.probes.push_back({.name = probe.name(),
                            .body = probe.text("body"),
                            .at_mm = probe.triple("at_mm").value_or(base::Vec3::Zero())});
}

void build_solid(const Entry& root, SolidScene& scene, Issues& issues) {
  scene.title = root.given("title") ? root.text("title") : scene.name;
  scene.accuracy = root.number("accuracy");
  scene.geometry = solid_geometry_of(root, scene.path, issues);
  scene.materials = solid_materials_of(root);
  for (const auto& entry : root.all("body"))
    if (!entry.flag("rigid")) scene.body_material[entry.name()] = entry.text("material");
  scene.contacts = skin_contacts_of(root, issues);
  scene.symmetry = root.texts("symmetry");
  scene.supports = solid_supports_of(root, scene.geometry, issues);
  scene.loads = solid_loads_of(root, issues);
  add_solid_steps(root, scene, issues);
  scene.limits = limits_of(root, issues);
  scene.shape = root.text("shape") != "off";
  scene.remesh = solid_remesh_of(root);
  require_shape_to_remesh(root, issues);
  add_solid_output(root, scene);
  scene.max_newton = root.at("solver").whole("max_newton");
  scene.max_cutbacks = root.at("solver").whole("max_cutbacks");
  for (const auto& face : scene.symmetry) scene.lines["support." + symmetry_support(face)] = scene.lines.at("symmetry");
}

/// The files on which the scene depends: geometry, then histories.
std::vector<std::string> solid_files_of(const SolidScene& scene) {
  auto files = scene.geometry.files;
  for (const auto& [name, measured] : scene.measured) files.push_back(beside(scene.path, measured.file));
  return files;
}

}  // namespace

bool is_solid(const std::string& path) {
  try {
    return is_solid_text(text_of(path));
  } catch (const base::InputError&) {
    return false;
  }
}

bool is_solid_text(const std::string& text) {
  try {
    const auto document = parse(text);
    const auto* analysis = document.find("analysis");
    return analysis && analysis->text == "solid";
  } catch (const SyntaxError&) {
    return false;
  }
}

SolidScene read_solid(const std::string& path) { return read_solid_text(text_of(path), path); }

SolidScene read_solid_text(const std::string& text, const std::string& path) {
  const auto document = document_of(text, path);
  SolidScene scene;
  scene.path = path;
  scene.name = name_of(path);
  scene.lines = lines_of(document);

  Issues issues;
  check(document, solid_spec(), issues);
  const Entry root(&document, &solid_spec());
  build_solid(root, scene, issues);
  validate_solid(root, scene, issues);
  if (!issues.empty()) throw located(std::move(issues), scene.lines, path);

  auto odd = suspicious_solid(root, scene);
  scene.warnings = in_words(odd, scene.lines, path);
  const auto files = solid_files_of(scene);
  scene.sha256 = digest(text, files);
  scene.fixed_sha256 = digest(fixed_part(document, text), files);
  for (const auto& file : files) scene.file_sha256[path_from_scene(scene, file)] = file_sha256(file);
  scene.text = text;
  return scene;
}

base::InputError located(const SolidScene& scene, const std::vector<base::Issue>& issues) {
  return located(issues, scene.lines, scene.path);
}

}  // namespace reye::scene
