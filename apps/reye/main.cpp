#include <algorithm>
#include <iostream>

#include <CLI/CLI.hpp>

#include "base/cores.hpp"
#include "base/errors.hpp"
#include "base/printable.hpp"
#include "calibrate.hpp"
#include "commands.hpp"
#include "export.hpp"
#include "heap.hpp"
#include "many.hpp"
#include "new_scene.hpp"
#include "scene/scars.hpp"

namespace {

void add_trust(CLI::App& command, bool& trust) {
  command.add_flag("--trust-geometry", trust,
                   "let the scene's geometry files do whatever gmsh can, and take what time and memory they take");
}

CLI::App* add_sweep(CLI::App& app, reye::apps::SweepRequest& request, bool& quiet) {
  auto* sweep = app.add_subcommand("sweep", "run a scene many times with other values, and collect one table");
  sweep->add_option("scene", request.path, "scene file (.toml)")->required();
  sweep->add_option("--vary", request.vary, "KEY=a:b:n, KEY=log:a:b:n or KEY=v1,v2,...; several: the full grid")
      ->required()
      ->allow_extra_args(false);
  sweep->add_option("--out", request.out, "folder of the sweep (default: ./<scene name>.sweep)");
  sweep->add_option("--jobs", request.jobs, "members at once (default: one per core)")->check(CLI::PositiveNumber);
  auto* member = sweep->add_option("--member", request.member, "run this one only, as a job of an array does");
  member->check(CLI::NonNegativeNumber);
  auto* slurm =
      sweep->add_flag("--slurm", request.slurm, "submit the members as a job array to Slurm and wait for them");
  auto* table = sweep->add_flag("--table", request.table, "run nothing, collect the table");
  member->excludes(slurm)->excludes(table);
  slurm->excludes(table);
  sweep->add_flag("--force", request.force, "run every member again, whatever its folder holds");
  sweep->add_flag("--quiet", quiet, "reasons only");
  add_trust(*sweep, request.trust_geometry);
  return sweep;
}

/// The whole command line of `reye calibrate`.
struct CalibrateLine {
  std::string path;
  reye::apps::CalibrateRequest request;
  int threads = 0;
  bool trust_geometry = false, quiet = false;
};

CLI::App* add_calibrate(CLI::App& app, CalibrateLine& line) {
  auto& request = line.request;
  auto* calibrate = app.add_subcommand("calibrate", "find the wear coefficients of a scene from measured scars");
  calibrate->add_option("scene", line.path, "scene file (.toml)")->required();
  calibrate->add_option("--measured", request.measured, "scar as a table (.csv), or several and numbers (.toml)")
      ->required();
  calibrate->add_option("--at", request.at, "cycles after which scars were measured that name none")
      ->check(CLI::PositiveNumber);
  calibrate
      ->add_option("--free", request.free,
                   "KEY=LOW:HIGH, a further value to find between two bounds, by runs of its own; several times")
      ->allow_extra_args(false);
  calibrate->add_option("--contact", request.contact, "contact of scars that name none");
  calibrate->add_option("--side", request.side, "side of scars that name none: secondary or primary")
      ->check(CLI::IsMember({"secondary", "primary"}));
  calibrate->add_option("--out", request.out, "output folder (default: ./<scene name>.calibration)");
  calibrate->add_option("--threads", line.threads, "cores to compute on (default: all physical ones)")
      ->check(CLI::Range(1, 1024));
  calibrate->add_flag("--force", request.force, "write into a folder that holds something else");
  calibrate->add_flag("--quiet", line.quiet, "results and warnings only");
  add_trust(*calibrate, line.trust_geometry);
  return calibrate;
}

CLI::App* add_new(CLI::App& app, reye::apps::NewRequest& request) {
  auto* made = app.add_subcommand("new", "make a folder with a commented scene that runs, to start from");
  made->add_option("name", request.name, "name of your part");
  made->add_option("--like", request.like, "kind of contact; --list shows them");
  made->add_option("--out", request.out, "folder to make (default: ./<name>)");
  made->add_flag("--list", request.list, "show the kinds");
  return made;
}

CLI::App* add_export(CLI::App& app, reye::apps::ExportRequest& request) {
  auto* shape = app.add_subcommand("export", "write the worn shape of a run for CAD or tables");
  shape->add_option("dir", request.dir, "output folder")->required();
  shape->add_option("--format", request.format, "csv, dxf, step or stl (of solids: stl or csv)");
  auto* cycle = shape->add_option("--cycle", request.cycle, "the shape at this cycle (default: the last frame)");
  shape->add_option("--frame", request.frame, "the shape of this frame, from 0; --list shows them")
      ->check(CLI::NonNegativeNumber)
      ->excludes(cycle);
  shape->add_option("--body", request.body, "this body alone");
  shape->add_option("--thickness", request.thickness_mm, "of a plane body as stl: its extrusion along z [mm]");
  shape->add_option("--out", request.out, "file to write (default: ./<run>_cycle_<cycle>.<format>)");
  shape->add_flag("--list", request.list, "show the frames of the run");
  shape->add_flag("--force", request.force, "replace a file that is no former export");
  return shape;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace reye;
  apps::keep_heap();
  CLI::App app{"Reye: how contacts wear. From CAD and a load cycle to the worn shape and the wear life.", "reye"};
  app.set_version_flag("--version", apps::version());
  app.require_subcommand(1);
  apps::Request request;

  const auto with_scene = [&](const char* name, const char* what) {
    auto* command = app.add_subcommand(name, what);
    command->add_option("scene", request.path, "scene file (.toml)")->required();
    add_trust(*command, request.trust_geometry);
    return command;
  };
  auto* run = with_scene("run", "run a scene and write its results");
  run->add_option("--out", request.out, "output folder (default: ./<scene name>.out)");
  run->add_flag("--restart", request.restart,
                "resume from the last checkpoint; a run that has ended resumes when its scene has more cycles in the "
                "last step or other limits");
  run->add_flag("--force", request.force, "take over a folder that holds another scene's run");
  run->add_flag("--quiet", request.quiet, "no progress, errors only");
  const auto with_threads = [&request](CLI::App* command) {
    command->add_option("--threads", request.threads, "cores to compute on (default: all physical ones)")
        ->check(CLI::Range(1, 1024));
  };
  with_threads(run);
  auto* plan =
      with_scene("plan", "say what each body and contact is, what is skipped and why, and what the run will take");
  plan->add_option("--trial", request.trial_s, "seconds of the run to play for that (default: 2; 0: none)")
      ->check(CLI::NonNegativeNumber);
  with_threads(plan);
  auto* check = with_scene("check", "read scene and geometry, mesh in memory, write nothing");
  check->add_option("--picture", request.picture, "draw the scene into this file (.svg)");
  auto* mesh = with_scene("mesh", "write the meshes for a look in ParaView");
  mesh->add_option("--out", request.out, "output folder (default: ./<scene name>.out)");
  apps::SweepRequest many;
  auto* sweep = add_sweep(app, many, request.quiet);
  CalibrateLine measured;
  auto* calibrate = add_calibrate(app, measured);
  auto* report = app.add_subcommand("report", "make the page and the pictures of an output folder again");
  report->add_option("dir", request.path, "output folder")->required();
  report->add_flag("--animation", request.animation,
                   "bodies, pressure and wear moving from frame to frame, in the page");
  apps::NewRequest start;
  auto* made = add_new(app, start);
  apps::ExportRequest shape;
  auto* exported = add_export(app, shape);
  auto* reference = app.add_subcommand("reference", "the table of scene keys, as in geo/REFERENCE.md")->group("");
  bool of_solids = false, of_scars = false;
  reference->add_flag("--solid", of_solids, "of scenes with analysis = \"solid\"");
  reference->add_flag("--scars", of_scars, "of what `calibrate` reads");
  auto* schema = app.add_subcommand("schema", "the JSON Schema of scenes, as in geo/scene.schema.json")->group("");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    return code == 0 ? 0 : 2;
  }
  try {
    const int threads = std::max(request.threads, measured.threads);
    const base::Cores cores(threads > 0 ? threads : base::physical_cores());
    if (*run) return apps::run(request);
    if (*plan) return apps::plan(request);
    if (*check) return apps::check(request);
    if (*sweep) return apps::sweep(many, request.quiet);
    if (*calibrate) return apps::calibrate(measured.path, measured.request, measured.trust_geometry, measured.quiet);
    if (*mesh) return apps::mesh(request);
    if (*report) return apps::report(request);
    if (*made) return apps::new_scene(start);
    if (*exported) return apps::export_shape(shape);
    if (*reference) std::cout << (of_scars ? scene::scar_reference() : apps::reference(of_solids));
    if (*schema) std::cout << apps::schema();
    return 0;
  } catch (const base::InputError& error) {
    std::cerr << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "reye: " << base::printable(error.what()) << '\n';
    return 1;
  }
}
