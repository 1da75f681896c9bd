#include "output/solid/drawn_meshes.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string_view>

#include "mesh/solid/solid_quality.hpp"
#include "output/folder/files.hpp"
#include "output/run/checksum.hpp"
#include "output/run/container.hpp"
#include "output/run/layout.hpp"
#include "output/solid/serialize_solids.hpp"

namespace reye::output {

namespace {

constexpr std::string_view meshes_magic = "REYEMSH2";

std::string meshes_file(const std::string& dir) {
  return (std::filesystem::path(dir) / "checkpoint" / "meshes.bin").string();
}

std::uint64_t meshes_layout() {
  LayoutArchive archive;
  archive(std::vector<mesh::SolidMesh>{}, std::vector<std::string>{});
  return checksum(archive.text());
}

bool known(const mesh::SolidMesh& mesh) {
  const auto among = [](auto kind, auto first, auto last) { return kind >= first && kind <= last; };
  return among(mesh.kind, mesh::SolidKind::tet4, mesh::SolidKind::hex8) &&
         std::all_of(mesh.skin.begin(), mesh.skin.end(), [&](const mesh::Facet& facet) {
           return among(facet.kind, mesh::FacetKind::tri3, mesh::FacetKind::tri6);
         });
}

cad::SolidGeometry geometry_of(const std::string& bytes, const std::string& fixed_sha256) {
  const std::string body = unsealed(meshes_magic, bytes, "a file of meshes");
  BoundedInput archive(body);
  std::uint64_t layout = 0;
  std::string fixed;
  archive(layout, fixed);
  if (layout != meshes_layout() || fixed != fixed_sha256) throw std::runtime_error("of another scene or layout");
  cad::SolidGeometry geometry;
  archive(geometry.bodies, geometry.warnings);
  archive.end();
  for (const auto& mesh : geometry.bodies) {
    if (!known(mesh)) throw std::runtime_error("altered: a mesh has cells of no kind");
    mesh::check(mesh);
  }
  return geometry;
}

}  // namespace

std::vector<std::uint64_t> mesh_checksums(const sim::SolidProblem& problem) {
  std::vector<std::uint64_t> sums;
  for (const auto& input : problem.inputs) sums.push_back(checksum(to_bytes(*input.mesh)));
  return sums;
}

void save_meshes(const std::string& dir, const sim::SolidProblem& problem) {
  std::vector<mesh::SolidMesh> bodies;
  for (const auto& input : problem.inputs) bodies.push_back(*input.mesh);
  std::vector<std::string> warnings;
  for (const auto& warning : problem.warnings)
    if (warning.kind == sim::geometry_warning) warnings.push_back(warning.text);
  const std::string file = meshes_file(dir);
  make_folder(std::filesystem::path(file).parent_path().string());
  atomic_write(file, sealed(meshes_magic, to_bytes(meshes_layout(), problem.scene.fixed_sha256, bodies, warnings)));
}

std::optional<cad::SolidGeometry> load_meshes(const std::string& dir, const std::string& fixed_sha256) {
  try {
    return geometry_of(read_text(meshes_file(dir)), fixed_sha256);
  } catch (const std::exception&) {
    return {};  // the checksums in the checkpoints decide whether meshes that are built again are the same
  }
}

}  // namespace reye::output
