#include "sim/solid/refused_contacts.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "base/formatted.hpp"
#include "mesh/solid/solid_measure.hpp"

namespace reye::sim {

namespace {

using base::Issue;
using base::quoted;
using base::Vec3;
using Inputs = std::vector<body::SolidInput>;

constexpr double parallel = 1e-6;  ///< cosine, or sine, below which a direction is in a plane, or along its normal

using Face = std::pair<int, std::string>;

std::vector<mesh::Facet> facets(const Inputs& inputs, const contact::FaceRef& ref) {
  return mesh::facets_of(*inputs[static_cast<std::size_t>(ref.body)].mesh, ref.face);
}

/// Points of the linear basis at mid nodes carry nothing, and what they would lose stays.
void check_dual(const Inputs& inputs, const PlacedSkins& contact, std::vector<Issue>& issues) {
  if (!contact.options.wear.wears() || contact.options.dual != mortar::SkinDual::linear) return;
  const auto all = facets(inputs, contact.secondary);
  if (std::any_of(all.begin(), all.end(), [](const auto& facet) { return facet.count() == 6; }))
    issues.push_back({"contact." + contact.options.name + ".dual", quoted("linear"),
                      "the linear basis cannot wear facets of second order; take dual = \"quadratic\""});
}

std::set<Face> worn_faces(const PlacedSkins& contact) {
  std::set<Face> faces;
  const auto& law = contact.options.wear;
  if (!law.wears()) return faces;
  if (law.secondary > 0.0) faces.insert({contact.secondary.body, contact.secondary.face});
  if (law.primary > 0.0)
    for (const auto& ref : contact.primary) faces.insert({ref.body, ref.face});
  return faces;
}

/// What a contact has worn of a face within a block is in its own gaps alone.
void check_worn_once(const PlacedSkins& mine, const PlacedSkins& other, std::vector<Issue>& issues) {
  const auto here = worn_faces(mine), there = worn_faces(other);
  std::vector<Face> both;
  std::set_intersection(here.begin(), here.end(), there.begin(), there.end(), std::back_inserter(both));
  for (const auto& [body, face] : both)
    issues.push_back({"contact." + mine.options.name + ".wear", "",
                      "wears face " + quoted(face) + ", as contact " + quoted(other.options.name) +
                          " does; a face wears in one contact: give this one all faces that it meets"});
}

/// A mirror turns a sliding across its plane, or about an axis in it, against itself.
bool is_mirrored(const contact::ImposedSliding& sliding, const Vec3& normal) {
  if (!sliding.direction.isZero(0.0)) return std::abs(sliding.direction.normalized().dot(normal)) < parallel;
  return sliding.axis.normalized().cross(normal).norm() < parallel;
}

/// Planes of symmetry of the bodies of a contact, with their normals.
std::vector<std::pair<std::string, Vec3>> planes_of(const Inputs& inputs, const PlacedSkins& contact,
                                                    const std::vector<std::string>& symmetry) {
  std::set<int> bodies{contact.secondary.body};
  for (const auto& ref : contact.primary) bodies.insert(ref.body);
  std::vector<std::pair<std::string, Vec3>> planes;
  for (const auto& plane : symmetry)
    for (const int b : bodies) {
      const auto& mesh = *inputs[static_cast<std::size_t>(b)].mesh;
      if (!mesh.faces.contains(plane)) continue;
      Vec3 normal = Vec3::Zero();
      for (const auto& facet : mesh::facets_of(mesh, plane)) normal += mesh::area_vector(mesh.X, facet);
      planes.emplace_back(plane, normal.normalized());
    }
  return planes;
}

void check_mirrored(const Inputs& inputs, const PlacedSkins& contact, const std::vector<std::string>& symmetry,
                    std::vector<Issue>& issues) {
  if (!(contact.options.friction > 0.0)) return;
  const auto planes = planes_of(inputs, contact, symmetry);
  for (const auto& sliding : contact.options.sliding) {
    const auto across = std::find_if(planes.begin(), planes.end(),
                                     [&](const auto& plane) { return !is_mirrored(sliding, plane.second); });
    if (across == planes.end()) continue;
    const std::string key = sliding.direction.isZero(0.0) ? ".imposed_turn_rad" : ".imposed_sliding_mm";
    issues.push_back({"contact." + contact.options.name + key, "",
                      "slides across the plane of symmetry " + quoted(across->first) +
                          "; with friction the halves beside it are not alike: model both"});
  }
}

}  // namespace

std::vector<Issue> refused_contacts(const Inputs& inputs, const std::vector<PlacedSkins>& contacts,
                                    const std::vector<std::string>& symmetry) {
  std::vector<Issue> issues;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    check_dual(inputs, contacts[c], issues);
    check_mirrored(inputs, contacts[c], symmetry, issues);
    for (std::size_t other = 0; other < c; ++other) check_worn_once(contacts[c], contacts[other], issues);
  }
  return issues;
}

}  // namespace reye::sim
