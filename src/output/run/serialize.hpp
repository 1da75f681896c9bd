#pragma once
#include <cereal/archives/binary.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/map.hpp>
#include <cereal/types/memory.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/set.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/utility.hpp>
#include <cereal/types/vector.hpp>
#include <cstdint>
#include <sstream>
#include <string>

#include "base/linalg.hpp"
#include "body/shape.hpp"
#include "cad/build/drawing.hpp"
#include "mesh/mesh.hpp"
#include "output/run/bounded_input.hpp"

/// cereal functions for the vocabulary of states: Eigen vectors and matrices, meshes, shapes,
/// besides the std containers. Doubles are stored bit by bit. Found by argument-dependent look-up, so those of Eigen
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
    if (rows < 0 || cols < 0 || (Rows != Dynamic && rows != Rows) || (Cols != Dynamic && cols != Cols))
      throw cereal::Exception("a matrix has a size that it cannot have");
    if (rows > 0 && cols > 0) {
      archive.need(static_cast<std::uint64_t>(rows), static_cast<std::uint64_t>(cols));
      archive.need(static_cast<std::uint64_t>(rows * cols), sizeof(double));
    }
    m.resize(rows, cols);
  }
  archive(cereal::binary_data(m.data(), static_cast<std::size_t>(m.size()) * sizeof(double)));
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
  archive(zone.bodies, zone.centre_mm, zone.half_width_mm, zone.depth_mm, zone.size_mm, zone.angle_deg, zone.contact,
          zone.key, zone.turns);
}

template <class Archive>
void serialize(Archive& archive, Drawing& drawing) {
  archive(drawing.part, drawing.boundaries, drawing.options, drawing.zones, drawing.axisymmetric);
}

}  // namespace reye::cad

namespace reye::body {

/// Saves pointers so that those to one mesh or shape within an archive share it again after loading.
template <class Archive>
void serialize(Archive& archive, Shape& shape) {
  archive(shape.mesh, shape.born, shape.drawing);
}

}  // namespace reye::body

namespace reye::output {

/// The bytes of values that cereal can save, and back. from_bytes throws cereal::Exception for bytes that are not of
/// such values: a size beyond their end, a pointer to something else, more or fewer bytes.
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
  BoundedInput archive(bytes);
  archive(values...);
  archive.end();
}

}  // namespace reye::output
