#include "output/solid/solid_actions.hpp"

#include <algorithm>

#include "mesh/solid/solid_measure.hpp"
#include "output/picture/actions.hpp"
#include "output/solid/solid_words.hpp"

namespace reye::output {

namespace {

int body_named(const scene::SolidScene& scene, const std::string& name) {
  const auto& all = scene.geometry.bodies;
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& body) { return body.name == name; });
  return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

/// The mean outward normal of a face; zero where there is none.
base::Vec3 out_of(const BodyMeshes& bodies, const SolidAction& action) {
  if (action.body < 0 || action.face.empty()) return base::Vec3::Zero();
  const auto& mesh = *bodies[static_cast<std::size_t>(action.body)];
  base::Vec3 sum = base::Vec3::Zero();
  for (const int f : mesh.faces.at(action.face))
    sum += mesh::area_vector(mesh.X, mesh.skin[static_cast<std::size_t>(f)]);
  return sum.norm() > 1e-12 ? base::Vec3(sum.normalized()) : base::Vec3::Zero();
}

void add_arrow(const body::Motion& motion, const base::Vec3& axis, SolidAction& action) {
  const bool moved = motion.drive == body::Drive::moved;
  if ((!moved && motion.drive != body::Drive::loaded) || !body::nonzero(motion)) return;
  double sum = 0.0;
  for (const auto& part : motion.parts) sum += part.value;
  action.arrows.emplace_back(sum < 0.0 ? base::Vec3(-axis) : axis, moved);
}

SolidAction placed(const scene::SolidScene& scene, const BodyMeshes& bodies, const std::string& face,
                   const std::string& body) {
  SolidAction action;
  action.body = face.empty() ? body_named(scene, body) : body_with_face(bodies, face);
  if (action.body >= 0 && bodies[static_cast<std::size_t>(action.body)]->faces.count(face)) action.face = face;
  return action;
}

SolidAction support_action(const scene::SolidScene& scene, const BodyMeshes& bodies, const body::SolidSupport& s) {
  SolidAction action = placed(scene, bodies, s.face, s.body);
  action.colour = support_colour;
  action.words = "support " + s.name + " on " + place_of(s.face, s.body) + ": " + solid_support_in_words(s);
  for (int i = 0; i < 3; ++i) add_arrow(s.along[static_cast<std::size_t>(i)], s.axes.col(i), action);
  if (const auto out = out_of(bodies, action); !out.isZero()) add_arrow(s.normal, out, action);
  return action;
}

SolidAction load_action(const scene::SolidScene& scene, const BodyMeshes& bodies, const body::SolidLoad& load) {
  SolidAction action = placed(scene, bodies, load.face, load.body);
  action.colour = load_colour;
  action.words = "load " + load.name + " on " + place_of(load.face, load.body) + ": " + solid_load_in_words(load);
  for (const base::Vec3& pull :
       {base::Vec3(load.traction_MPa - load.pressure_MPa * out_of(bodies, action)), load.force_N, load.force_N_per_mm3})
    if (!pull.isZero()) action.arrows.emplace_back(pull.normalized(), false);
  return action;
}

}  // namespace

int body_with_face(const BodyMeshes& bodies, const std::string& face) {
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (bodies[b]->faces.count(face)) return static_cast<int>(b);
  return -1;
}

std::vector<SolidAction> solid_actions(const scene::SolidScene& scene, const BodyMeshes& bodies) {
  std::vector<SolidAction> all;
  for (const auto& support : scene.supports) all.push_back(support_action(scene, bodies, support));
  for (const auto& load : scene.loads) all.push_back(load_action(scene, bodies, load));
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i].letter = i < 26 ? std::string(1, static_cast<char>('A' + i)) : std::to_string(i + 1);
  return all;
}

}  // namespace reye::output
