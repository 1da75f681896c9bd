#include "solids.hpp"

#include <cstdio>
#include <filesystem>

#include "base/formatted.hpp"
#include "base/printable.hpp"
#include "lives.hpp"
#include "output/folder/files.hpp"
#include "output/folder/summary.hpp"
#include "output/solid/solid_picture.hpp"
#include "output/solid/solid_vtk.hpp"
#include "runs/words.hpp"
#include "scene/solid/solid_scene.hpp"
#include "shown.hpp"
#include "sim/solid/solid_plan.hpp"
#include "sim/study/solid_accuracy.hpp"

namespace reye::apps {

namespace {

using base::formatted;
using Lines = std::vector<std::string>;

scene::SolidScene read_solid_scene(const Request& request) {
  auto scene = scene::read_solid(request.path);
  scene.geometry.trusted = request.trust_geometry;
  return scene;
}

std::string solid_folder(const Request& request, const scene::SolidScene& scene) {
  return request.out.empty() ? "./" + scene.name + ".out" : request.out;
}

void add_contact(const sim::SkinContactSummary& c, Lines& lines) {
  lines.push_back("contact " + c.name +
                  formatted(": peak pressure %.4g MPa, area %.4g mm^2, half widths %.4g and %.4g mm",
                            c.peak_pressure_MPa.value_or(0.0), c.area_mm2.value_or(0.0), c.half_widths_mm[0],
                            c.half_widths_mm[1]));
  lines.push_back(formatted("  normal force %.4g N, tangential %.4g N, dissipated %.4g mJ", c.normal_force_N,
                            c.tangential_force_N, c.dissipated_energy_mJ));
  if (!c.wears) return;
  for (const auto& [name, side] : {std::pair("secondary", c.secondary), std::pair("primary", c.primary)})
    if (side.worn_volume_mm3 > 0.0)
      lines.push_back(
          formatted("  %s side: depth %.4g um, volume %.4g mm^3", name, 1e3 * side.max_depth_mm, side.worn_volume_mm3));
}

Lines lines_of(const sim::SolidSummary& s, const std::string& dir) {
  Lines lines{formatted("%s: %g cycles, %ld increments, %ld Newton iterations, %.1f s", output::status_name(s.status),
                        s.cycles, s.counts.increments, s.counts.newton_iterations, s.wall_s)};
  for (const auto& c : s.contacts) add_contact(c, lines);
  add_lives(s, lines);
  lines.push_back("page " + dir + "/report.html, ParaView " + dir + "/series.pvd, tables " + dir + "/*.csv");
  return lines;
}

}  // namespace

int run_solid(const Request& request) {
  const auto scene = read_solid_scene(request);
  const std::string dir = solid_folder(request, scene);
  const auto summary = shown_run(request, scene, dir);
  if (!request.quiet) tell_lines(lines_of(summary, dir));
  tell_end(in_words(summary.warnings), summary.reason);
  return code_of(summary.status);
}

int plan_solid(const Request& request) {
  const sim::SolidProblem problem = sim::prepare(read_solid_scene(request));
  const sim::SolidPlan plan = sim::solid_plan(problem);
  tell_lines(plan.lines);
  tell_warnings(in_words(problem.warnings));
  refuse_what_does_not_fit(plan);
  return 0;
}

int check_solid(const Request& request) {
  const sim::SolidProblem problem = sim::prepare(read_solid_scene(request));
  tell_lines(body_lines(problem));
  const sim::SolidPlan plan = sim::solid_plan(problem);
  tell_lines(plan.lines);
  tell_warnings(in_words(problem.warnings));
  if (!request.picture.empty())
    output::atomic_write(request.picture, output::solid_picture(problem.scene, problem.inputs));
  refuse_what_does_not_fit(plan);
  std::printf("ok\n");
  return 0;
}

int mesh_solid(const Request& request) {
  const auto scene = read_solid_scene(request);
  const std::string dir = solid_folder(request, scene);
  const sim::SolidProblem problem = sim::prepare(scene);
  sim::SolidFrame frame;
  for (const auto& input : problem.inputs)
    frame.bodies.push_back({input.name, input.mesh, base::Points3(input.mesh->X.size(), base::Vec3::Zero()), {}});
  std::filesystem::create_directories(dir);
  output::atomic_write(dir + "/mesh.vtu", output::solid_bodies_vtu(frame));
  std::printf("%s/mesh.vtu\n", base::printable(dir).c_str());
  return 0;
}

}  // namespace reye::apps
