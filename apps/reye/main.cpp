#include <functional>
#include <iostream>

#include <CLI/CLI.hpp>

#include "algebra/ranks.hpp"
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

using namespace reye;

/// What the command line asks for.
struct Line {
  apps::Request request;
  apps::SweepRequest many;
  apps::CalibrateRequest measured;
  apps::NewRequest start;
  apps::ExportRequest shape;
  bool of_solids = false, of_scars = false;
  std::function<int()> act;  ///< of the command that is given
};

/// A command; its options are added to what is returned.
CLI::App* add_command(CLI::App& app, Line& line, const char* name, const char* what, std::function<int()> act) {
  auto* command = app.add_subcommand(name, what);
  command->callback([&line, act = std::move(act)] { line.act = act; });
  return command;
}

void add_trust(CLI::App& command, bool& trust) {
  command.add_flag("--trust-geometry", trust,
                   "let the scene's geometry files do whatever gmsh can, and take what time and memory they take");
}

CLI::App* add_scene(CLI::App* command, apps::Request& request) {
  command->add_option("scene", request.path, "scene file (.toml)")->required();
  add_trust(*command, request.trust_geometry);
  return command;
}

void add_threads(CLI::App* command, apps::Request& request) {
  command->add_option("--threads", request.threads, "cores to compute on (default: all physical ones)")
      ->check(CLI::Range(1, 1024));
}

void add_run(CLI::App& app, Line& line) {
  auto& request = line.request;
  auto* run = add_scene(
      add_command(app, line, "run", "run a scene and write its results", [&] { return apps::run(request); }), request);
  run->add_option("--out", request.out, "output folder (default: ./<scene name>.out)");
  run->add_flag("--restart", request.restart,
                "resume from the last checkpoint; a run that has ended resumes when its scene has more cycles in the "
                "last step or other limits");
  run->add_flag("--force", request.force, "take over a folder that holds another scene's run");
  run->add_flag("--quiet", request.quiet, "no progress, errors only");
  add_threads(run, request);
}

/// Commands that look at a scene.
void add_looks(CLI::App& app, Line& line) {
  auto& request = line.request;
  auto* plan =
      add_scene(add_command(app, line, "plan",
                            "say what each body and contact is, what is skipped and why, and what the run will take",
                            [&] { return apps::plan(request); }),
                request);
  plan->add_option("--trial", request.trial_s, "seconds of the run to play for that (default: 2; 0: none)")
      ->check(CLI::NonNegativeNumber);
  add_threads(plan, request);
  auto* check = add_scene(add_command(app, line, "check", "read scene and geometry, mesh in memory, write nothing",
                                      [&] { return apps::check(request); }),
                          request);
  check->add_option("--picture", request.picture, "draw the scene into this file (.svg)");
  auto* mesh = add_scene(
      add_command(app, line, "mesh", "write the meshes for a look in ParaView", [&] { return apps::mesh(request); }),
      request);
  mesh->add_option("--out", request.out, "output folder (default: ./<scene name>.out)");
}

void add_sweep(CLI::App& app, Line& line) {
  auto& request = line.many;
  auto* sweep = add_command(app, line, "sweep", "run a scene many times with other values, and collect one table",
                            [&] { return apps::sweep(line.many, line.request.quiet); });
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
  sweep->add_flag("--quiet", line.request.quiet, "reasons only");
  add_trust(*sweep, request.trust_geometry);
}

void add_calibrate(CLI::App& app, Line& line) {
  auto& request = line.measured;
  auto& common = line.request;
  auto* calibrate = add_scene(
      add_command(app, line, "calibrate", "find the wear coefficients of a scene from measured scars",
                  [&] { return apps::calibrate(common.path, line.measured, common.trust_geometry, common.quiet); }),
      common);
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
  add_threads(calibrate, common);
  calibrate->add_flag("--force", request.force, "write into a folder that holds something else");
  calibrate->add_flag("--quiet", common.quiet, "results and warnings only");
}

void add_report(CLI::App& app, Line& line) {
  auto& request = line.request;
  auto* report = add_command(app, line, "report", "make the page and the pictures of an output folder again",
                             [&] { return apps::report(request); });
  report->add_option("dir", request.path, "output folder")->required();
  report->add_flag("--animation", request.animation,
                   "bodies, pressure and wear moving from frame to frame, in the page");
}

void add_new(CLI::App& app, Line& line) {
  auto& request = line.start;
  auto* made = add_command(app, line, "new", "make a folder with a commented scene that runs, to start from",
                           [&] { return apps::new_scene(line.start); });
  made->add_option("name", request.name, "name of your part");
  made->add_option("--like", request.like, "kind of contact; --list shows them");
  made->add_option("--out", request.out, "folder to make (default: ./<name>)");
  made->add_flag("--list", request.list, "show the kinds");
}

void add_export(CLI::App& app, Line& line) {
  auto& request = line.shape;
  auto* shape = add_command(app, line, "export", "write the worn shape of a run for CAD or tables",
                            [&] { return apps::export_shape(line.shape); });
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
}

/// Commands that are not in the help: what the project's own pages are made of.
void add_hidden(CLI::App& app, Line& line) {
  const auto print = [](const std::string& text) {
    std::cout << text;
    return 0;
  };
  auto* reference = add_command(
      app, line, "reference", "the table of scene keys, as in geo/REFERENCE.md",
      [&line, print] { return print(line.of_scars ? scene::scar_reference() : apps::reference(line.of_solids)); });
  reference->group("");
  reference->add_flag("--solid", line.of_solids, "of scenes with analysis = \"solid\"");
  reference->add_flag("--scars", line.of_scars, "of what `calibrate` reads");
  add_command(app, line, "schema", "the JSON Schema of scenes, as in geo/scene.schema.json", [print] {
    return print(apps::schema());
  })->group("");
}

}  // namespace

int main(int argc, char** argv) {
  const algebra::Ranks ranks;
  if (ranks.served()) return 0;
  apps::keep_heap();
  CLI::App app{"Reye: how contacts wear. From CAD and a load cycle to the worn shape and the wear life.", "reye"};
  app.set_version_flag("--version", apps::version());
  app.require_subcommand(1);
  Line line;
  for (const auto add : {add_run, add_looks, add_sweep, add_calibrate, add_report, add_new, add_export, add_hidden})
    add(app, line);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    return code == 0 ? 0 : 2;
  }
  try {
    const base::Cores cores(line.request.threads > 0 ? line.request.threads : base::physical_cores());
    return line.act();
  } catch (const base::InputError& error) {
    std::cerr << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "reye: " << base::printable(error.what()) << '\n';
    return 1;
  }
}
