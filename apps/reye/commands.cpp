#include "commands.hpp"

#include <chrono>
#include <cstdio>
#include <filesystem>

#include "base/formatted.hpp"
#include "base/printable.hpp"
#include "lives.hpp"
#include "output/folder/files.hpp"
#include "output/folder/folder.hpp"
#include "output/folder/summary.hpp"
#include "output/folder/text.hpp"
#include "output/folder/vtk_frames.hpp"
#include "output/picture/scene_picture.hpp"
#include "output/report/report.hpp"
#include "output/run/commit.hpp"
#include "output/solid/solid_report.hpp"
#include "runs/words.hpp"
#include "scene/read.hpp"
#include "scene/schema.hpp"
#include "scene/solid/solid_keys.hpp"
#include "scene/solid/solid_scene.hpp"
#include "shown.hpp"
#include "sim/study/forecast.hpp"
#include "sim/study/prepare.hpp"
#include "solids.hpp"

namespace reye::apps {

namespace {

using base::formatted;
using Lines = std::vector<std::string>;

std::string folder_of(const Request& request, const scene::Scene& scene) {
  return request.out.empty() ? "./" + scene.name + ".out" : request.out;
}

scene::Scene read(const Request& request) {
  auto scene = scene::read(request.path);
  scene.geometry.trusted = request.trust_geometry;
  return scene;
}

/// A value of the summary for a line of text; a dash when it is not known.
std::string shown(const std::optional<double>& value) { return value ? formatted("%.4g", *value) : "-"; }

void add_contact(const sim::ContactSummary& c, bool ring, Lines& lines) {
  lines.push_back("contact " + c.name + ": peak pressure " + shown(c.peak_pressure_MPa) + " MPa, half width " +
                  shown(c.contact_half_width_mm) +
                  formatted(" mm, normal force %.4g N%s", c.normal_force, ring ? "" : "/mm"));
  if (!c.ledger_relative_error) return;
  lines.push_back(formatted("  %-10s %16s %16s %16s", "side", "max depth [um]", "scar width [mm]",
                            ring ? "volume [mm^3]" : "area [mm^2]"));
  for (const auto& [side, v] : {std::pair("secondary", c.secondary), std::pair("primary", c.primary)})
    lines.push_back(
        formatted("  %-10s %16.4g %16.4g %16.4g", side, 1e3 * v.max_depth_mm, v.scar_width_mm, v.worn_area));
  lines.push_back(formatted("  ledger: |removed - coefficient x energy| / sum = %.2e", *c.ledger_relative_error));
}

std::string bond_line(const sim::BondSummary& b) {
  const auto told = [](const char* what, const sim::TractionPeak& p) {
    if (p.MPa == 0.0) return std::string("no ") + what;
    return formatted("largest %s %.4g MPa at (%.4g, %.4g) mm, cycle %.6g%s", what, p.MPa, p.at_mm.x(), p.at_mm.y(),
                     p.cycle, p.at_end ? ", at the end of the bond, where it grows as elements get shorter" : "");
  };
  return "bond " + b.name + ": " + told("tension", b.most.tension) + "; " + told("shear", b.most.shear);
}

std::string solves_in_words(const sim::Counts& counts) {
  const std::string solves = formatted("%ld Newton solves", counts.newton_iterations);
  return counts.equilibrium_iterations == 0
             ? solves
             : solves + formatted(" and %ld on new shapes", counts.equilibrium_iterations);
}

Lines lines_of(const sim::Summary& s, const std::string& dir) {
  Lines lines{formatted("%s: %g cycles, %ld blocks, %ld increments, %s, %.1f s", output::status_name(s.status),
                        s.cycles, s.counts.blocks, s.counts.increments, solves_in_words(s.counts).c_str(), s.wall_s)};
  for (const auto& c : s.contacts) add_contact(c, s.analysis == base::Analysis::axisymmetric, lines);
  for (const auto& b : s.bonds) lines.push_back(bond_line(b));
  add_lives(s, lines);
  lines.push_back("page " + dir + "/report.html, pictures " + dir + "/figures/, ParaView " + dir +
                  "/series.pvd, tables " + dir + "/*.csv");
  return lines;
}

}  // namespace

std::string version() { return std::string(output::version) + " (commit " + output::commit() + ")"; }
std::string reference(bool of_solids) { return of_solids ? scene::solid_reference() : scene::reference(); }

std::string schema() { return scene::schema(scene::spec(), scene::solid_spec()); }

int run(const Request& request) {
  if (scene::is_solid(request.path)) return run_solid(request);
  const auto scene = read(request);
  const std::string dir = folder_of(request, scene);
  const auto summary = shown_run(request, scene, dir);
  if (!request.quiet) tell_lines(lines_of(summary, dir));
  tell_end(in_words(scene, summary.warnings), summary.reason);
  return code_of(summary.status);
}

int plan(const Request& request) {
  if (scene::is_solid(request.path)) return plan_solid(request);
  const auto start = std::chrono::steady_clock::now();
  sim::Cache cache;
  const sim::Problem problem = sim::prepare(read(request), &cache);
  tell_lines(problem.plan.lines);
  for (const auto& text : problem.plan.skipped) std::printf("skipped: %s\n", base::printable(text).c_str());
  if (request.trial_s > 0.0) {
    std::fflush(stdout);
    const double prepared = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    tell_lines(sim::in_words(sim::forecast(problem, cache, request.trial_s, prepared)));
  }
  tell_warnings(in_words(problem.scene, problem.warnings));
  return 0;
}

int check(const Request& request) {
  if (scene::is_solid(request.path)) return check_solid(request);
  const sim::Problem problem = sim::prepare(read(request));
  tell_lines(body_lines(problem));
  tell_lines(problem.plan.lines);
  tell_warnings(in_words(problem.scene, problem.warnings));
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
