#pragma once
#include <cereal/archives/binary.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/map.hpp>
#include <cereal/types/memory.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/set.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/utility.hpp>
#include <cereal/types/variant.hpp>
#include <cereal/types/vector.hpp>
#include <cstdint>
#include <sstream>
#include <string>

#include "base/linalg.hpp"
#include "body/shape.hpp"
#include "cad/drawing.hpp"
#include "mesh/mesh.hpp"

/// cereal functions for the vocabulary of states: Eigen vectors, matrices and sparse matrices, meshes, shapes,
/// besides the std containers. Doubles go bit by bit. Found by argument-dependent look-up, so those of Eigen
/// types stand in namespace Eigen, those of meshes in reye::mesh.

namespace Eigen {

template <class Archive, int Rows, int Cols, int Options, int MaxRows, int MaxCols>
void save(Archive& archive, const Matrix<double, Rows, Cols, Options, MaxRows, MaxCols>& m) {
  if constexpr (Rows == Dynamic || Cols == Dynamic)
    archive(static_cast<std::int64_t>(m.rows()), static_cast<std::int64_t>(m.cols()));
  archive(cereal::binary_data(m.data(), static_cast<std::size_t>(m.size()) * sizeof(double)));
}

template <class Archive, int Rows, int Cols, int Options, int MaxRows, int MaxCols>
void load(Archive& archive, Matrix<double, Rows, Cols, Options, MaxRows, MaxCols>& m) {
  if constexpr (Rows == Dynamic || Cols == Dynamic) {
    std::int64_t rows = 0, cols = 0;
    archive(rows, cols);
    m.resize(rows, cols);
  }
  archive(cereal::binary_data(m.data(), static_cast<std::size_t>(m.size()) * sizeof(double)));
}

template <class Archive>
void save(Archive& archive, const SparseMatrix<double>& m) {
  SparseMatrix<double> packed = m;
  packed.makeCompressed();
  const std::vector<int> outer(packed.outerIndexPtr(), packed.outerIndexPtr() + packed.outerSize() + 1);
  const std::vector<int> inner(packed.innerIndexPtr(), packed.innerIndexPtr() + packed.nonZeros());
  const std::vector<double> values(packed.valuePtr(), packed.valuePtr() + packed.nonZeros());
  archive(static_cast<std::int64_t>(m.rows()), static_cast<std::int64_t>(m.cols()), outer, inner, values);
}

template <class Archive>
void load(Archive& archive, SparseMatrix<double>& m) {
  std::int64_t rows = 0, cols = 0;
  std::vector<int> outer, inner;
  std::vector<double> values;
  archive(rows, cols, outer, inner, values);
  m = Map<const SparseMatrix<double>>(rows, cols, static_cast<Index>(values.size()), outer.data(), inner.data(),
                                      values.data());
}

}  // namespace Eigen

namespace reye::mesh {

template <class Archive>
void serialize(Archive& archive, Mesh& mesh) {
  archive(mesh.X, mesh.kind, mesh.cells, mesh.boundaries, mesh.outline, mesh.arc_origin, mesh.points);
}

}  // namespace reye::mesh

namespace reye::cad {

template <class Archive>
void serialize(Archive& archive, Edge& edge) {
  archive(edge.type, edge.straight, edge.knots, edge.tangents, edge.arc, edge.names, edge.worn);
}

template <class Archive>
void serialize(Archive& archive, Part& part) {
  archive(part.label, part.loops, part.mesh);
}

template <class Archive>
void serialize(Archive& archive, MeshOptions& options) {
  archive(options.element, options.far_size_mm, options.growth, options.order);
}

template <class Archive>
void serialize(Archive& archive, BodyOptions& options) {
  archive(options.name, options.at, options.label, options.rigid, options.mesh, options.points_mm);
}

template <class Archive>
void serialize(Archive& archive, FineZone& zone) {
  archive(zone.bodies, zone.centre_mm, zone.half_width_mm, zone.depth_mm, zone.size_mm, zone.angle_deg, zone.contact);
}

template <class Archive>
void serialize(Archive& archive, Drawing& drawing) {
  archive(drawing.part, drawing.boundaries, drawing.options, drawing.zones, drawing.axisymmetric);
}

}  // namespace reye::cad

namespace reye::body {

/// Pointers to the same mesh or shape within one archive are one object again after loading.
template <class Archive>
void serialize(Archive& archive, Shape& shape) {
  archive(shape.mesh, shape.born, shape.drawing);
}

}  // namespace reye::body

namespace reye::output {

/// The bytes of values that cereal can save, and back. from_bytes throws cereal::Exception when they end early.
template <class... Values>
std::string to_bytes(const Values&... values) {
  std::ostringstream stream(std::ios::binary);
  {
    cereal::BinaryOutputArchive archive(stream);
    archive(values...);
  }
  return stream.str();
}

template <class... Values>
void from_bytes(const std::string& bytes, Values&... values) {
  std::istringstream stream(bytes, std::ios::binary);
  cereal::BinaryInputArchive archive(stream);
  archive(values...);
}

}  // namespace reye::output
