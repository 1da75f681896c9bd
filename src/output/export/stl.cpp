#include "output/export/stl.hpp"

#include <Eigen/Geometry>
#include <bit>
#include <cstdint>
#include <cstring>

namespace reye::output {

namespace {

using Corners = std::array<int, 3>;

void split_facet(const mesh::Facet& f, std::vector<Corners>& parts) {
  const auto& n = f.nodes;
  if (f.kind == mesh::FacetKind::tri6) {
    for (const Corners& part : {Corners{n[0], n[3], n[5]}, {n[3], n[1], n[4]}, {n[5], n[4], n[2]}, {n[3], n[4], n[5]}})
      parts.push_back(part);
    return;
  }
  parts.push_back({n[0], n[1], n[2]});
  if (f.kind == mesh::FacetKind::quad4) parts.push_back({n[0], n[2], n[3]});
}

/// A cell along all of its nodes: in second order its corners are cut off first.
void split_cell(mesh::CellKind kind, const mesh::Cell& cell, std::vector<Corners>& parts) {
  const int corners = mesh::corners(kind);
  const bool quadratic = mesh::order(kind) == 2;
  for (int k = 0; k < corners && quadratic; ++k)
    parts.push_back({cell[k], cell[corners + k], cell[corners + (k + corners - 1) % corners]});
  const int first = quadratic ? corners : 0;
  for (int k = 2; k < corners; ++k) parts.push_back({cell[first], cell[first + k - 1], cell[first + k]});
}

template <class Value>
void add_bytes(std::string& to, Value value) {
  static_assert(std::endian::native == std::endian::little, "STL is little-endian");
  std::array<char, sizeof value> bytes;
  std::memcpy(bytes.data(), &value, sizeof value);
  to.append(bytes.data(), bytes.size());
}

void add_vector(std::string& to, const base::Vec3& v) {
  for (int i = 0; i < 3; ++i) add_bytes(to, static_cast<float>(v[i]));
}

}  // namespace

std::vector<SpaceTriangle> triangles_of(const WornSolid& solid) {
  std::vector<Corners> parts;
  for (const auto& facet : solid.mesh.skin) split_facet(facet, parts);
  std::vector<SpaceTriangle> all;
  for (const auto& [a, b, c] : parts) all.push_back({solid.mesh.X[a], solid.mesh.X[b], solid.mesh.X[c]});
  return all;
}

std::vector<SpaceTriangle> extruded(const WornBody& body, double thickness_mm) {
  const auto at = [&](int node, double z) { return base::Vec3(body.mesh.X[node].x(), body.mesh.X[node].y(), z); };
  std::vector<Corners> parts;
  for (const auto& cell : body.mesh.cells) split_cell(body.mesh.kind, cell, parts);
  std::vector<SpaceTriangle> all;
  for (const auto& [a, b, c] : parts) {
    all.push_back({at(a, thickness_mm), at(b, thickness_mm), at(c, thickness_mm)});
    all.push_back({at(a, 0.0), at(c, 0.0), at(b, 0.0)});
  }
  for (const auto& loop : body.mesh.outline)
    for (std::size_t i = 1; i < loop.size(); ++i) {
      const int a = loop[i - 1], b = loop[i];
      all.push_back({at(a, 0.0), at(b, 0.0), at(b, thickness_mm)});
      all.push_back({at(a, 0.0), at(b, thickness_mm), at(a, thickness_mm)});
    }
  return all;
}

double enclosed_volume(const std::vector<SpaceTriangle>& triangles) {
  double volume = 0.0;
  for (const auto& [a, b, c] : triangles) volume += a.dot(b.cross(c)) / 6.0;
  return volume;
}

std::string stl(const std::vector<SpaceTriangle>& triangles, const std::string& note) {
  constexpr std::size_t header = 80;
  std::string file = note.substr(0, header);
  file.resize(header, ' ');
  add_bytes(file, static_cast<std::uint32_t>(triangles.size()));
  for (const auto& triangle : triangles) {
    const base::Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    add_vector(file, normal.stableNormalized());
    for (const auto& corner : triangle) add_vector(file, corner);
    add_bytes(file, std::uint16_t{0});
  }
  return file;
}

}  // namespace reye::output
