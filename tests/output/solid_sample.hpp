#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "output/folder/files.hpp"
#include "output/solid/solid_run_writer.hpp"
#include "support/solid_blocks.hpp"
#include "support/temporary_folder.hpp"

/// A made-up run of two solids: a block of two hexahedra below, one of second-order tetrahedra above, in contact at
/// z = 1.
namespace solid_sample {

namespace fs = std::filesystem;
namespace mesh = reye::mesh;
namespace sim = reye::sim;
using reye::base::Points3;
using reye::base::Vec3;
using reye::support::TemporaryFolder;

inline std::shared_ptr<const mesh::SolidMesh> lower() {
  return std::make_shared<mesh::SolidMesh>(reye::support::block(mesh::SolidKind::hex8, {2, 1, 1}, Vec3(2.0, 1.0, 1.0)));
}

inline std::shared_ptr<const mesh::SolidMesh> upper() {
  auto block = reye::support::block(mesh::SolidKind::tet10, {1, 1, 1}, Vec3(2.0, 1.0, 1.0));
  for (Vec3& X : block.X) X.z() += 1.0;
  std::map<std::string, std::vector<int>> faces;
  for (const auto& [name, facets] : block.faces) faces["upper_" + name] = facets;
  block.faces = faces;
  return std::make_shared<mesh::SolidMesh>(block);
}

inline reye::scene::SolidScene scene() {
  reye::scene::SolidScene scene;
  scene.title = "Block <on> block";
  scene.name = "blocks";
  scene.sha256 = "abc123";
  scene.text = "analysis = \"solid\"\n";
  reye::cad::SolidBodyOptions flat, pin;
  flat.name = "flat";
  pin.name = "pin & co";
  scene.geometry.bodies = {flat, pin};
  scene.materials["steel"] = reye::material::LinearElastic{2.1e5, 0.3};
  scene.body_material = {{"flat", "steel"}, {"pin & co", "steel"}};
  scene.contacts.push_back({.name = "pad", .secondary = "z1", .primary = {"upper_z0"}, .friction = 0.5});
  reye::body::SolidSupport ground, shaker;
  ground.name = "ground";
  ground.face = "z0";
  for (auto& motion : ground.along) motion.drive = reye::body::Drive::fixed;
  shaker.name = "shaker";
  shaker.face = "upper_z1";
  shaker.rigid = true;
  shaker.along[0] = {reye::body::Drive::moved, {{0.02, "slide"}}, 0.0};
  shaker.along[2] = {reye::body::Drive::loaded, {{-100.0, "press"}}, 0.0};
  scene.supports = {ground, shaker};
  reye::body::SolidLoad oil;
  oil.name = "oil";
  oil.face = "upper_x0";
  oil.pressure_MPa = 3.0;
  scene.loads = {oil};
  scene.histories = {{"press", {{0.0, 0.0}, {1.0, 1.0}}},
                     {"slide", {{0.0, 0.0}, {0.25, 1.0}, {0.75, -1.0}, {1.0, 0.0}}}};
  scene.steps.resize(2);
  scene.steps[0].name = "press";
  scene.steps[0].play = {"press"};
  scene.steps[1].name = "rub";
  scene.steps[1].play = {"slide"};
  scene.steps[1].increments = 4;
  scene.steps[1].cycles = 1.0;
  reye::cad::SolidFineZone zone;
  zone.contact = "pad";
  zone.centre_mm = Vec3(1.0, 0.5, 1.0);
  zone.radius_mm = 0.4;
  zone.size_mm = 0.1;
  scene.geometry.fine_zones = {zone};
  return scene;
}

/// One side of the contact: pressure 10 x over its rows, of which those at x = 0 are open and those at x = 2 slip.
inline sim::SkinRecord side(sim::Side which, const mesh::SolidMesh& mesh, int body, const std::string& face) {
  sim::SkinRecord skin;
  skin.contact = "pad";
  skin.side = which;
  std::map<int, int> row_of;
  for (auto facet : mesh::facets_of(mesh, face)) {
    for (int k = 0; k < facet.count(); ++k) {
      const auto [entry, fresh] = row_of.try_emplace(facet.nodes[k], static_cast<int>(skin.x_mm.size()));
      if (fresh) {
        skin.x_mm.push_back(mesh.X[facet.nodes[k]]);
        skin.node.push_back(facet.nodes[k]);
      }
      facet.nodes[k] = entry->second;
    }
    skin.facets.push_back(facet);
  }
  skin.body.assign(skin.x_mm.size(), body);
  for (const Vec3& x : skin.x_mm) {
    skin.pressure_MPa.push_back(10.0 * x.x());
    skin.shear_MPa.push_back(Vec3(-2.0 * x.x(), 0.5, 0.0));
    skin.slip_mm.push_back(x.x() > 1.5 ? Vec3(1e-3, 0.0, 0.0) : Vec3(Vec3::Zero()));
    skin.normal.push_back(which == sim::Side::secondary ? Vec3::UnitZ() : Vec3(-Vec3::UnitZ()));
    skin.area_mm2.push_back(0.25);
    skin.wear_depth_mm.push_back(0.002);
    skin.status.push_back(x.x() == 0.0 ? 0 : x.x() > 1.5 ? 2 : 1);
  }
  return skin;
}

inline sim::SolidFrame frame(double cycle, double load = 1.0) {
  sim::SolidFrame frame{cycle, 1.0, "rub", {}, {}};
  const auto flat = lower(), pin = upper();
  for (const auto& [name, mesh] : {std::pair("flat", flat), std::pair("pin & co", pin)})
    frame.bodies.push_back({name, mesh, Points3(mesh->X.size(), Vec3(0.25, 0.0, -0.5)),
                            std::vector<std::array<double, 6>>(mesh->X.size(), {7.0, 0.0, 0.0, 0.0, 0.0, 0.0})});
  frame.surfaces = {side(sim::Side::secondary, *flat, 0, "z1"), side(sim::Side::primary, *pin, 1, "upper_z0")};
  for (auto& skin : frame.surfaces)
    for (double& p : skin.pressure_MPa) p *= load;
  return frame;
}

inline sim::SolidIncrement increment(const std::string& step, double cycle, double progress) {
  sim::SkinContactRow contact;
  contact.pressure_max_MPa = 20.0;
  contact.area_mm2 = 1.5;
  contact.stick_area_mm2 = 0.5;
  contact.force_N = Vec3(-30.0, 0.0, -100.0);
  contact.normal_force_N = 100.0;
  contact.tangential_force_N = 30.0;
  contact.energy_mJ = 0.1 * (cycle + progress);
  contact.volume_secondary_mm3 = 0.25;
  sim::SupportRow below, above;
  below.force_N = Vec3(-30.0, 0.0, 100.0);
  below.moment_N_mm = Vec3(1.0, 2.0, 3.0);
  above.force_N = -below.force_N;
  return {step, cycle, progress, 4, {contact}, {below, above}};
}

inline sim::SolidSummary summary() {
  sim::SolidSummary summary;
  summary.title = scene().title;
  summary.cycles = 1.0;
  sim::SkinContactSummary pad;
  pad.name = "pad";
  pad.peak_pressure_MPa = 20.0;
  pad.area_mm2 = 1.5;
  pad.half_widths_mm = {0.75, 0.0};
  pad.normal_force_N = 100.0;
  summary.contacts = {pad};
  summary.probes["tip"] = Vec3(0.1, 0.2, std::nan(""));
  summary.warnings = {{"resolution", "contact pad", "2 facets touch & more.", 4.0}};
  summary.counts.increments = 5;
  summary.balance = 1e-14;
  summary.size = {39, 117, 8, 12, 1.5, 0.1};
  summary.phase_seconds = {{"mesh", 1.0}, {"factor", 3.0}};
  summary.scene_sha256 = "abc123";
  return summary;
}

/// A whole run of five increments and three frames; `load`: of the last frame.
inline void write_run(const std::string& dir, const reye::scene::SolidScene& of = scene(), bool finish = true) {
  reye::output::SolidRunWriter writer(dir, of);
  writer.log("first line");
  writer.begin();
  writer.frame(frame(0.0, 0.0));
  writer.increment(increment("press", 0.0, 1.0));
  writer.frame(frame(0.0));
  for (int i = 1; i <= 4; ++i) writer.increment(increment("rub", 0.25 * i, 0.25 * i));
  writer.frame(frame(1.0));
  if (finish) writer.finish(summary());
}

inline std::string text(const std::string& dir, const std::string& file) {
  return reye::output::read_text((fs::path(dir) / file).string());
}

}  // namespace solid_sample
