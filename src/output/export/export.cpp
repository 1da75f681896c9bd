#include "output/export/export.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "base/printable.hpp"
#include "cad/meshing/step_writing.hpp"
#include "output/export/outline_files.hpp"
#include "output/export/run_frames.hpp"
#include "output/export/stl.hpp"
#include "output/export/worn_off.hpp"
#include "output/export/worn_skins.hpp"
#include "output/folder/text.hpp"
#include "output/report/run_data.hpp"
#include "scene/document.hpp"
#include "scene/nearest.hpp"

namespace reye::output {

namespace {

const std::vector<std::string> formats{"csv", "dxf", "step", "stl"};

/// Issues of the wish alone, for a run of this kind.
std::vector<base::Issue> issues_of(const ShapeWish& wish, const Identity& run) {
  std::vector<base::Issue> issues;
  const bool known = std::find(formats.begin(), formats.end(), wish.format) != formats.end();
  const bool ring = run.analysis == base::Analysis::axisymmetric, stl = wish.format == "stl";
  if (wish.format.empty())
    issues.push_back({"--format", "", "name csv, dxf, step or stl; of solids stl or csv"});
  else if (!known)
    issues.push_back({"--format", wish.format, scene::unknown_name_rule("format", wish.format, formats)});
  if (known && run.solid && !stl && wish.format != "csv")
    issues.push_back({"--format", wish.format,
                      "a worn solid is a mesh, which " + wish.format +
                          " would hold as thousands of flat faces; use stl, which CAD reads as a mesh, or csv, the "
                          "nodes of its worn faces with their depths"});
  if (stl && !run.solid && ring)
    issues.push_back({"--format", "stl", "the body is a half section; export step and revolve it in CAD"});
  if (stl && !run.solid && !ring && !wish.thickness_mm)
    issues.push_back(
        {"--thickness", "", "stl has three dimensions: give the thickness in mm to which plane bodies are extruded"});
  if (wish.thickness_mm && !(*wish.thickness_mm > 0.0 && std::isfinite(*wish.thickness_mm)))
    issues.push_back({"--thickness", number(*wish.thickness_mm), "it must be a number > 0, in mm"});
  if (wish.thickness_mm && (run.solid || ring || (known && !stl)))
    issues.push_back({"--thickness", number(*wish.thickness_mm), "only stl of plane bodies has a thickness"});
  return issues;
}

/// Keeps the body that is wished for.
template <class Body>
void keep_wished(std::vector<Body>& bodies, const std::string& name) {
  if (name.empty()) return;
  std::vector<std::string> names;
  for (const auto& body : bodies) names.push_back(body.name);
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw base::InputError({{"--body", name, scene::unknown_name_rule("body", name, names)}});
  std::erase_if(bodies, [&](const Body& body) { return body.name != name; });
}

/// What an export says of itself in its first line.
std::string note_of(const Identity& run, const ExportedShape& shape) {
  return std::string(export_mark) + ": worn shape, stress-free (not deformed), mm; frame " +
         std::to_string(shape.frame) + ", cycle " + number(shape.cycle) + "; " + base::printable(run.title) +
         "; reye " + version;
}

/// Whether the scene leaves all shapes as they were drawn.
bool keeps_shapes(const std::string& dir, const Identity& run) {
  try {
    const scene::Node root = scene::parse(run.scene_text);
    const scene::Node* shape = root.find("shape");
    return shape && shape->text == "off";
  } catch (const scene::SyntaxError& error) {
    throw base::InputError({{"dir", dir, "its scene is no TOML any more: " + std::string(error.what())}});
  }
}

/// Refuses, or warns of, a frame whose shapes lack wear that it counts.
void judge(const ShapeWish& wish, const Identity& run, ExportedShape& shape) {
  if (keeps_shapes(wish.dir, run))
    throw base::InputError({{"dir", wish.dir,
                             "its scene has shape = \"off\": wear only opens the gaps, and the bodies keep the shape "
                             "that was drawn"}});
  const Lag lag = lag_of(wish.dir, run.solid, shape.frame);
  if (lag.lacking_mm <= 0.1 * lag.deepest_mm) return;
  const std::string text = "the shapes of frame " + std::to_string(shape.frame) + " are those of frame " +
                           std::to_string(lag.shown) + ": of its depth of " + rounded(lag.deepest_mm, 3) +
                           " mm they lack " + rounded(lag.lacking_mm, 3) + " mm, which is still in the gap";
  if (lag.lacking_mm > 0.5 * lag.deepest_mm)
    throw base::InputError({{"--frame", std::to_string(shape.frame), text + "; choose another frame (--list)"}});
  shape.warnings.push_back(text);
}

/// Plane bodies as stl, one text each.
void add_extruded(const std::vector<WornBody>& bodies, double thickness, const std::string& note,
                  ExportedShape& shape) {
  for (const auto& body : bodies)
    if (body.mesh.cells.empty())
      shape.lines.push_back("skipped: body " + base::printable(body.name) +
                            " is rigid and keeps the shape that was drawn; its frames hold an outline without a mesh. "
                            "csv, dxf and step have it");
    else
      shape.texts.emplace_back(body.name, stl(extruded(body, thickness), note));
  if (shape.texts.empty())
    throw base::InputError(
        {{"--body", "", "a rigid body has no stl: it keeps the shape that was drawn; csv, dxf and step have it"}});
}

void export_plane(const ShapeWish& wish, const Identity& run, ExportedShape& shape) {
  auto bodies = read_worn_bodies(frame_path(wish.dir, "bodies", "vtu", shape.frame));
  keep_wished(bodies, wish.body);
  const bool ring = run.analysis == base::Analysis::axisymmetric;
  for (const auto& body : bodies) {
    const char* unit = ring ? "mm3" : "mm2";
    shape.lines.push_back("body " + base::printable(body.name) +
                          base::formatted(": %.9g %s; its depths amount to %.4g %s", content(body, run.analysis), unit,
                                          depth_amount(body, run.analysis), unit));
  }
  const std::string note = note_of(run, shape);
  if (wish.format == "csv")
    shape.texts.emplace_back(
        "", outline_csv(bodies, side_names(frame_path(wish.dir, "surface", "vtp", shape.frame)), ring, note));
  else if (wish.format == "dxf")
    shape.texts.emplace_back("", outline_dxf(bodies, note));
  else if (wish.format == "step")
    shape.texts.emplace_back("", cad::step_text(faces_of(bodies), note));
  else
    add_extruded(bodies, *wish.thickness_mm, note, shape);
}

void export_solid(const ShapeWish& wish, const Identity& run, ExportedShape& shape) {
  auto bodies = read_worn_solids(frame_path(wish.dir, "bodies", "vtu", shape.frame));
  keep_wished(bodies, wish.body);
  for (const auto& body : bodies)
    shape.lines.push_back("body " + base::printable(body.name) + base::formatted(": %.9g mm3", content(body)));
  const std::string note = note_of(run, shape);
  if (wish.format == "csv")
    shape.texts.emplace_back("", worn_faces_csv(wish.dir, shape.frame, wish.body, note));
  else
    for (const auto& body : bodies) shape.texts.emplace_back(body.name, stl(triangles_of(body), note));
}

}  // namespace

ExportedShape export_shape(const ShapeWish& wish) {
  const Identity run = identity_in(wish.dir);
  auto issues = issues_of(wish, run);
  if (!issues.empty()) throw base::InputError(std::move(issues));
  ExportedShape shape;
  const auto cycles = frame_cycles(wish.dir);
  shape.frame = chosen_frame(cycles, wish.cycle, wish.frame);
  shape.cycle = cycles[shape.frame];
  judge(wish, run, shape);
  if (run.solid)
    export_solid(wish, run, shape);
  else
    export_plane(wish, run, shape);
  return shape;
}

std::vector<std::string> frames_in_words(const std::string& dir) {
  (void)identity_in(dir);
  std::vector<std::string> lines;
  const auto cycles = frame_cycles(dir);
  for (std::size_t k = 0; k < cycles.size(); ++k)
    lines.push_back("frame " + std::to_string(k) + ": cycle " + number(cycles[k]));
  return lines;
}

bool is_export(const std::string& file) {
  std::array<char, 512> begin{};
  std::ifstream in(file, std::ios::binary);
  in.read(begin.data(), begin.size());
  return std::string_view(begin.data(), static_cast<std::size_t>(in.gcount())).find(export_mark) !=
         std::string_view::npos;
}

}  // namespace reye::output
