#pragma once
#include <string>
#include <vector>

#include "scene/build.hpp"
#include "scene/solid/solid_scene.hpp"

/// From the file of a scene of solids to the option structs of the rooms below, one part each. Rules between the keys
/// of one table are checked here; rules between tables by `validate_solid`.
namespace reye::scene {

std::map<std::string, material::Material> solid_materials_of(const Entry& root);
std::vector<cad::SolidBodyOptions> solid_bodies_of(const Entry& root, Issues& issues);
std::vector<cad::FaceOptions> faces_of(const Entry& root, Issues& issues);
/// Zones of all contacts, for the bodies whose faces those join; a face that no [face] names may be of any body.
std::vector<cad::SolidFineZone> solid_zones_of(const Entry& root, const std::vector<cad::FaceOptions>& faces,
                                               Issues& issues);
std::vector<contact::SkinContactOptions> skin_contacts_of(const Entry& root, Issues& issues);
/// Those of [support], then one per symmetric face.
std::vector<body::SolidSupport> solid_supports_of(const Entry& root, const cad::SolidGeometryOptions& geometry,
                                                  Issues& issues);
std::vector<body::SolidLoad> solid_loads_of(const Entry& root, Issues& issues);

/// The name of the support that holds a symmetric face.
std::string symmetry_support(const std::string& face);

/// The body of a face that a [face] names.
const cad::SolidBodyOptions* body_of_face(const cad::SolidGeometryOptions& geometry, const std::string& face);

/// As `exactly_one`, but for an entry that has keys of plane scenes in their place, which are refused by themselves.
bool exactly_one_of_solids(const Entry& entry, std::initializer_list<std::string_view> names,
                           std::initializer_list<std::string_view> of_plane, Issues& issues);

/// The vector under a key, of length one; zero, with an issue where it is written as zero, when there is none.
base::Vec3 direction_of(const Entry& entry, std::string_view key, Issues& issues);

}  // namespace reye::scene
