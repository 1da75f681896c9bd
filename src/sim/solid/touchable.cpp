#include "sim/solid/touchable.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "body/solid/solid_turning.hpp"
#include "mesh/solid/solid_measure.hpp"
#include "scene/histories.hpp"

namespace reye::sim {

namespace {

bool inside(const cad::SolidFineZone& zone, const Vec3& x, double margin) {
  const Vec3 d = x - zone.centre_mm;
  if (zone.radius_mm > 0.0) return d.norm() <= zone.radius_mm + margin;
  return (d.cwiseAbs() - zone.half_widths_mm).maxCoeff() <= margin;
}

/// Facets of one face and what they are near to.
struct FaceView {
  const mesh::SolidMesh& mesh;
  const std::vector<int>& facets;
};

FaceView view(const SolidMeshes& meshes, const contact::FaceRef& ref) {
  const auto& mesh = *meshes[static_cast<std::size_t>(ref.body)];
  return {mesh, mesh.faces.at(ref.face)};
}

Vec3 centre_of(const Points3& X, const mesh::Facet& facet) {
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < facet_corners(facet.kind); ++k) sum += X[facet.nodes[k]];
  return sum / facet_corners(facet.kind);
}

Eigen::AlignedBox3d box_of(const Points3& X, const mesh::Facet& facet) {
  Eigen::AlignedBox3d box;
  for (int k = 0; k < facet.count(); ++k) box.extend(X[facet.nodes[k]]);
  return box;
}

void take(const mesh::Facet& facet, std::vector<char>& nodes) {
  for (int k = 0; k < facet.count(); ++k) nodes[facet.nodes[k]] = 1;
}

/// Nodes of all facets that have one of the nodes.
bool add_ring(const FaceView& face, std::vector<char>& nodes) {
  const std::vector<char> before = nodes;
  for (const int index : face.facets) {
    const auto& facet = face.mesh.skin[index];
    if (std::any_of(facet.nodes.begin(), facet.nodes.begin() + facet.count(), [&](int n) { return before[n] != 0; }))
      take(facet, nodes);
  }
  return nodes != before;
}

/// Poses through which supports drive a body about one axis, a tenth of a radian from one to the next; else the drawn
/// one alone.
std::vector<body::SolidPose> driven_poses(const SolidProblem& problem, const body::SolidInput& input) {
  std::vector<body::SolidPose> poses{body::SolidPose{}};
  const auto pivot = body::solid_pivot(input);
  if (!pivot) return poses;
  Vec3 most = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
    if (pivot->motions[3 + k].drive == body::Drive::moved)
      most += scene::largest_value({problem.scene.histories, problem.scene.steps}, pivot->motions[3 + k].parts) *
              pivot->axes.col(k);
  const double angle = std::min(most.norm(), std::numbers::pi);
  for (double turn = 0.1; turn < angle + 0.1; turn += 0.1)
    for (const double sign : {-1.0, 1.0}) {
      auto& pose = poses.emplace_back();
      pose.R = base::turn_by(sign * std::min(turn, angle) * most.normalized()).toRotationMatrix();
      pose.centre = pivot->centre;
    }
  return poses;
}

void take_in_zones(const SolidProblem& problem, const SolidMeshes& meshes, const std::string& contact,
                   const contact::FaceRef& ref, std::vector<char>& nodes) {
  const auto face = view(meshes, ref);
  const auto poses = driven_poses(problem, problem.inputs[ref.body]);
  const auto passes = [&](const cad::SolidFineZone& zone, const Vec3& X) {
    return std::any_of(poses.begin(), poses.end(),
                       [&](const auto& pose) { return inside(zone, pose.place(X, Vec3::Zero()), 0.0); });
  };
  for (const int index : face.facets) {
    const auto& facet = face.mesh.skin[index];
    for (const auto& zone : problem.scene.geometry.fine_zones)
      if (zone.contact == contact)
        for (int k = 0; k < facet_corners(facet.kind); ++k)
          if (passes(zone, face.mesh.X[facet.nodes[k]])) take(facet, nodes);
  }
}

void take_near(const SolidMeshes& meshes, const PlacedSkins& contact, const contact::FaceRef& ref,
               const std::vector<contact::FaceRef>& others, std::vector<char>& nodes) {
  const auto face = view(meshes, ref);
  std::vector<Eigen::AlignedBox3d> facing;  // of facets: a large one faces a small one far from its own nodes
  for (const auto& other : others) {
    const auto& mesh = *meshes[static_cast<std::size_t>(other.body)];
    for (const auto& facet : mesh::facets_of(mesh, other.face)) facing.push_back(box_of(mesh.X, facet));
  }
  for (const int index : face.facets) {
    const auto& facet = face.mesh.skin[index];
    const double reach = contact.drawn_mm + 2.0 * std::sqrt(mesh::facet_area(face.mesh.X, facet));
    const Vec3 centre = centre_of(face.mesh.X, facet);
    if (std::any_of(facing.begin(), facing.end(),
                    [&](const auto& box) { return box.squaredExteriorDistance(centre) <= reach * reach; }))
      take(facet, nodes);
  }
}

}  // namespace

