#include "adapt/solid/solid_relocation.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <bit>
#include <limits>

#include "mesh/solid/solid_measure.hpp"
#include "mesh/solid/solid_shape.hpp"

namespace reye::adapt {

namespace {

using base::Triplet;
using base::Vec3;

/// The kind with the corners of another alone.
mesh::SolidKind corners_kind(mesh::SolidKind kind) {
  return kind == mesh::SolidKind::tet10 ? mesh::SolidKind::tet4 : kind;
}

/// The energy of a cell and its volume.
struct CellEnergy {
  Eigen::Matrix<double, 8, 8> k = Eigen::Matrix<double, 8, 8>::Zero();  ///< 1/V int grad N_a . grad N_b dV
  double volume = 0.0;
};

CellEnergy energy_of(const Points3& X, mesh::SolidKind kind, const mesh::SolidCell& cell,
                     const std::vector<std::pair<mesh::SolidGradients, double>>& rule) {
  const int n = mesh::solid_nodes(kind);
  Eigen::Matrix<double, 3, 8> x = Eigen::Matrix<double, 3, 8>::Zero();
  for (int a = 0; a < n; ++a) x.col(a) = X[cell[a]];
  CellEnergy energy;
  for (const auto& [reference, weight] : rule) {
    const Eigen::Matrix<double, 8, 3> dN = reference.topRows<8>();
    const base::Mat3 J = x.lazyProduct(dN);
    const double dV = weight * J.determinant();
    const Eigen::Matrix<double, 8, 3> gradients = dN.lazyProduct(base::Mat3(J.inverse()));
    energy.k += dV * gradients.lazyProduct(gradients.transpose());
    energy.volume += dV;
  }
  energy.k /= energy.volume;
  return energy;
}

/// 3 V over the largest face of a tetrahedron; of a hexahedron V over its.
double height_of(const Points3& X, mesh::SolidKind kind, const mesh::SolidCell& cell, double volume) {
  constexpr int tet[4][4]{{0, 1, 2, 0}, {0, 1, 3, 0}, {1, 2, 3, 1}, {0, 2, 3, 0}};
  constexpr int hex[6][4]{{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  const bool is_hex = kind == mesh::SolidKind::hex8;
  double largest = 0.0;
  for (int f = 0; f < (is_hex ? 6 : 4); ++f) {
    const int* k = is_hex ? hex[f] : tet[f];
    const Vec3 a = X[cell[k[2]]] - X[cell[k[0]]], b = X[cell[is_hex ? k[3] : k[1]]] - X[cell[is_hex ? k[1] : k[0]]];
    largest = std::max(largest, 0.5 * a.cross(b).norm());
  }
  return (is_hex ? 1.0 : 3.0) * volume / largest;
}

std::vector<std::pair<mesh::SolidGradients, double>> gradient_rule(mesh::SolidKind kind) {
  std::vector<std::pair<mesh::SolidGradients, double>> rule;
  for (const auto& [xi, weight] : mesh::stiffness_rule(kind))
    rule.emplace_back(mesh::shape_gradients(kind, xi), weight);
  return rule;
}

/// FNV-1a over words.
std::uint64_t checksum_of(const mesh::SolidMesh& mesh) {
  std::uint64_t hash = 14695981039346656037ull;
  const auto add = [&](std::uint64_t word) { hash = (hash ^ word) * 1099511628211ull; };
  for (const Vec3& x : mesh.X)
    for (int c = 0; c < 3; ++c) add(std::bit_cast<std::uint64_t>(x[c]));
  for (const mesh::SolidCell& cell : mesh.cells)
    for (std::size_t a = 0; a < cell.size(); a += 2)
      add(static_cast<std::uint32_t>(cell[a]) | static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell[a + 1]))
                                                    << 32);
  return hash;
}

}  // namespace

SolidInterior::SolidInterior(const mesh::SolidMesh& born) {
  const mesh::SolidKind kind = corners_kind(born.kind);
  const int corners = mesh::solid_nodes(kind);
  std::vector<char> free(born.X.size(), 0), skin = free;
  for (const mesh::Facet& facet : born.skin)
    for (int a = 0; a < facet.count(); ++a) skin[facet.nodes[a]] = 1;
  std::vector<double> height(born.X.size(), std::numeric_limits<double>::infinity());
  std::vector<Triplet> k;
  const auto rule = gradient_rule(kind);
  std::vector<Middle> middle_of(born.X.size(), Middle{-1, -1, -1});
  for (const mesh::SolidCell& cell : born.cells) {
    const CellEnergy energy = energy_of(born.X, kind, cell, rule);
    const double h = height_of(born.X, kind, cell, energy.volume);
    for (int a = 0; a < corners; ++a) {
      height[cell[a]] = std::min(height[cell[a]], h);
      if (skin[cell[a]]) continue;
      free[cell[a]] = 1;
      for (int b = 0; b < corners; ++b) k.emplace_back(cell[a], cell[b], energy.k(a, b));
    }
    for (int e = 0; born.kind == mesh::SolidKind::tet10 && e < 6; ++e) {
      const auto [a, b] = mesh::edge_of(born.kind, e);
      if (const int node = cell[4 + e]; !skin[node]) middle_of[node] = {node, cell[a], cell[b]};
    }
  }
  for (const Middle& middle : middle_of)
    if (middle.node >= 0) middles_.push_back(middle);
  for (int node = 0; node < born.node_count(); ++node)
    if (free[node]) inner_.push_back(node);
  harmonic_ = std::make_unique<HarmonicExtension>(free, height, k);
}

void SolidInterior::follow(mesh::SolidMesh& mesh, const mesh::SolidMesh& born) const {
  constexpr double at_rest = 0.01;
  Points3 motion(mesh.X.size());
  for (std::size_t j = 0; j < motion.size(); ++j) motion[j] = mesh.X[j] - born.X[j];
  if (harmonic_->unrest(motion) <= at_rest) return;
  harmonic_->extend(motion);
  for (int node : inner_) mesh.X[node] = born.X[node] + motion[node];
  for (const Middle& m : middles_) mesh.X[m.node] = born.X[m.node] + 0.5 * (motion[m.a] + motion[m.b]);
}

std::shared_ptr<const SolidInterior> SolidRelocationCache::of(const mesh::SolidMesh& born) {
  const std::uint64_t asked = checksum_of(born);
  const std::lock_guard lock(mutex_);
  if (!interior_ || born_ != asked) {
    interior_ = std::make_shared<const SolidInterior>(born);
    born_ = asked;
  }
  return interior_;
}

}  // namespace reye::adapt
