#include "output/folder/folder.hpp"

#include <unistd.h>

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "output/folder/files.hpp"
#include "output/folder/folder_lock.hpp"

namespace reye::output {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* marker = ".reye.json";
constexpr std::array analyses{"plane_strain", "plane_stress", "axisymmetric"};
constexpr const char* solid_analysis = "solid";

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Whether a run writes an entry of this name at the top of its folder.
bool is_result(const std::string& name) {
  for (const char* own : {"series.pvd", "surfaces.pvd", "history.csv", "remesh.csv", "summary.json", "log.txt",
                          "report.html", "scene.svg", "inputs.json", "frames", "figures", "checkpoint"})
    if (name == own) return true;
  return name.rfind("surface_", 0) == 0 && (ends_with(name, "_secondary.csv") || ends_with(name, "_primary.csv"));
}

/// Whether a kill can have left an entry of this name while a result was being written.
bool is_left_over(const std::string& name) {
  const auto file = becoming(name);
  return file && (is_result(*file) || *file == marker || *file == std::string(marker) + ".new");
}

bool holds_results(const std::string& dir) {
  for (const auto& entry : fs::directory_iterator(dir))
    if (is_result(entry.path().filename().string())) return true;
  return false;
}

/// Why a folder that is not there cannot be made, judged by the nearest parent that is; empty when it can.
std::optional<std::string> refusal_to_make(const std::string& dir) {
  std::error_code error;
  auto parent = fs::absolute(fs::path(dir)).lexically_normal();
  while (parent.has_relative_path() && !fs::exists(parent, error)) parent = parent.parent_path();
  const bool may = fs::is_directory(parent, error) && ::access(parent.c_str(), W_OK | X_OK) == 0;
  if (may) return {};
  return "cannot make the output folder " + dir + " in " + parent.string();
}

/// An edge for readers, with its body where the scene says it.
std::string with_body(const scene::Scene& scene, const std::string& edge) {
  for (const auto& boundary : scene.geometry.boundaries)
    if (boundary.name == edge) return edge + " of " + boundary.body;
  return edge;
}

/// Results of another run are not removed through a link, whose name does not show whose folder it is.
std::optional<std::string> refusal_of_link(const std::string& dir) {
  auto path = fs::path(dir).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  if (!fs::is_symlink(path)) return {};
  return "the output folder " + dir + " is a symbolic link to " + fs::read_symlink(path).string() +
         ", and --force removes no other run through a link; name the folder itself";
}

std::string advice() { return "; choose another folder with --out, or replace it with --force"; }

}  // namespace

Identity identity_of(const scene::Scene& scene) {
  Identity identity{scene.name, scene.title, scene.sha256, scene.analysis, {}, {}, scene.fixed_sha256, scene.text};
  for (const auto& contact : scene.contacts) {
    auto& friction = identity.friction[contact.name];
    if (contact.friction_over_cycles.empty() && !contact.friction_formula) friction = contact.friction;
    std::string primary;
    for (const auto& edge : contact.primary) primary += (primary.empty() ? "" : ", ") + with_body(scene, edge);
    identity.sides[contact.name] = {with_body(scene, contact.secondary), primary};
  }
  return identity;
}

std::optional<Identity> read_identity(const std::string& dir) {
  const auto path = fs::path(dir) / marker;
  if (!fs::is_regular_file(path)) return {};
  const Json json = Json::parse(read_text(path.string()), nullptr, false);
  if (!json.is_object()) return {};
  try {
    Identity identity{json.at("scene"), json.at("title"), json.at("scene_sha256"), {}, {}, {}};
    identity.solid = json.at("analysis") == solid_analysis;
    for (std::size_t i = 0; i < analyses.size(); ++i)
      if (json.at("analysis") == analyses[i]) identity.analysis = static_cast<base::Analysis>(i);
    for (const auto& [name, mu] : json.at("friction").items())
      identity.friction[name] = mu.is_null() ? std::nullopt : std::optional<double>(mu);
    for (const auto& [name, sides] : json.at("sides").items()) identity.sides[name] = {sides.at(0), sides.at(1)};
    identity.fixed_sha256 = json.value("fixed_sha256", "");
    identity.scene_text = json.value("scene_text", "");
    return identity;
  } catch (const Json::exception&) {
    return {};  // an unreadable marker counts as none
  }
}

std::optional<std::string> open_folder(const std::string& dir, const std::string& name, const std::string& sha256,
                                       bool force) {
  std::error_code error;
  if (!fs::exists(dir, error)) return refusal_to_make(dir);
  if (!fs::is_directory(dir, error)) return "the output folder " + dir + " is a file";
  if (::access(dir.c_str(), R_OK | W_OK | X_OK) != 0) return "the output folder " + dir + " cannot be written to";
  if (is_locked(dir)) return refusal_of_locked(dir);
  const auto holder = read_identity(dir);
  if (holder ? holder->sha256 == sha256 : !holds_results(dir)) return {};
  if (force) return refusal_of_link(dir);
  if (!holder) return "the output folder " + dir + " holds results of an unknown run" + advice();
  if (holder->name == name)
    return "the output folder " + dir + " holds the run of another version of the scene '" + name + "'" + advice() +
           "; where only limits or the cycles of the last step are others, --restart resumes it";
  return "the output folder " + dir + " holds the run of another scene, '" + holder->name + "'" + advice();
}

namespace {

/// The content of the marker. Bytes of a name that are not UTF-8 are replaced.
std::string marker_of(const Identity& identity) {
  Json json{{"scene", identity.name},
            {"title", identity.title},
            {"scene_sha256", identity.sha256},
            {"analysis", identity.solid ? solid_analysis : analyses[static_cast<std::size_t>(identity.analysis)]},
            {"friction", Json::object()},
            {"sides", Json::object()},
            {"fixed_sha256", identity.fixed_sha256},
            {"scene_text", identity.scene_text}};
  for (const auto& [name, mu] : identity.friction) json["friction"][name] = mu ? Json(*mu) : Json();
  for (const auto& [name, sides] : identity.sides) json["sides"][name] = sides;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace

void claim_folder(const std::string& dir, const Identity& identity) {
  const auto fresh = fs::path(dir) / (std::string(marker) + ".new");
  // A full disk is detected here, while the former results are still intact.
  atomic_write(fresh.string(), marker_of(identity));
  // The summary is removed first, so that a partial removal does not look like a whole run.
  fs::remove(fs::path(dir) / "summary.json");
  std::vector<fs::path> former;
  for (const auto& entry : fs::directory_iterator(dir)) {
    const std::string name = entry.path().filename().string();
    if (is_result(name) || is_left_over(name)) former.push_back(entry.path());
  }
  for (const auto& path : former) fs::remove_all(path);  // of a symbolic link only the link
  fs::rename(fresh, fs::path(dir) / marker);
  sync_folder(dir);
}

void mark_folder(const std::string& dir, const Identity& identity) {
  atomic_write((fs::path(dir) / marker).string(), marker_of(identity));
  sync_folder(dir);
}

void remove_temporaries(const std::string& dir) {
  std::vector<fs::path> left;
  for (const auto& entry : fs::directory_iterator(dir))
    if (is_left_over(entry.path().filename().string())) left.push_back(entry.path());
  for (const char* below : {"frames", "figures", "checkpoint"}) {
    const auto folder = fs::path(dir) / below;
    if (!fs::is_directory(fs::symlink_status(folder))) continue;
    for (const auto& entry : fs::directory_iterator(folder))
      if (becoming(entry.path().filename().string())) left.push_back(entry.path());
  }
  for (const auto& path : left) fs::remove(path);
}

}  // namespace reye::output
