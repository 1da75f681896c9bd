#include "solids.hpp"

#include <spdlog/spdlog.h>

#include <cstdio>
#include <filesystem>

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

scene::SolidScene read_solid_scene(const Request& request) {
  spdlog::set_pattern("%v");
  if (request.quiet) spdlog::set_level(spdlog::level::err);
  auto scene = scene::read_solid(request.path);
  scene.geometry.trusted = request.trust_geometry;
  return scene;
}

std::string solid_folder(const Request& request, const scene::SolidScene& scene) {
  return request.out.empty() ? "./" + scene.name + ".out" : request.out;
}

void tell_solid_contact(const sim::SkinContactSummary& c) {
  spdlog::info("contact {}: peak pressure {:.4g} MPa, area {:.4g} mm^2, half widths {:.4g} and {:.4g} mm", c.name,
               c.peak_pressure_MPa.value_or(0.0), c.area_mm2.value_or(0.0), c.half_widths_mm[0], c.half_widths_mm[1]);
  spdlog::info("  normal force {:.4g} N, tangential {:.4g} N, dissipated {:.4g} mJ", c.normal_force_N,
               c.tangential_force_N, c.dissipated_energy_mJ);
  if (!c.wears) return;
  for (const auto& [name, side] : {std::pair("secondary", c.secondary), std::pair("primary", c.primary)})
    if (side.worn_volume_mm3 > 0.0)
      spdlog::info("  {} side: depth {:.4g} um, volume {:.4g} mm^3", name, 1e3 * side.max_depth_mm,
                   side.worn_volume_mm3);
}

void tell_solid_result(const sim::SolidSummary& s, const std::string& dir) {
  spdlog::info("{}: {:g} cycles, {} increments, {} Newton iterations, {:.1f} s", output::status_name(s.status),
               s.cycles, s.counts.increments, s.counts.newton_iterations, s.wall_s);
  for (const auto& c : s.contacts) tell_solid_contact(c);
  tell_lives(s);
  spdlog::info("page {0}/report.html, ParaView {0}/series.pvd, tables {0}/*.csv", base::printable(dir));
  tell_warnings(in_words(s.warnings));
  if (!s.reason.empty()) std::fprintf(stderr, "reye: %s\n", base::printable(s.reason).c_str());
}

}  // namespace

int run_solid(const Request& request) {
  const auto scene = read_solid_scene(request);
  const std::string dir = solid_folder(request, scene);
  const auto summary = shown_run(request, scene, dir);
  tell_solid_result(summary, dir);
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
