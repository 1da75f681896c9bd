#include "cad/solid/solid_file.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include "base/errors.hpp"
#include "cad/meshing/kernel.hpp"
#include "cad/solid/solid_bytes.hpp"

namespace reye::cad {

namespace {

namespace fs = std::filesystem;

/// The file as the importer knows it, which works in the file's folder.
std::string beside_importer(const std::string& path) { return "./" + fs::path(path).filename().string(); }

/// The folder of the scene as seen from that of the file, as it lies behind any links; that one itself where there is
/// none.
std::string seen_from(const fs::path& file_folder, const std::string& folder) {
  return folder.empty() ? "."
                        : fs::weakly_canonical(folder).lexically_relative(fs::weakly_canonical(file_folder)).string();
}

}  // namespace

// The importer starts in a folder that is the same for all and goes to that of the file by itself.
SolidFile::SolidFile(std::string path, const SolidGeometryOptions& options)
    : path_(std::move(path)),
      trusted_(options.trusted),
      importer_({options.trusted ? "trusted" : "guarded", seen_from(fs::absolute(path_).parent_path(), options.folder),
                 "solid", fs::absolute(path_).string()},
                "/") {}

std::string SolidFile::as_known(std::string text) const {
  const std::string there = beside_importer(path_);
  for (auto at = text.find(there); at != text.npos; at = text.find(there, at + path_.size()))
    text.replace(at, there.size(), path_);
  return text;
}

std::vector<RawSolid> SolidFile::solids(const Points3& probes, std::vector<base::Issue>& issues) {
  const double most_s = trusted_ ? std::numeric_limits<double>::infinity() : waiting_s;
  const auto refused = [&](const std::string& rule) {
    issues.push_back({"geometry", "\"" + path_ + "\"", rule});
    return std::vector<RawSolid>{};
  };
  const auto guarded = importer_.message(most_s);
  if (!guarded) {  // it has not seen the file yet
    kernel();      // says why, where it is gmsh that cannot be loaded
    throw std::runtime_error("reye-import does not start: " + importer_.end_in_words());
  }
  guarded_ = *guarded == "guarded";
  importer_.ask(bytes_of(SolidQuery{probes}));
  const auto bytes = importer_.message(most_s);
  if (!bytes) return refused(importer_.end_in_words());
  try {
    SolidAnswer answer = solid_answer_of(*bytes, probes.size());
    for (const base::Issue& issue : answer.issues)
      issues.push_back({issue.key, as_known(issue.value), as_known(issue.rule)});
    for (RawSolid& solid : answer.solids) solid.file = path_;
    if (answer.solids.empty() && answer.issues.empty()) return refused("what is read of it is no solid");
    return std::move(answer.solids);
  } catch (const std::runtime_error& error) {
    return refused(std::string("what is read of it ") + error.what());
  }
}

RawSolidMesh SolidFile::mesh(const SolidOrder& order, std::size_t faces) {
  const Task task{"meshing it", "meshes", meshing_s, waiting_for_mesh_s};
  importer_.ask(bytes_of(order));
  const auto bytes = importer_.message(trusted_ ? std::numeric_limits<double>::infinity() : task.waiting_s);
  if (!bytes) throw base::MeshError(importer_.end_in_words(task));
  SolidMeshAnswer answer;
  try {
    answer = solid_mesh_answer_of(*bytes, faces);
  } catch (const std::runtime_error& error) {
    throw base::MeshError(std::string("what is made of it ") + error.what());
  }
  if (!answer.failure.empty()) throw base::MeshError(as_known(std::move(answer.failure)));
  return std::move(answer.mesh);
}

}  // namespace reye::cad