SolidMeshes drawn_meshes(const SolidProblem& problem) {
  SolidMeshes meshes;
  for (const auto& input : problem.inputs) meshes.push_back(input.mesh);
  return meshes;
}

Touchable touchable_nodes(const SolidProblem& problem, const SolidMeshes& meshes) {
  Touchable touchable;
  for (const auto& mesh : meshes) touchable.emplace_back(mesh->X.size(), 0);
  for (const auto& contact : problem.contacts) {
    const auto& zones = problem.scene.geometry.fine_zones;
    const bool zoned =
        std::any_of(zones.begin(), zones.end(), [&](const auto& zone) { return zone.contact == contact.options.name; });
    const auto choose = [&](const contact::FaceRef& ref, const std::vector<contact::FaceRef>& others) {
      auto& nodes = touchable[ref.body];
      if (zoned)
        take_in_zones(problem, meshes, contact.options.name, ref, nodes);
      else
        take_near(meshes, contact, ref, others, nodes);
      add_ring(view(meshes, ref), nodes);
    };
    choose(contact.secondary, contact.primary);
    for (const auto& ref : contact.primary) choose(ref, {contact.secondary});
  }
  return touchable;
}

void take_beside(const mesh::SolidMesh& mesh, const std::string& face, const Points3& places,
                 std::vector<char>& nodes) {
  for (const int index : mesh.faces.at(face)) {
    const auto& facet = mesh.skin[index];
    const double reach = mesh::facet_area(mesh.X, facet);  // square of its size
    const Vec3 centre = centre_of(mesh.X, facet);
    if (std::any_of(places.begin(), places.end(), [&](const Vec3& x) { return (x - centre).squaredNorm() <= reach; }))
      take(facet, nodes);
  }
}

Touchable contact_nodes(const SolidProblem& problem, const SolidMeshes& meshes) {
  Touchable all;
  for (const auto& mesh : meshes) all.emplace_back(mesh->X.size(), 0);
  const auto add = [&](const contact::FaceRef& ref) {
    const auto face = view(meshes, ref);
    for (const int index : face.facets) take(face.mesh.skin[index], all[ref.body]);
  };
  for (const auto& contact : problem.contacts) {
    add(contact.secondary);
    for (const auto& ref : contact.primary) add(ref);
  }
  return all;
}

bool grow(const SolidProblem& problem, const SolidMeshes& meshes, Touchable& touchable, int rings) {
  bool any = false;
  for (int ring = 0; ring < rings; ++ring)
    for (const auto& contact : problem.contacts) {
      any = add_ring(view(meshes, contact.secondary), touchable[contact.secondary.body]) || any;
      for (const auto& ref : contact.primary) any = add_ring(view(meshes, ref), touchable[ref.body]) || any;
    }
  return any;
}

}  // namespace reye::sim
