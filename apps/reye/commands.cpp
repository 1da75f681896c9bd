#include "commands.hpp"

#include <spdlog/spdlog.h>

#include <chrono>
#include <cstdio>
#include <filesystem>

#include "base/errors.hpp"
#include "base/printable.hpp"
#include "checkpoints.hpp"
#include "lives.hpp"
#include "mesh/measure.hpp"
#include "mesh/quality.hpp"
#include "output/folder/files.hpp"
#include "output/folder/folder.hpp"
#include "output/folder/folder_lock.hpp"
#include "output/folder/summary.hpp"
#include "output/folder/text.hpp"
#include "output/folder/vtk_frames.hpp"
#include "output/picture/scene_picture.hpp"
#include "output/report/report.hpp"
#include "output/run/commit.hpp"
#include "output/run/run_writer.hpp"
#include "output/solid/solid_report.hpp"
#include "plane_resume.hpp"
#include "progress_line.hpp"
#include "scene/read.hpp"
#include "scene/schema.hpp"
#include "scene/solid/solid_keys.hpp"
#include "scene/solid/solid_scene.hpp"
#include "signals.hpp"
#include "sim/problem/scene_line.hpp"
#include "sim/problem/warnings.hpp"
#include "sim/study/forecast.hpp"
#include "sim/study/prepare.hpp"
#include "sim/study/run.hpp"
#include "solids.hpp"

