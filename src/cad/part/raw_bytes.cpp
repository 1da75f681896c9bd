#include "cad/part/raw_bytes.hpp"

#include <algorithm>

#include "cad/part/bytes.hpp"

namespace reye::cad {

template <class Archive>
void pass(Archive& archive, RawCurve& curve) {
  archive(curve.tag), archive(curve.type), archive(curve.points), archive(curve.directions), archive(curve.names);
}

template <class Archive>
void pass(Archive& archive, RawMesh& mesh) {
  archive(mesh.nodes), archive(mesh.kind), archive(mesh.cells), archive(mesh.names);
}

template <class Archive>
void pass(Archive& archive, RawPart& part) {
  archive(part.label), archive(part.group), archive(part.curves), archive(part.surface_points), archive(part.mesh);
}

template <class Archive>
void pass(Archive& archive, Answer& answer) {
  archive(answer.parts), archive(answer.issues);
}

namespace {

void check(const std::vector<Vec3>& points) {
  constexpr double most = 1e9;  // a thousand kilometres
  if (std::any_of(points.begin(), points.end(), [](const Vec3& p) { return p.cwiseAbs().maxCoeff() > most; }))
    throw std::runtime_error("holds a coordinate beyond 1e9 mm");
}

void check(const RawCurve& curve) {
  check(curve.points);
  if (curve.type != EdgeType::line && curve.type != EdgeType::circle && curve.type != EdgeType::spline)
    throw std::runtime_error("holds a curve of no known kind");
  if (curve.points.size() < 2 || curve.directions.size() != curve.points.size())
    throw std::runtime_error("holds a curve without points");
}

void check(const RawMesh& mesh) {
  check(mesh.nodes);
  if (mesh.kind < mesh::CellKind::tri3 || mesh.kind > mesh::CellKind::quad8)
    throw std::runtime_error("holds cells of no known kind");
  const auto known = [&](int node) { return node >= 0 && node < static_cast<int>(mesh.nodes.size()); };
  const int n = mesh::nodes_per_cell(mesh.kind);
  for (const mesh::Cell& cell : mesh.cells)
    if (!std::all_of(cell.begin(), cell.begin() + n, known) ||
        !std::all_of(cell.begin() + n, cell.end(), [](int node) { return node == -1; }))
      throw std::runtime_error("holds a cell that refers to a node that does not exist");
  for (const auto& [edge, names] : mesh.names)
    if (!known(edge.first) || !known(edge.second))
      throw std::runtime_error("names an edge with a node that does not exist");
}

}  // namespace

std::string to_bytes(const Answer& answer) { return written(answer); }

Answer answer_of(std::string_view bytes) {
  Answer answer = read_whole<Answer>(bytes);
  for (const RawPart& part : answer.parts) {
    for (const RawCurve& curve : part.curves) check(curve);
    check(part.surface_points);
    check(part.mesh);
  }
  return answer;
}

}  // namespace reye::cad
