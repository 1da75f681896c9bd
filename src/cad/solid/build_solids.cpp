#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numeric>

#include "base/errors.hpp"
#include "cad/solid/own_solid.hpp"
#include "cad/solid/select_solid.hpp"
#include "cad/solid/skin_of.hpp"
#include "cad/solid/solid_file.hpp"
#include "cad/solid/solid_geometry.hpp"
#include "cad/solid/solid_shape.hpp"
#include "cad/solid/solid_text.hpp"

namespace reye::cad {

namespace {

using Files = std::vector<std::unique_ptr<SolidFile>>;

/// The solids of all files, those that came with a mesh completed.
std::vector<RawSolid> solids_of(const Files& files, const Points3& probes, std::vector<base::Issue>& issues) {
  std::vector<RawSolid> all;
  for (const auto& file : files)
    for (RawSolid& solid : file->solids(probes, issues)) {
      try {
        if (!solid.mesh.cells.empty()) complete_own_solid(solid, probes);
        all.push_back(std::move(solid));
      } catch (const base::MeshError& error) {
        issues.push_back({"geometry", "\"" + file->path() + "\"",
                          (solid.label.empty() ? "a solid" : "'" + solid.label + "'") + ": " + error.what()});
      }
    }
  return all;
}

/// The mesh of a body without its cells: only nodes of the skin, in the order of its facets.
void leave_skin(mesh::SolidMesh& mesh) {
  std::vector<int> number(mesh.X.size(), -1);
  Points3 X;
  for (mesh::Facet& facet : mesh.skin)
    for (int k = 0; k < facet.count(); ++k) {
      int& node = number[facet.nodes[k]];
      if (node < 0) {
        node = static_cast<int>(X.size());
        X.push_back(mesh.X[facet.nodes[k]]);
      }
      facet.nodes[k] = node;
    }
  mesh.X = std::move(X);
  mesh.cells.clear();
}

/// Throws where cells do not reach one another through common nodes. A rigid body may be in several pieces.
void check_in_one_piece(const mesh::SolidMesh& mesh) {
  if (mesh.cells.empty()) return;
  std::vector<int> parent(mesh.X.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int k) {
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
  };
  for (const mesh::SolidCell& cell : mesh.cells)
    for (int k = 1; k < mesh::solid_nodes(mesh.kind); ++k) parent[root(cell[k])] = root(cell[0]);
  for (int node = 0; node < mesh.node_count(); ++node)
    if (root(node) != root(0)) throw base::MeshError("it is in several pieces; each piece must be a body of its own");
}

void check_cells(const mesh::SolidMesh& mesh) {
  for (const mesh::SolidCell& cell : mesh.cells)
    if (!(least_jacobian(mesh.X, mesh.kind, cell) > 0.0))
      throw base::MeshError("gmsh leaves a cell without positive Jacobian at " + text(mesh.X[cell[0]]));
}

/// The skin of a raw mesh with the facets of every named face.
mesh::SolidMesh finished(RawSolidMesh raw, const SolidPlan& plan) {
  mesh::SolidMesh mesh;
  mesh.kind = raw.kind;
  mesh.skin = raw.cells.empty() ? raw.facets : skin_of_cells(raw);
  mesh.X = std::move(raw.nodes);
  mesh.cells = std::move(raw.cells);
  if (mesh.cells.empty()) turn_outward(mesh.X, mesh.skin);
  check_closed(mesh.X, mesh.skin);
  check_cells(mesh);
  check_in_one_piece(mesh);
  for (const mesh::Facet& facet : mesh.skin)
    if (facet.group < 0) throw base::MeshError("a facet of its surface belongs to no face");
  if (plan.options->rigid) leave_skin(mesh);
  for (const auto& [name, faces] : plan.faces) {
    std::vector<int>& facets = mesh.faces[name];
    for (std::size_t f = 0; f < mesh.skin.size(); ++f)
      if (std::find(faces.begin(), faces.end(), mesh.skin[f].group) != faces.end())
        facets.push_back(static_cast<int>(f));
  }
  return mesh;
}

RawSolidMesh raw_mesh_of(const SolidPlan& plan, const SolidOrder& order, const Files& files) {
  if (!plan.solid->mesh.cells.empty()) return plan.solid->mesh;
  const auto file =
      std::find_if(files.begin(), files.end(), [&](const auto& each) { return each->path() == plan.solid->file; });
  RawSolidMesh raw = (*file)->mesh(order, plan.solid->faces.size());
  straighten_bad_cells(raw);
  return raw;
}

SolidFacts facts_of(const SolidPlan& plan, const mesh::SolidMesh& mesh) {
  SolidFacts facts{plan.options->name, plan.solid->volume_mm3, plan.solid->box_mm, {}};
  if (!(facts.volume_mm3 > 0.0)) facts.volume_mm3 = enclosed_volume(mesh.X, mesh.skin);
  for (const auto& [name, faces] : plan.faces)
    for (int f : faces) facts.face_area_mm2[name] += plan.solid->faces[f].area_mm2;
  return facts;
}

/// Elements that are too large for a curved face show in their volume: round a shaft, straight edges that turn by 30
/// degrees take 4 % of it, curved ones next to nothing.
void warn_of_volume(const SolidFacts& facts, const mesh::SolidMesh& mesh, std::vector<std::string>& warnings) {
  const double most = mesh.kind == mesh::SolidKind::tet10 ? 0.02 : 0.05;
  const double meshed = enclosed_volume(mesh.X, mesh.skin);
  if (std::abs(meshed - facts.volume_mm3) <= most * facts.volume_mm3) return;
  warnings.push_back("the mesh of body '" + facts.name + "' encloses " + text(meshed) + " mm^3, its CAD " +
                     text(facts.volume_mm3) + ": its elements are too large for its curved faces or thin walls");
}

/// A CAD often makes one round face of several; `nearest_mm` takes one of them.
void warn_of_part(const SolidPlan& plan, const std::vector<FaceOptions>& faces, const mesh::SolidMesh& mesh,
                  std::vector<std::string>& warnings) {
  const auto joints = smooth_joints(mesh.X, mesh.skin);
  for (const FaceOptions& face : faces) {
    if (face.body != plan.options->name || !face.nearest_mm) continue;
    const int taken = plan.faces.at(face.name).front();
    const std::vector<RawFace>& all = plan.solid->faces;
    for (const auto& [a, b] : joints) {
      if ((a != taken && b != taken) || all[a].type != all[b].type || all[a].type == FaceType::plane) continue;
      warnings.push_back("face '" + face.name + "' is a part of a smooth " + to_string(all[taken].type) +
                         " that another face continues: " + describe(all[a == taken ? b : a]) +
                         "; box_mm or type without nearest_mm takes both");
      break;
    }
  }
}

void warn_of_unit(const SolidPlan& plan, std::vector<std::string>& warnings) {
  constexpr double least_mm = 1e-3, most_mm = 1e5;
  const SolidBox& box = plan.solid->box_mm;
  const double diagonal = base::Vec3(box[3] - box[0], box[4] - box[1], box[5] - box[2]).norm();
  if (diagonal < least_mm || diagonal > most_mm)
    warnings.push_back("body '" + plan.options->name + "' is " + text(diagonal) +
                       " mm large; lengths of files are read as mm, but for STEP and IGES, which name their unit");
}

base::Issue not_meshed(const SolidPlan& plan, const std::string& reason) {
  return {"body." + plan.options->name, "",
          "its solid " + describe(*plan.solid) + " of " + std::filesystem::path(plan.solid->file).filename().string() +
              " cannot be meshed: " + reason};
}

void mesh_bodies(const std::vector<SolidPlan>& plans, const std::vector<SolidOrder>& orders, const Files& files,
                 const std::vector<FaceOptions>& faces, SolidGeometry& geometry, std::vector<base::Issue>& issues) {
  for (std::size_t b = 0; b < plans.size(); ++b) try {
      geometry.bodies.push_back(finished(raw_mesh_of(plans[b], orders[b], files), plans[b]));
      geometry.facts.push_back(facts_of(plans[b], geometry.bodies.back()));
      warn_of_volume(geometry.facts.back(), geometry.bodies.back(), geometry.warnings);
      warn_of_part(plans[b], faces, geometry.bodies.back(), geometry.warnings);
      warn_of_unit(plans[b], geometry.warnings);
    } catch (const base::MeshError& error) {
      issues.push_back(not_meshed(plans[b], error.what()));
    }
}

void throw_if_any(std::vector<base::Issue>& issues) {
  if (!issues.empty()) throw base::InputError(std::move(issues));
}

}  // namespace

SolidGeometry build_solids(const SolidGeometryOptions& options) {
  std::vector<base::Issue> issues;
  if (options.files.empty()) issues.push_back({"geometry", "[]", "names no file"});
  Files files;
  for (const std::string& path : options.files) files.push_back(std::make_unique<SolidFile>(path, options));
  const SolidProbes probes = probes_of(options);
  const std::vector<RawSolid> solids = solids_of(files, probes.points, issues);
  throw_if_any(issues);
  const std::vector<SolidPlan> plans = plan_solids(solids, options, probes, issues);
  check_zones(plans, options, probes, issues);
  std::vector<SolidOrder> orders;
  for (const SolidPlan& plan : plans)
    if (plan.solid) orders.push_back(order_of(plan, options, issues));
  throw_if_any(issues);
  SolidGeometry geometry;
  for (const auto& file : files) geometry.guarded = geometry.guarded && file->guarded();
  mesh_bodies(plans, orders, files, options.faces, geometry, issues);
  throw_if_any(issues);
  return geometry;
}

}  // namespace reye::cad
