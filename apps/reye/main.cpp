#include <iostream>

#include <CLI/CLI.hpp>

#include "base/errors.hpp"
#include "commands.hpp"

int main(int argc, char** argv) {
  using namespace reye;
  CLI::App app{"Reye: how contacts wear. From CAD and a load cycle to the worn shape and the wear life.", "reye"};
  app.set_version_flag("--version", apps::version());
  app.require_subcommand(1);
  apps::Request request;

  const auto with_scene = [&](const char* name, const char* what) {
    auto* command = app.add_subcommand(name, what);
    command->add_option("scene", request.path, "scene file (.toml)")->required();
    return command;
  };
  auto* run = with_scene("run", "run a scene and write its results");
  run->add_option("--out", request.out, "output folder (default: ./<scene name>.out)");
  run->add_flag("--restart", request.restart, "go on from the last checkpoint");
  run->add_flag("--force", request.force, "take over a folder that holds another scene's run");
  run->add_flag("--quiet", request.quiet, "no progress, errors only");
  auto* plan = with_scene("plan", "say what each body and contact is, what is skipped, and why");
  auto* check = with_scene("check", "read scene and geometry, mesh in memory, write nothing");
  auto* mesh = with_scene("mesh", "write the meshes for a look in ParaView");
  mesh->add_option("--out", request.out, "output folder (default: ./<scene name>.out)");
  auto* report = app.add_subcommand("report", "make the page and the pictures of an output folder again");
  report->add_option("dir", request.path, "output folder")->required();
  auto* reference = app.add_subcommand("reference", "the table of scene keys, as it stands in the README")->group("");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    return code == 0 ? 0 : 2;
  }
  try {
    if (*run) return apps::run(request);
    if (*plan) return apps::plan(request);
    if (*check) return apps::check(request);
    if (*mesh) return apps::mesh(request);
    if (*report) return apps::report(request);
    if (*reference) std::cout << apps::reference();
    return 0;
  } catch (const base::InputError& error) {
    std::cerr << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "reye: " << error.what() << '\n';
    return 1;
  }
}
