#pragma once
#include "scene/check.hpp"
#include "scene/entry.hpp"
#include "scene/scene.hpp"

/// From the file to the option structs of the rooms below, one part of the scene each, in consistent units.
/// Rules between the keys of one table are checked here; rules between tables by `validate`.
namespace reye::scene {

base::Analysis analysis_of(const Entry& root);
std::map<std::string, material::Material> materials_of(const Entry& root, Issues& issues);
std::map<std::string, BodyMaterial> body_materials_of(const Entry& root);
std::vector<cad::BodyOptions> bodies_of(const Entry& root, Issues& issues);
/// Profiles are read from their files, whose paths count from the scene at `path`.
std::vector<cad::BoundaryOptions> boundaries_of(const Entry& root, const std::string& path, Issues& issues);
std::optional<cad::Section> section_of(const Entry& root, Issues& issues);
std::vector<contact::ContactOptions> contacts_of(const Entry& root, Issues& issues);
/// The wear law of a contact: the coefficients of the named law; those of the other laws are refused.
wear::Law wear_of(const Entry& wear, Issues& issues);
/// A wear law must have what it needs: friction, or sliding that is imposed. `frictionless`: no friction is given, or
/// none above zero.
void check_friction(const Entry& contact, const wear::Law& law, bool frictionless, bool imposed, Issues& issues);
std::vector<contact::ContactOptions> bonds_of(const Entry& root, Issues& issues);
/// Reports a fine zone without a size in a scene that asks for no accuracy.
void require_size(const Entry& root, const Entry& zone, Issues& issues);
std::vector<cad::FineZone> fine_zones_of(const Entry& root, const std::vector<cad::BoundaryOptions>& boundaries,
                                         Issues& issues);
std::vector<body::Support> supports_of(const Entry& root, Issues& issues);
/// Boundary, point and body loads, distinguished by their keys.
void add_loads(const Entry& root, Scene& scene, Issues& issues);

struct Histories {
  std::map<std::string, History> corners;    ///< of all
  std::map<std::string, Measured> measured;  ///< of those from files
};

/// Histories as written, and those of files, whose paths count from the scene.
Histories histories_of(const Entry& root, const std::string& scene_path, Issues& issues);
/// Name, histories, increments and cycles of the step at an index.
Step step_of(const Entry& entry, std::size_t index);
/// All steps as they are played: those of a spectrum as often as it says, at each of its levels.
std::vector<Step> steps_of(const Entry& root, const std::string& scene_path, Issues& issues);
std::vector<Limit> limits_of(const Entry& root, Issues& issues);
Remesh remesh_of(const Entry& root);
/// Refuses remeshes that are asked for where no surface moves, since none would come.
void require_shape_to_remesh(const Entry& root, Issues& issues);
FrameRules frames_of(const Entry& frames);
Output output_of(const Entry& root);

/// The keys of a motion's parts: imposed, loaded, and its spring.
struct MotionKeys {
  std::string_view moved, loaded, spring;
};

/// A motion that is the sum of parts: all of them impose it, or all of them load it.
body::Motion motion_of(const std::vector<Entry>& parts, const MotionKeys& keys, Issues& issues);

/// A part of a load names where it acts as the whole does: the parts of a list, or the load itself, in which `values`
/// must not stand beside the list.
std::vector<Entry> parts_of(const Entry& load, std::initializer_list<std::string_view> values, Issues& issues);

/// The primary side names at least one place, none twice, and not the secondary one. `place`: "boundary", "face".
void check_sides(const Entry& entry, const std::string& place, Issues& issues);

/// True when exactly one of the keys is given; else an issue that names them.
bool exactly_one(const Entry& entry, std::initializer_list<std::string_view> names, Issues& issues);

/// The rule against a key of the other kind of problem: `a plane scene takes force_N_per_mm`.
std::string takes_instead(base::Analysis analysis, std::string_view key);

/// An issue with `rule` on each of the keys that is given.
void refuse(const Entry& entry, std::initializer_list<std::string_view> names, const std::string& rule, Issues& issues);

}  // namespace reye::scene
