#include "cad/part/raw_bytes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace reye::cad {

namespace {

template <class T>
concept Plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

class Writer {
 public:
  template <Plain T>
  void operator()(const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void operator()(const Vec3& p) {
    for (double x : p) (*this)(x);
  }
  template <class T, std::size_t N>
  void operator()(const std::array<T, N>& values) {
    for (const T& value : values) (*this)(value);
  }
  void operator()(const std::string& text) {
    (*this)(static_cast<std::uint64_t>(text.size()));
    bytes += text;
  }
  template <class List>
  requires requires(const List& list) {
    list.begin();
    list.size();
  }
  void operator()(const List& list) {
    (*this)(static_cast<std::uint64_t>(list.size()));
    for (const auto& value : list) (*this)(value);
  }
  template <class A, class B>
  void operator()(const std::pair<A, B>& pair) {
    (*this)(pair.first);
    (*this)(pair.second);
  }
  template <class T>
  requires requires(Writer& writer, T& value) { pass(writer, value); }
  void operator()(const T& value) {
    pass(*this, const_cast<T&>(value));  // the order of members is written once, for both ways
  }

  std::string bytes;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  template <Plain T>
  void operator()(T& value) {
    if (rest_.size() < sizeof value) throw std::runtime_error("ends early");
    std::memcpy(&value, rest_.data(), sizeof value);
    rest_.remove_prefix(sizeof value);
  }
  void operator()(bool& value) {
    char byte = 0;
    (*this)(byte);
    value = byte != 0;
  }
  void operator()(Vec3& p) {
    for (double& x : p) (*this)(x);
    if (!p.allFinite()) throw std::runtime_error("holds a coordinate that is not a finite number");
  }
  template <class T, std::size_t N>
  void operator()(std::array<T, N>& values) {
    for (T& value : values) (*this)(value);
  }
  void operator()(std::string& text) {
    const std::size_t n = count();
    text = rest_.substr(0, n);
    rest_.remove_prefix(n);
  }
  template <class T>
  void operator()(std::vector<T>& list) {
    for (std::size_t n = count(); n > 0; --n) (*this)(list.emplace_back());
  }
  template <class T>
  void operator()(std::set<T>& list) {
    for (std::size_t n = count(); n > 0; --n) {
      T value;
      (*this)(value);
      list.insert(std::move(value));
    }
  }
  template <class K, class V>
  void operator()(std::map<K, V>& list) {
    for (std::size_t n = count(); n > 0; --n) {
      std::pair<K, V> entry;
      (*this)(entry);
      list.insert(std::move(entry));
    }
  }
  template <class A, class B>
  void operator()(std::pair<A, B>& pair) {
    (*this)(pair.first);
    (*this)(pair.second);
  }
  template <class T>
  requires requires(Reader& reader, T& value) { pass(reader, value); }
  void operator()(T& value) { pass(*this, value); }

  bool at_end() const { return rest_.empty(); }

 private:
  /// Reads a count, which cannot exceed the bytes left, since each element takes at least one byte.
  std::size_t count() {
    std::uint64_t n = 0;
    (*this)(n);
    if (n > rest_.size()) throw std::runtime_error("ends early");
    return static_cast<std::size_t>(n);
  }
  std::string_view rest_;
};

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
void pass(Archive& archive, base::Issue& issue) {
  archive(issue.key), archive(issue.value), archive(issue.rule);
}

template <class Archive>
void pass(Archive& archive, Answer& answer) {
  archive(answer.parts), archive(answer.issues);
}

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

std::string to_bytes(const Answer& answer) {
  Writer writer;
  writer(answer);
  return std::move(writer.bytes);
}

Answer answer_of(std::string_view bytes) {
  Answer answer;
  Reader reader(bytes);
  reader(answer);
  if (!reader.at_end()) throw std::runtime_error("continues behind its end");
  for (const RawPart& part : answer.parts) {
    for (const RawCurve& curve : part.curves) check(curve);
    check(part.surface_points);
    check(part.mesh);
  }
  return answer;
}

}  // namespace reye::cad
