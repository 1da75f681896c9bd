#include "sim/solid/touchable.hpp"

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

FaceView view(const SolidProblem& problem, const contact::FaceRef& ref) {
  const auto& mesh = *problem.inputs[ref.body].mesh;
  return {mesh, mesh.faces.at(ref.face)};
}

Vec3 centre_of(const Points3& X, const mesh::Facet& facet) {
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < facet_corners(facet.kind); ++k) sum += X[facet.nodes[k]];
  return sum / facet_corners(facet.kind);
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

void take_in_zones(const SolidProblem& problem, const std::string& contact, const contact::FaceRef& ref,
                   std::vector<char>& nodes) {
  const auto face = view(problem, ref);
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

void take_near(const SolidProblem& problem, const PlacedSkins& contact, const contact::FaceRef& ref,
               const std::vector<contact::FaceRef>& others, std::vector<char>& nodes) {
  const auto face = view(problem, ref);
  std::vector<const Vec3*> facing;
  for (const auto& other : others)
    for (const int node : mesh::nodes_of(mesh::facets_of(*problem.inputs[other.body].mesh, other.face)))
      facing.push_back(&problem.inputs[other.body].mesh->X[node]);
  for (const int index : face.facets) {
    const auto& facet = face.mesh.skin[index];
    const double reach = contact.drawn_mm + 2.0 * std::sqrt(mesh::facet_area(face.mesh.X, facet));
    const Vec3 centre = centre_of(face.mesh.X, facet);
    if (std::any_of(facing.begin(), facing.end(),
                    [&](const Vec3* x) { return (*x - centre).squaredNorm() <= reach * reach; }))
      take(facet, nodes);
  }
}

}  // namespace

Touchable touchable_nodes(const SolidProblem& problem) {
  Touchable touchable;
  for (const auto& input : problem.inputs) touchable.emplace_back(input.mesh->X.size(), 0);
  for (const auto& contact : problem.contacts) {
    const auto& zones = problem.scene.geometry.fine_zones;
    const bool zoned =
        std::any_of(zones.begin(), zones.end(), [&](const auto& zone) { return zone.contact == contact.options.name; });
    const auto choose = [&](const contact::FaceRef& ref, const std::vector<contact::FaceRef>& others) {
      auto& nodes = touchable[ref.body];
      if (zoned)
        take_in_zones(problem, contact.options.name, ref, nodes);
      else
        take_near(problem, contact, ref, others, nodes);
      add_ring(view(problem, ref), nodes);
    };
    choose(contact.secondary, contact.primary);
    for (const auto& ref : contact.primary) choose(ref, {contact.secondary});
  }
  return touchable;
}

Touchable contact_nodes(const SolidProblem& problem) {
  Touchable all;
  for (const auto& input : problem.inputs) all.emplace_back(input.mesh->X.size(), 0);
  const auto add = [&](const contact::FaceRef& ref) {
    const auto face = view(problem, ref);
    for (const int index : face.facets) take(face.mesh.skin[index], all[ref.body]);
  };
  for (const auto& contact : problem.contacts) {
    add(contact.secondary);
    for (const auto& ref : contact.primary) add(ref);
  }
  return all;
}

bool grow(const SolidProblem& problem, Touchable& touchable, int rings) {
  bool any = false;
  for (int ring = 0; ring < rings; ++ring)
    for (const auto& contact : problem.contacts) {
      any = add_ring(view(problem, contact.secondary), touchable[contact.secondary.body]) || any;
      for (const auto& ref : contact.primary) any = add_ring(view(problem, ref), touchable[ref.body]) || any;
    }
  return any;
}

}  // namespace reye::sim
