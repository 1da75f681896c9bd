#include "solids.hpp"

#include <spdlog/spdlog.h>

#include <cstdio>
#include <filesystem>

#include "base/errors.hpp"
#include "base/printable.hpp"
#include "lives.hpp"
#include "mesh/solid/solid_measure.hpp"
#include "output/folder/files.hpp"
#include "output/folder/folder_lock.hpp"
#include "output/folder/summary.hpp"
#include "output/solid/drawn_meshes.hpp"
#include "output/solid/solid_picture.hpp"
#include "output/solid/solid_run_writer.hpp"
#include "output/solid/solid_vtk.hpp"
#include "progress_line.hpp"
#include "scene/solid/solid_scene.hpp"
#include "signals.hpp"
#include "sim/problem/warnings.hpp"
#include "sim/solid/solid_plan.hpp"
#include "sim/study/run.hpp"
#include "sim/study/solid_accuracy.hpp"
#include "solid_resume.hpp"

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

void tell_warnings(const std::vector<sim::Warning>& warnings) {
  for (const auto& warning : warnings)
    std::fprintf(stderr, "warning: %s\n", base::printable(sim::in_words(warning)).c_str());
}

void tell_lines(const sim::SolidPlan& plan) {
  for (const auto& text : plan.lines) std::printf("%s\n", base::printable(text).c_str());
}

sim::SolidObserver solid_observer(const SolidCheckpoints& run, output::SolidRunWriter& writer, Checkpoints& checkpoints,
                                  ProgressLine& line) {
  sim::SolidObserver o;
  o.progress = [&line](const sim::Progress& p) { line.show(p); };
  o.increment = [&](const sim::SolidIncrement& row) { writer.increment(row); };
  o.frame = [&](const sim::SolidFrame& frame) { writer.frame(frame); };
  o.remesh = [&](const sim::SolidRemeshRecord& r) { writer.remesh(r); };
  o.state = [&](const sim::SolidRunState& state) {
    checkpoints.reach(snapshot_of(run, state, writer.counters()), standing_of(run.problem, state));
  };
  o.log = [&](const std::string& text) { writer.log(text); };
  o.interrupted = [] { return StopSignals::count() > 0; };
  return o;
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
  tell_warnings(s.warnings);
  if (!s.reason.empty()) std::fprintf(stderr, "reye: %s\n", base::printable(s.reason).c_str());
}

/// What cannot run here is refused before anything is written.
void refuse_what_does_not_fit(const sim::SolidPlan& plan) {
  if (!plan.refusal.empty()) throw base::InputError({{"geometry", "", plan.refusal}});
}

/// A run that resumes takes the meshes that it had: the mesher might not make them again.
sim::SolidProblem solid_problem(const Request& request, const scene::SolidScene& scene, const std::string& dir) {
  if (request.restart)
    if (auto geometry = output::load_meshes(dir, scene.fixed_sha256)) return sim::prepare(scene, std::move(*geometry));
  return sim::prepare(scene);
}

/// The folder made ready for a new run, whose start is its first checkpoint.
void begin_solid_folder(const SolidCheckpoints& run, const sim::SolidRunState& state, output::SolidRunWriter& writer,
                        Checkpoints& checkpoints) {
  writer.begin();
  output::save_meshes(writer.dir(), run.problem);
  output::atomic_write(writer.dir() + "/scene.svg", output::solid_picture(run.problem.scene, run.problem.inputs));
  checkpoints.start(snapshot_of(run, state, writer.counters()));
}

/// Plays the scene and writes everything, as for the plane.
sim::SolidSummary play_solid(const SolidCheckpoints& run, SolidStart start, output::SolidRunWriter& writer,
                             Checkpoints& checkpoints, bool quiet) {
  sim::SolidSummary summary;
  play_guarded(writer.dir(), run.origin, [&] {
    ProgressLine line(!quiet);
    summary = sim::run(run.problem, std::move(start.state), solid_observer(run, writer, checkpoints, line),
                       std::move(start.assembly));
    line.end();
    checkpoints.finish();
    writer.finish(summary);
  });
  return summary;
}

}  // namespace

int run_solid(const Request& request) {
  ignore_lost_output();
  const auto scene = read_solid_scene(request);
  const std::string dir = solid_folder(request, scene);
  const auto extension = request.restart ? solid_extension_in(dir, scene) : std::nullopt;
  open_or_refuse(dir, scene.name, scene.sha256, extension.has_value(), request.force);
  const sim::SolidProblem problem = solid_problem(request, scene, dir);
  const sim::SolidPlan plan = sim::solid_plan(problem);
  refuse_what_does_not_fit(plan);
  for (const auto& text : plan.lines) spdlog::info("{}", base::printable(text));
  if (!request.quiet) tell_warnings(problem.warnings);
  output::SolidRunWriter writer(dir, problem.scene);
  if (extension)
    for (const auto& change : extension->changes) writer.log("extended: " + change);
  const StopSignals stop(true);
  const SolidCheckpoints run(problem);
  Checkpoints checkpoints(dir, problem.scene.checkpoint_s);
  SolidStart start{sim::initial_solid_state(problem), {}};
  std::optional<Resumption> resumption;  // refused before anything is made
  if (request.restart) resumption = resumption_of(dir, run, extension, start);
  const output::FolderLock lock(dir);
  if (resumption)
    resume_folder(*resumption, snapshot_of(run, start.state, resumption->counters), standing_of(problem, start.state),
                  writer, checkpoints);
  else
    begin_solid_folder(run, start.state, writer, checkpoints);
  const sim::SolidSummary summary = play_solid(run, std::move(start), writer, checkpoints, request.quiet);
  tell_solid_result(summary, dir);
  return summary.status == sim::RunStatus::done ? 0 : summary.status == sim::RunStatus::failed ? 1 : 130;
}

int plan_solid(const Request& request) {
  const sim::SolidProblem problem = sim::prepare(read_solid_scene(request));
  const sim::SolidPlan plan = sim::solid_plan(problem);
  tell_lines(plan);
  tell_warnings(problem.warnings);
  refuse_what_does_not_fit(plan);
  return 0;
}

int check_solid(const Request& request) {
  const sim::SolidProblem problem = sim::prepare(read_solid_scene(request));
  for (const auto& input : problem.inputs) {
    const auto& mesh = *input.mesh;
    const auto box = mesh::bounding_box(mesh.X);
    std::printf("body %s: volume %.6g mm^3, box [%.6g, %.6g] x [%.6g, %.6g] x [%.6g, %.6g] mm, %d nodes, %d cells\n",
                base::printable(input.name).c_str(), mesh::volume(mesh), box[0], box[3], box[1], box[4], box[2], box[5],
                mesh.node_count(), mesh.cell_count());
    for (const auto& [name, facets] : mesh.faces)
      std::printf("  face %s: %.6g mm^2, %zu facets\n", base::printable(name).c_str(),
                  mesh::area(mesh.X, mesh::facets_of(mesh, name)), facets.size());
  }
  const sim::SolidPlan plan = sim::solid_plan(problem);
  tell_lines(plan);
  tell_warnings(problem.warnings);
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