namespace reye::apps {

namespace {

std::string folder_of(const Request& request, const scene::Scene& scene) {
  return request.out.empty() ? "./" + scene.name + ".out" : request.out;
}

scene::Scene read(const Request& request) {
  spdlog::set_pattern("%v");
  if (request.quiet) spdlog::set_level(spdlog::level::err);
  auto scene = scene::read(request.path);
  scene.geometry.trusted = request.trust_geometry;
  return scene;
}

/// Prints warnings on the error stream, so that they are seen even where the output goes into a file; --quiet silences
/// those before the run.
void tell(const scene::Scene& scene, const std::vector<sim::Warning>& warnings) {
  for (const auto& warning : warnings) {
    const std::string text = sim::scene_line(scene, warning.about) + sim::in_words(warning);
    std::fprintf(stderr, "warning: %s\n", base::printable(text).c_str());
  }
}

/// The folder made ready for a new run. Its start is kept as the first checkpoint: a run interrupted before its first
/// block can resume, too.
void begin_folder(const sim::Problem& problem, const sim::State& state, output::RunWriter& writer,
                  Checkpoints& checkpoints) {
  writer.begin();
  // Before the checkpoint: a run that resumes from it finds the picture.
  output::atomic_write(writer.dir() + "/scene.svg", output::scene_picture(problem));
  checkpoints.start(snapshot_of(problem, state, writer.counters()));
}

sim::Observer observer_of(const sim::Problem& problem, output::RunWriter& writer, Checkpoints& checkpoints,
                          ProgressLine& line) {
  sim::Observer o;
  o.progress = [&line](const sim::Progress& p) { line.show(p); };
  o.increment = [&](const sim::IncrementRecord& r) { writer.increment(r); };
  o.frame = [&](const sim::Frame& f) { writer.frame(f); };
  o.remesh = [&](const sim::RemeshRecord& r) { writer.remesh(r); };
  o.log = [&](const std::string& text) { writer.log(text); };
  o.interrupted = [] { return StopSignals::count() > 0; };
  o.block = [&](const sim::State& state) {
    checkpoints.reach(snapshot_of(problem, state, writer.counters()), standing_of(problem, state));
  };
  return o;
}

/// Plays the scene and writes everything. A failed write ends the run; the error says whether it can resume.
sim::Summary play(const sim::Problem& problem, sim::Cache& cache, sim::State state, output::RunWriter& writer,
                  Checkpoints& checkpoints, bool quiet) {
  sim::Summary summary;
  play_guarded(writer.dir(), origin_of(problem), [&] {
    ProgressLine line(!quiet);
    summary = sim::run(problem, state, observer_of(problem, writer, checkpoints, line), cache);
    line.end();
    checkpoints.finish();
    writer.finish(summary);
  });
  return summary;
}

/// A value of the summary for a line of text; a dash when it is not known.
std::string shown(const std::optional<double>& value) { return value ? fmt::format("{:.4g}", *value) : "-"; }

void tell_contact(const sim::ContactSummary& c, bool ring) {
  spdlog::info("contact {}: peak pressure {} MPa, half width {} mm, normal force {:.4g} N{}", c.name,
               shown(c.peak_pressure_MPa), shown(c.contact_half_width_mm), c.normal_force, ring ? "" : "/mm");
  if (!c.ledger_relative_error) return;
  spdlog::info("  {:<10} {:>16} {:>16} {:>16}", "side", "max depth [um]", "scar width [mm]",
               ring ? "volume [mm^3]" : "area [mm^2]");
  const auto row = [](const char* side, const sim::SideSummary& v) {
    spdlog::info("  {:<10} {:>16.4g} {:>16.4g} {:>16.4g}", side, 1e3 * v.max_depth_mm, v.scar_width_mm, v.worn_area);
  };
  row("secondary", c.secondary);
  row("primary", c.primary);
  spdlog::info("  ledger: |removed - coefficient x energy| / sum = {:.2e}", *c.ledger_relative_error);
}

void tell_bond(const sim::BondSummary& b) {
  const auto told = [](const char* what, const sim::TractionPeak& p) {
    if (p.MPa == 0.0) return fmt::format("no {}", what);
    return fmt::format("largest {} {:.4g} MPa at ({:.4g}, {:.4g}) mm, cycle {:.6g}{}", what, p.MPa, p.at_mm.x(),
                       p.at_mm.y(), p.cycle,
                       p.at_end ? ", at the end of the bond, where it grows as elements get shorter" : "");
  };
  spdlog::info("bond {}: {}; {}", b.name, told("tension", b.most.tension), told("shear", b.most.shear));
}

void tell_result(const scene::Scene& scene, const sim::Summary& s, const std::string& dir) {
  spdlog::info("{}: {:g} cycles, {} blocks, {} increments, {} Newton solves, {:.1f} s", output::status_name(s.status),
               s.cycles, s.counts.blocks, s.counts.increments, s.counts.newton_iterations, s.wall_s);
  for (const auto& c : s.contacts) tell_contact(c, s.analysis == base::Analysis::axisymmetric);
  for (const auto& b : s.bonds) tell_bond(b);
  tell_lives(s);
  spdlog::info("page {0}/report.html, pictures {0}/figures/, ParaView {0}/series.pvd, tables {0}/*.csv",
               base::printable(dir));
  tell(scene, s.warnings);
  if (!s.reason.empty()) std::fprintf(stderr, "reye: %s\n", base::printable(s.reason).c_str());
}

}  // namespace

std::string version() { return std::string(output::version) + " (commit " + output::commit() + ")"; }
std::string reference(bool of_solids) { return of_solids ? scene::solid_reference() : scene::reference(); }

std::string schema() { return scene::schema(scene::spec(), scene::solid_spec()); }

int run(const Request& request) {
  if (scene::is_solid(request.path)) return run_solid(request);
  ignore_lost_output();
  const auto scene = read(request);
  const std::string dir = folder_of(request, scene);
  const auto extension = request.restart ? extension_in(dir, scene) : std::nullopt;
  open_or_refuse(dir, scene.name, scene.sha256, extension.has_value(), request.force);
  sim::Cache cache;
  const sim::Problem problem = sim::prepare(scene, &cache);
  for (const auto& text : problem.plan.lines) spdlog::info("{}", base::printable(text));
  output::RunWriter writer(dir, scene);
  for (const auto& text : problem.plan.lines) writer.log(text);
  for (const auto& warning : problem.warnings) writer.log("warning: " + sim::in_words(warning));
  if (extension)
    for (const auto& change : extension->changes) writer.log("extended: " + change);
  if (!request.quiet) tell(problem.scene, problem.warnings);
  const StopSignals stop(true);
  Checkpoints checkpoints(dir, scene.output.checkpoint_s);
  sim::State state = sim::initial_state(problem);
  std::optional<Resumption> resumption;  // refused before anything is made
  if (request.restart) resumption = resumption_of(dir, problem, extension, state, cache);
  const output::FolderLock lock(dir);
  if (resumption)
    resume_folder(*resumption, snapshot_of(problem, state, resumption->counters), standing_of(problem, state), writer,
                  checkpoints);
  else
    begin_folder(problem, state, writer, checkpoints);
  const sim::Summary summary = play(problem, cache, std::move(state), writer, checkpoints, request.quiet);
  tell_result(scene, summary, dir);
  return summary.status == sim::RunStatus::done ? 0 : summary.status == sim::RunStatus::failed ? 1 : 130;
}

int plan(const Request& request) {
  if (scene::is_solid(request.path)) return plan_solid(request);
  const auto start = std::chrono::steady_clock::now();
  sim::Cache cache;
  const sim::Problem problem = sim::prepare(read(request), &cache);
  for (const auto& text : problem.plan.lines) std::printf("%s\n", base::printable(text).c_str());
  for (const auto& text : problem.plan.skipped) std::printf("skipped: %s\n", base::printable(text).c_str());
  if (request.trial_s > 0.0) {
    std::fflush(stdout);
    const double prepared = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    for (const auto& text : sim::in_words(sim::forecast(problem, cache, request.trial_s, prepared)))
      std::printf("%s\n", base::printable(text).c_str());
  }
  tell(problem.scene, problem.warnings);
  return 0;
}

int check(const Request& request) {
  if (scene::is_solid(request.path)) return check_solid(request);
  const sim::Problem problem = sim::prepare(read(request));
  for (int b = 0; b < problem.body_count(); ++b) {
    const auto& mesh = problem.shapes[b]->mesh;
    const auto box = mesh::bounding_box(mesh.X);
    std::printf("body %s: area %.6g mm^2, box [%.6g, %.6g] x [%.6g, %.6g] mm, %d nodes, %d cells\n",
                problem.inputs[b].name.c_str(), mesh::area(mesh), box[0], box[2], box[1], box[3], mesh.node_count(),
                mesh.cell_count());
    for (const auto& [name, boundary] : mesh.boundaries)
      std::printf("  boundary %s: %.6g mm, %zu nodes\n", name.c_str(), mesh::length(mesh.X, boundary),
                  mesh::nodes_of(boundary).size());
  }
  for (const auto& text : problem.plan.lines) std::printf("%s\n", base::printable(text).c_str());
  tell(problem.scene, problem.warnings);
  if (!request.picture.empty()) output::atomic_write(request.picture, output::scene_picture(problem));
  std::printf("ok\n");
  return 0;
}

int mesh(const Request& request) {
  if (scene::is_solid(request.path)) return mesh_solid(request);
  const auto scene = read(request);
  const std::string dir = folder_of(request, scene);
  const sim::Problem problem = sim::prepare(scene);
  sim::Frame frame;
  for (int b = 0; b < problem.body_count(); ++b) {
    sim::BodyFrame body;
    body.name = problem.inputs[b].name;
    body.mesh = std::shared_ptr<const mesh::Mesh>(problem.shapes[b], &problem.shapes[b]->mesh);
    frame.bodies.push_back(std::move(body));
  }
  std::filesystem::create_directories(dir);
  output::atomic_write(dir + "/mesh.vtu", output::mesh_vtu(frame));
  std::printf("%s/mesh.vtu\n", base::printable(dir).c_str());
  return 0;
}

int report(const Request& request) {
  if (const auto identity = output::read_identity(request.path); identity && identity->solid) {
    output::write_solid_report(request.path, request.animation);
    std::printf("%s/report.html\n", base::printable(request.path).c_str());
    return 0;
  }
  output::write_report(request.path, request.animation);
  std::printf("%s/report.html\n", base::printable(request.path).c_str());
  return 0;
}

}  // namespace reye::apps
