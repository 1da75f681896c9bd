#pragma once
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "output/folder/files.hpp"
#include "output/run/run_writer.hpp"
#include "support/temporary_folder.hpp"
#include "support/texts.hpp"

/// A made-up fretting run of a block on a flat and a rigid bar: enough to fill every output.
namespace sample {

namespace fs = std::filesystem;
using reye::base::Analysis;
using reye::base::Vec2;
namespace sim = reye::sim;
using reye::support::TemporaryFolder;

inline reye::scene::Scene scene(Analysis analysis = Analysis::plane_strain) {
  reye::scene::Scene scene;
  scene.title = "Cylinder on flat <steel & steel>";
  scene.name = "fretting";
  scene.sha256 = "abc123";
  scene.analysis = analysis;
  scene.contacts.push_back({.name = "pad", .secondary = "face", .primary = {"round"}, .friction = 0.9, .wear = {}});
  for (const char* name : {"holder", "shaker"}) {
    reye::body::Support support;
    support.name = name;
    scene.supports.push_back(support);
  }
  return scene;
}

/// nx by ny quads on [-1, 1] x [y0, y0 + 0.5].
inline reye::mesh::Mesh block(int nx, int ny, double y0) {
  reye::mesh::Mesh mesh;
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) mesh.X.emplace_back(-1.0 + 2.0 * i / nx, y0 + 0.5 * j / ny);
  const auto id = [nx](int i, int j) { return j * (nx + 1) + i; };
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      mesh.cells.push_back(reye::mesh::cell_of({id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)}));
  reye::mesh::Chain loop;
  for (int i = 0; i < nx; ++i) loop.push_back(id(i, 0));
  for (int j = 0; j < ny; ++j) loop.push_back(id(nx, j));
  for (int i = nx; i > 0; --i) loop.push_back(id(i, ny));
  for (int j = ny; j >= 0; --j) loop.push_back(id(0, j));
  mesh.outline = {loop};
  return mesh;
}

/// A rigid bar: outline only.
inline reye::mesh::Mesh bar() {
  reye::mesh::Mesh mesh;
  mesh.X = {{-1.0, 1.0}, {1.0, 1.0}, {1.0, 1.2}, {-1.0, 1.2}};
  mesh.outline = {{0, 1, 2, 3, 0}};
  return mesh;
}

inline sim::BodyFrame body_frame(const std::string& name, reye::mesh::Mesh mesh, double u_y) {
  sim::BodyFrame frame;
  frame.name = name;
  const auto nodes = mesh.X.size();
  const bool rigid = mesh.cells.empty();
  frame.mesh = std::make_shared<const reye::mesh::Mesh>(std::move(mesh));
  frame.u.assign(nodes, Vec2(0.25, u_y));
  if (!rigid) frame.stress_MPa.assign(nodes, {-100.0, -200.0, 30.0, -90.0});
  frame.wear_depth_mm.assign(nodes, 0.0);
  return frame;
}

/// Nodes [first, first + count) of a body as a surface with a wear scar that grows with the cycle.
inline sim::SurfaceRecord surface(sim::Side side, int body, const sim::BodyFrame& frame, int first, int count,
                                  double cycle) {
  sim::SurfaceRecord s;
  s.contact = "pad";
  s.side = side;
  const double grown = cycle / 18000.0, a = 0.12 + 0.35 * std::sqrt(grown), p0 = 400.0 * 0.12 / a;
  for (int i = 0; i < count; ++i) {
    const Vec2 X = frame.mesh->X[static_cast<std::size_t>(first + i)];
    const double r = X.x() / a, hertz = std::abs(r) < 1.0 ? std::sqrt(1.0 - r * r) : 0.0;
    s.body.push_back(body);
    s.node.push_back(first + i);
    s.body_on_left.push_back(side == sim::Side::primary);  // x grows along both, the secondary body is below
    s.arc_length_mm.push_back(X.x() + 1.0);
    s.x_mm.push_back(X.x());
    s.y_mm.push_back(X.y());
    s.pressure_MPa.push_back(p0 * hertz);
    s.shear_MPa.push_back(0.9 * p0 * hertz * (std::abs(r) > 0.5 ? 1.0 : 0.3 + 2.8 * r * r));
    s.slip_mm.push_back(cycle * 0.05 * hertz);
    s.wear_depth_mm.push_back((side == sim::Side::secondary ? 0.0025 : 0.0016) * grown * hertz * hertz);
    s.status.push_back(hertz == 0.0 ? 0 : (std::abs(r) < 0.5 ? 1 : 2));
  }
  return s;
}

