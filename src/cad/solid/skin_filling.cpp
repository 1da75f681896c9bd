#include "cad/solid/skin_filling.hpp"

#include <algorithm>
#include <stdexcept>

#include "base/errors.hpp"
#include "cad/part/importer_process.hpp"
#include "cad/solid/solid_bytes.hpp"
#include "cad/solid/solid_file.hpp"
#include "mesh/solid/solid_skin.hpp"

namespace reye::cad {

namespace {

std::vector<std::array<int, 3>> sorted_triangles(std::vector<std::array<int, 3>> triangles) {
  for (auto& triangle : triangles)
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// Throws where the skin of cells is not the given one, each facet turned as it was.
void check_filling(const SkinFilling& filling, const RawSolidMesh& mesh) {
  std::vector<std::array<int, 3>> skin;
  for (const mesh::Facet& facet : mesh::faces_of_one_cell(mesh.kind, mesh.cells))
    skin.push_back({facet.nodes[0], facet.nodes[1], facet.nodes[2]});
  if (mesh.nodes.size() < filling.X.size() || sorted_triangles(skin) != sorted_triangles(filling.triangles))
    throw base::MeshError("gmsh does not keep the triangles of the surface");
}

}  // namespace

RawSolidMesh fill_skin(const SkinFilling& filling) {
  const Task task{"filling it", "fills", meshing_s, waiting_for_mesh_s};
  ImporterProcess importer({"trusted", "-", "fill", "-"});
  if (!importer.message(waiting_s)) throw base::MeshError(importer.end_in_words(task));
  importer.ask(bytes_of(filling));
  const auto bytes = importer.message(task.waiting_s);
  if (!bytes) throw base::MeshError(importer.end_in_words(task));
  SolidMeshAnswer answer;
  try {
    answer = solid_mesh_answer_of(*bytes, 1);
  } catch (const std::runtime_error& error) {
    throw base::MeshError(std::string("what is made of it ") + error.what());
  }
  if (!answer.failure.empty()) throw base::MeshError(answer.failure);
  check_filling(filling, answer.mesh);
  std::copy(filling.X.begin(), filling.X.end(), answer.mesh.nodes.begin());
  return std::move(answer.mesh);
}

}  // namespace reye::cad
