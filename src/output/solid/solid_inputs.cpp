#include "output/solid/solid_inputs.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/errors.hpp"
#include "output/folder/files.hpp"
#include "output/folder/text.hpp"
#include "output/solid/driven_motions.hpp"
#include "output/solid/solid_words.hpp"

namespace reye::output {

namespace {

using InputJson = nlohmann::ordered_json;

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (const auto& name : names) all += (all.empty() ? "" : ", ") + name;
  return all.empty() ? "–" : all;
}

/// A face with the body that the scene names for it.
std::string face_with_body(const scene::SolidScene& scene, const std::string& face) {
  for (const auto& named : scene.geometry.faces)
    if (named.name == face && !named.body.empty()) return face + " of " + named.body;
  return face;
}

std::string faces_with_bodies(const scene::SolidScene& scene, const std::vector<std::string>& faces) {
  std::vector<std::string> all;
  for (const auto& face : faces) all.push_back(face_with_body(scene, face));
  return joined(all);
}

const char* element_in_words(const cad::SolidBodyOptions& body) {
  if (body.rigid) return "skin only";
  switch (body.mesh.element) {
    case mesh::SolidKind::tet4:
      return "tet4";
    case mesh::SolidKind::tet10:
      return "tet10";
    case mesh::SolidKind::hex8:
      break;
  }
  return "hex8";
}

InputTable body_inputs(const scene::SolidScene& scene) {
  InputTable table{"Bodies", {"Body", "material", "elements"}, {}};
  for (const auto& body : scene.geometry.bodies)
    table.rows.push_back({body.name, solid_material_in_words(scene, body), element_in_words(body)});
  return table;
}

InputTable contact_inputs(const scene::SolidScene& scene) {
  InputTable table{"Contacts", {"Contact", "secondary side", "primary side", "friction", "imposed sliding"}, {}};
  for (const auto& c : scene.contacts) {
    std::vector<std::string> sliding;
    for (const auto& one : c.sliding) sliding.push_back(sliding_in_words(one));
    table.rows.push_back({c.name, face_with_body(scene, c.secondary), faces_with_bodies(scene, c.primary),
                          rounded(c.friction), joined(sliding)});
  }
  return table;
}

InputTable support_inputs(const scene::SolidScene& scene) {
  InputTable table{"Supports", {"Support", "on", "motions"}, {}};
  for (const auto& s : scene.supports)
    table.rows.push_back({s.name, place_of(s.face, s.body), solid_support_in_words(s)});
  return table;
}

InputTable load_inputs(const scene::SolidScene& scene) {
  InputTable table{"Loads", {"Load", "on", "amount"}, {}};
  for (const auto& load : scene.loads)
    table.rows.push_back({load.name, place_of(load.face, load.body), solid_load_in_words(load)});
  return table;
}

InputTable step_inputs(const scene::SolidScene& scene) {
  InputTable table{"Steps", {"Step", "plays", "increments", "cycles"}, {}};
  for (const auto& step : scene.steps)
    table.rows.push_back({step.name, joined(step.play) + (step.level != 1.0 ? " × " + rounded(step.level) : ""),
                          std::to_string(step.increments), step.cycles > 0.0 ? rounded(step.cycles, 8) : "–"});
  return table;
}

InputJson motion_json(const DrivenMotion& motion) {
  InputJson steps = InputJson::array();
  for (const auto& played : motion.steps) steps.push_back({{"step", played.step}, {"values", played.values}});
  const auto& d = motion.direction;
  return {{"label", motion.label},
          {"unit", motion.unit},
          {"columns", motion.columns},
          {"force_unit", motion.force_unit},
          {"direction", {d.x(), d.y(), d.z()}},
          {"steps", steps}};
}

DrivenMotion motion_from(const InputJson& json) {
  const auto d = json.at("direction").get<std::array<double, 3>>();
  DrivenMotion motion{json.at("label"), json.at("unit"), json.at("columns"), json.at("force_unit"),
                      base::Vec3(d[0], d[1], d[2])};
  for (const auto& played : json.at("steps"))
    motion.steps.push_back({played.at("step"), played.at("values").get<std::vector<std::array<double, 2>>>()});
  return motion;
}

}  // namespace

Identity identity_of(const scene::SolidScene& scene) {
  Identity identity{scene.name, scene.title, scene.sha256, {}, {}, {}, scene.fixed_sha256, scene.text, true};
  for (const auto& contact : scene.contacts) {
    identity.friction[contact.name] = contact.friction;
    identity.sides[contact.name] = {face_with_body(scene, contact.secondary),
                                    faces_with_bodies(scene, contact.primary)};
  }
  return identity;
}

SolidInputs inputs_of(const scene::SolidScene& scene) {
  SolidInputs inputs;
  for (const auto& contact : scene.contacts) inputs.contacts.push_back(contact.name);
  for (const auto& support : scene.supports) inputs.supports.push_back(support.name);
  inputs.tables = {body_inputs(scene), contact_inputs(scene), support_inputs(scene), load_inputs(scene),
                   step_inputs(scene)};
  inputs.motions = driven_motions(scene);
  inputs.paraview = scene.frames.paraview;
  return inputs;
}

std::string inputs_json(const SolidInputs& inputs) {
  InputJson json{{"contacts", inputs.contacts},
                 {"supports", inputs.supports},
                 {"paraview", inputs.paraview},
                 {"tables", InputJson::array()},
                 {"motions", InputJson::array()}};
  for (const auto& table : inputs.tables)
    json["tables"].push_back({{"title", table.title}, {"head", table.head}, {"rows", table.rows}});
  for (const auto& motion : inputs.motions) json["motions"].push_back(motion_json(motion));
  return json.dump(1, ' ', false, InputJson::error_handler_t::replace) + '\n';
}

SolidInputs read_inputs(const std::string& path) {
  try {
    const InputJson json = InputJson::parse(read_text(path));
    SolidInputs inputs{json.at("contacts"), json.at("supports"), {}, {}, json.at("paraview")};
    for (const auto& t : json.at("tables"))
      inputs.tables.push_back({t.at("title"), t.at("head"), t.at("rows").get<std::vector<std::vector<std::string>>>()});
    for (const auto& motion : json.at("motions")) inputs.motions.push_back(motion_from(motion));
    return inputs;
  } catch (const std::exception& error) {
    throw base::InputError({{"dir", "", path + " is damaged: " + error.what()}});
  }
}

}  // namespace reye::output