/// nx sets the fineness, so that two frames can differ in topology.
inline sim::Frame frame(double cycle, int nx = 8) {
  sim::Frame f{.cycle = cycle, .step = "wear", .bodies = {}, .surfaces = {}, .bonds = {}};
  f.bodies.push_back(body_frame("flat", block(nx, 2, -0.5), -0.01));
  f.bodies.push_back(body_frame("pad, upper", block(nx, 2, 0.0), -0.02));
  f.bodies.push_back(body_frame("bar", bar(), -0.03));
  f.surfaces.push_back(surface(sim::Side::secondary, 0, f.bodies[0], 2 * (nx + 1), nx + 1, cycle));
  f.surfaces.push_back(surface(sim::Side::primary, 1, f.bodies[1], 0, nx + 1, cycle));
  return f;
}

/// The columns of those rows.
inline const reye::output::HistoryColumns columns{{"pad"}, {{"holder"}, {"shaker"}}};

inline sim::IncrementRecord increment(int k, double cycle) {
  const double t = k / 40.0, force = 12.0 * std::sin(2.0 * M_PI * t);
  sim::IncrementRecord r;
  r.step = "wear, main";
  r.cycle = cycle;
  r.progress = t;
  r.newton = 3;
  r.pressure_max_MPa = 400.0 / 3.0;
  r.depth_max_secondary_mm = 1e-7 * cycle;
  r.depth_max_primary_mm = 0.7e-7 * cycle;
  r.energy_mJ = 0.9 * cycle + t;
  r.contacts = {{.pressure_max_MPa = 400.0 / 3.0,
                 .depth_max_secondary_mm = 1e-7 * cycle,
                 .depth_max_primary_mm = 0.7e-7 * cycle,
                 .energy_mJ = 0.9 * cycle + t,
                 .normal_force = 18.5,
                 .tangential_force = force}};
  r.support_forces = {Vec2(force, -18.5), Vec2(-force, 18.5)};
  r.support_moments = {{}, {}};
  return r;
}

inline sim::RemeshRecord remesh(double cycle) {
  return {.step = "wear, main",
          .cycle = cycle,
          .body = "pad, upper",
          .reason = "worn at (0, 1) mm: 0.6 of the element below",
          .nodes_before = 120,
          .nodes_after = 135,
          .scaled_jacobian_before = 0.28,
          .scaled_jacobian_after = 2.0 / 3.0,
          .projection_mm = 1e-5,
          .area_residue = -3e-9,
          .gap_moved_mm = 4e-6,
          .gap_left_mm = 5e-9,
          .pressure_jump = 0.0123,
          .peak_jump = 0.0045,
          .force_jump = 1e-3 / 3.0,
          .energy_jump = 4e-4,
          .mesh_seconds = 0.04,
          .seconds = 0.1};
}

inline sim::Summary summary(Analysis analysis = Analysis::plane_strain, double cycles = 18000.0) {
  sim::Summary s;
  s.title = scene().title;
  s.cycles = cycles;
  s.contacts.push_back({.name = "pad",
                        .peak_pressure_MPa = 102.3,
                        .contact_half_width_mm = 0.47,
                        .stick_half_width_mm = {},
                        .normal_force = 18.5,
                        .tangential_force = 12.0,
                        .dissipated_energy = 16200.5,
                        .secondary = {0.0025, 1.61e-3, 0.92},
                        .primary = {0.0016, 1.06e-3, 0.92},
                        .ledger_relative_error = 3.1e-14});
  s.probes["edge"] = Vec2(1e-3, -2e-3);
  s.life_cycles = {{"deep", 17000.0}, {"deeper", std::nullopt}};
  s.counts = {.blocks = 180,
              .increments = 7250,
              .newton_iterations = 21750,
              .factorisations = 361,
              .remeshes = 0,
              .cutbacks = 2,
              .equilibrium_iterations = 720};
  s.wall_s = 120.0;
  s.cpu_s = 118.0;
  s.peak_rss_MB = 340.0;
  s.room_seconds = {{"algebra", 40.0}, {"mortar", 30.5}, {"solver", 20.25}, {"output", 3.0}};
  s.skipped = {"body 'flat': geometric nonlinearity, strains stay small", "plasticity: no body yields"};
  s.cutback_reasons = {"cycle 0, step 'press': no convergence in 30 iterations"};
  s.scene_sha256 = scene().sha256;
  s.analysis = analysis;
  return s;
}

/// A whole run with 10 frames in `dir`.
inline void write_run(const std::string& dir, int nx = 200) {
  reye::output::RunWriter writer(dir, scene());
  writer.begin();
  writer.log("run begins");
  for (int block = 0; block <= 9; ++block) {
    const double cycle = 2000.0 * block;
    for (int k = 1; k <= 40; ++k) writer.increment(increment(k, cycle));
    writer.frame(frame(cycle, nx));
  }
  writer.finish(summary());
}

/// Every file of a folder with its bytes, but for those that end so, and for the time in the log.
inline std::map<std::string, std::string> contents(const std::string& dir, const std::set<fs::path>& without = {}) {
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(dir))
    if (entry.is_regular_file() && !without.contains(entry.path().extension()))
      all[fs::relative(entry.path(), dir).string()] =
          reye::support::without_report_time(reye::output::read_text(entry.path().string()));
  return all;
}

}  // namespace sample
