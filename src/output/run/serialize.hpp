#pragma once
#include <algorithm>
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
#include <limits>
#include <sstream>
#include <string>
#include <vector>

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

/// The compressed arrays of a sparse matrix: where its rows (or columns) begin, its inner indices and its values.
template <class Archive, int Options>
void save(Archive& archive, const SparseMatrix<double, Options>& m) {
  SparseMatrix<double, Options> whole = m;
  whole.makeCompressed();
  const std::vector<int> begin(whole.outerIndexPtr(), whole.outerIndexPtr() + whole.outerSize() + 1);
  const std::vector<int> inner(whole.innerIndexPtr(), whole.innerIndexPtr() + whole.nonZeros());
  const std::vector<double> values(whole.valuePtr(), whole.valuePtr() + whole.nonZeros());
  archive(static_cast<std::int64_t>(m.innerSize()), begin, inner, values);
}

template <class Archive, int Options>
void load(Archive& archive, SparseMatrix<double, Options>& m) {
  std::int64_t inner_size = 0;
  std::vector<int> begin, inner;
  std::vector<double> values;
  archive(inner_size, begin, inner, values);
  const bool sized = inner_size >= 0 && inner_size <= std::numeric_limits<int>::max() && !begin.empty() &&
                     begin.front() == 0 && std::is_sorted(begin.begin(), begin.end()) &&
                     static_cast<std::size_t>(begin.back()) == inner.size() && values.size() == inner.size();
  if (!sized) throw cereal::Exception("a sparse matrix has a size that it cannot have");
  for (std::size_t k = 0; k + 1 < begin.size(); ++k)
    for (int i = begin[k]; i < begin[k + 1]; ++i)
      if (inner[i] < 0 || inner[i] >= inner_size || (i > begin[k] && inner[i] <= inner[i - 1]))
        throw cereal::Exception("a sparse matrix has an entry where it can have none");
  const int outer_size = static_cast<int>(begin.size()) - 1, length = static_cast<int>(inner_size);
  const bool by_row = (Options & RowMajorBit) != 0;
  m.resize(by_row ? outer_size : length, by_row ? length : outer_size);  // an assignment would reserve for its length
  m.resizeNonZeros(static_cast<Index>(inner.size()));
  std::copy(begin.begin(), begin.end(), m.outerIndexPtr());
  std::copy(inner.begin(), inner.end(), m.innerIndexPtr());
  std::copy(values.begin(), values.end(), m.valuePtr());
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
