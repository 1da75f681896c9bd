#pragma once
#include <numbers>

#include "body/edges.hpp"
#include "support/solid_problem.hpp"
#include "support/swept.hpp"
#include "verification/wear_scene.hpp"

/// Scenes of the plane, or of axisymmetry, and the same drawn out in space: a slice that cannot move across itself, or
/// a wedge of a ring.
namespace reye::verification {

using base::Vec3;
using support::fixed_motion;

/// How a plane scene is drawn out: the place of a node of the plane at a share of the way from the first side to the
/// last, and how much of the plane's forces (per mm, or of the whole ring) act.
struct DrawnOut {
  std::function<Vec3(const base::Vec2&, double)> place;
  int layers = 1;
  double share = 1.0;

  static DrawnOut slice(double thickness) {
    return {[=](const base::Vec2& X, double t) { return Vec3(X.x(), X.y(), thickness * t); }, 1, thickness};
  }
  /// About the axis y, `angle` in rad.
  static DrawnOut wedge(double angle, int layers) {
    return {[=](const base::Vec2& X, double t) {
              return Vec3(X.x() * std::cos(angle * t), X.y(), X.x() * std::sin(angle * t));
            },
            layers, 0.5 * angle / std::numbers::pi};
  }
};

/// The supports of the plane on the faces that its edges become, which do not move across the plane.
inline body::SolidSupport drawn_support(const body::Support& plane, double share) {
  body::SolidSupport support;
  support.name = plane.name;
  support.face = plane.edge;
  support.rigid = body::is_rigid(plane);
  support.along = {plane.x, plane.y, body::Motion{}};
  for (auto& motion : support.along)
    if (motion.drive == body::Drive::loaded)
      for (auto& part : motion.parts) part.value *= share;
  if (!support.rigid) return support;
  support.along[2] = fixed_motion();
  support.about = {fixed_motion(), fixed_motion(), fixed_motion()};
  return support;
}

/// The plane's first contact between the solids. Elastic linear bodies of quadrilaterals alone.
inline sim::SolidProblem drawn_out(const sim::Problem& plane, const DrawnOut& how) {
  std::vector<body::SolidInput> inputs;
  for (std::size_t b = 0; b < plane.inputs.size(); ++b) {
    const auto& material = plane.inputs[b].material;
    inputs.push_back(support::solid(plane.inputs[b].name, support::swept(plane.shapes[b]->mesh, how.layers, how.place),
                                    material::young(material),
                                    std::visit([](const auto& m) { return m.nu; }, material)));
    inputs.back().supports = {support::symmetry(inputs.back().name + "_front", "z0"),
                              support::symmetry(inputs.back().name + "_back", "z1")};
  }
  for (std::size_t s = 0; s < plane.scene.supports.size(); ++s)
    inputs[static_cast<std::size_t>(plane.support_body[s])].supports.push_back(
        drawn_support(plane.scene.supports[s], how.share));
  const auto& options = plane.scene.contacts.front();
  const auto with = [&](const std::string& face) {
    for (std::size_t b = 0; b < inputs.size(); ++b)
      if (inputs[b].mesh->faces.contains(face)) return contact::FaceRef{static_cast<int>(b), face};
    throw std::runtime_error("no body has the face " + face);
  };
  auto all = support::problem_of(std::move(inputs), with(options.secondary), with(options.primary.front()),
                                 options.friction, 0.0);
  auto& own = all.contacts.front();
  own.options.wear = options.wear;
  if (!options.imposed_sliding.empty())
    own.options.sliding = {{.direction = Vec3::UnitZ(), .parts = options.imposed_sliding}};
  if (!options.imposed_turn.empty()) own.options.sliding = {{.axis = Vec3::UnitY(), .parts = options.imposed_turn}};
  const auto& zone = plane.scene.geometry.fine_zones.front();
  own.search_mm = 0.5 * zone.half_width_mm;
  cad::SolidFineZone fine;
  fine.contact = "pad";
  fine.centre_mm = {zone.centre_mm.x(), zone.centre_mm.y(), 0.0};
  fine.half_widths_mm = {zone.half_width_mm, zone.half_width_mm, 1e9};
  all.scene.geometry.fine_zones = {fine};
  all.scene.histories = plane.scene.histories;
  all.scene.steps = plane.scene.steps;
  all.scene.frames.paraview = false;
  return all;
}

/// What wear of a drawn scene differs by from the plane's.
struct WornTwins {
  double plane_depth_mm = 0.0;
  double depth = 0.0, volume = 0.0;  ///< over the plane's, less 1
  double profile = 0.0;              ///< root of the mean square over the nodes that wear, over the largest depth; 0
                                     ///< where the plane was remeshed
};

inline WornTwins worn_twins(const std::string& text, const DrawnOut& how) {
  const auto plane = played(text);
  const auto solid = support::play(drawn_out(plane.problem, how));
  EXPECT_EQ(solid.summary.status, sim::RunStatus::done) << solid.summary.reason;
  const auto& flat = plane.contact().secondary;
  const auto& full = solid.summary.contacts.front().secondary;
  WornTwins twins{flat.max_depth_mm, full.max_depth_mm / flat.max_depth_mm - 1.0,
                  full.worn_volume_mm3 / how.share / flat.worn_area - 1.0};
  if (plane.summary.counts.remeshes > 0) return twins;  // its nodes are others
  const auto& surface = plane.surface(sim::Side::secondary);
  std::map<int, double> depth;
  for (std::size_t i = 0; i < surface.node.size(); ++i) depth[surface.node[i]] = surface.wear_depth_mm[i];
  const auto& skin = solid.frames.back().surfaces.front();
  const int nodes = plane.problem.shapes[static_cast<std::size_t>(surface.body.front())]->mesh.node_count();
  double squares = 0.0;
  int count = 0;
  for (std::size_t j = 0; j < skin.node.size(); ++j) {
    const double expected = depth.at(skin.node[j] % nodes);
    if (!(expected > 0.0) && !(skin.wear_depth_mm[j] > 0.0)) continue;
    squares += std::pow(skin.wear_depth_mm[j] - expected, 2);
    ++count;
  }
  twins.profile = std::sqrt(squares / std::max(count, 1)) / flat.max_depth_mm;
  return twins;
}

}  // namespace reye::verification
