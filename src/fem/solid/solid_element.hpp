#pragma once
#include <Eigen/LU>
#include <array>
#include <string>

#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "material/parameters.hpp"
#include "mesh/solid/solid_shape.hpp"

/// One cell of a solid: gradients at its quadrature points, its stiffness, its stress.
namespace reye::fem {

/// Shape functions of a kind at the points of its stiffness, as sizes known to the compiler.
template <mesh::SolidKind kind>
struct SolidElement {
  static constexpr int nodes = kind == mesh::SolidKind::tet4 ? 4 : kind == mesh::SolidKind::hex8 ? 8 : 10;
  static constexpr int points = kind == mesh::SolidKind::tet4 ? 1 : kind == mesh::SolidKind::hex8 ? 8 : 4;
  /// Only hexahedra have more points than mean strains they can follow.
  static constexpr bool b_bar = kind == mesh::SolidKind::hex8;

  using Gradients = Eigen::Matrix<double, nodes, 3>;
  using Corners = Eigen::Matrix<double, 3, nodes>;
  using Stiffness = Eigen::Matrix<double, 3 * nodes, 3 * nodes>;

  std::array<Gradients, points> reference;
  std::array<double, points> weight;

  SolidElement() {
    const auto rule = mesh::stiffness_rule(kind);
    for (int g = 0; g < points; ++g) {
      reference[g] = mesh::shape_gradients(kind, rule[g].xi).template topRows<nodes>();
      weight[g] = rule[g].weight;
    }
  }
};

/// Gradients dN/dX and volumes of the points of one cell, and the mean gradient over its volume.
template <mesh::SolidKind kind>
struct CellGradients {
  using Element = SolidElement<kind>;
  std::array<typename Element::Gradients, Element::points> at;
  std::array<double, Element::points> volume;
  typename Element::Gradients mean;
  double sum = 0.0;  ///< of the volumes
};

/// Throws base::MeshError naming the cell where a Jacobian is not positive.
template <mesh::SolidKind kind>
void set_gradients(const SolidElement<kind>& element, const mesh::SolidMesh& mesh, int cell, CellGradients<kind>& out) {
  using Element = SolidElement<kind>;
  typename Element::Corners x;
  for (int a = 0; a < Element::nodes; ++a) x.col(a) = mesh.X[mesh.cells[cell][a]];
  out.mean.setZero();
  out.sum = 0.0;
  for (int g = 0; g < Element::points; ++g) {
    const base::Mat3 J = x.lazyProduct(element.reference[g]);
    const double det = J.determinant();
    if (!(det > 0.0))
      throw base::MeshError(
          "cell " + std::to_string(cell) +
          base::formatted(" at (%.6g, %.6g, %.6g) is folded over or flat", x(0, 0), x(1, 0), x(2, 0)));
    out.at[g] = element.reference[g].lazyProduct(base::Mat3(J.inverse()));
    out.volume[g] = element.weight[g] * det;
    out.mean += out.volume[g] * out.at[g];
    out.sum += out.volume[g];
  }
  out.mean /= out.sum;
}

/// Lame's constants as the cell takes them at its points, and the bulk modulus on its mean dilatation:
///   int B^T C B dV = int (lambda g g^T + mu (g_a . g_b I + g_b g_a^T)) dV + mean_bulk V mean mean^T,
/// with B-bar lambda = -2 mu / 3 and mean_bulk = kappa, else lambda = kappa - 2 mu / 3 and mean_bulk = 0.
struct CellModuli {
  double lambda, mu, mean_bulk;

  CellModuli(const material::Material& material, bool b_bar)
      : lambda(-2.0 / 3.0 * material::shear_modulus(material) + (b_bar ? 0.0 : material::bulk_modulus(material))),
        mu(material::shear_modulus(material)),
        mean_bulk(b_bar ? material::bulk_modulus(material) : 0.0) {}
};

/// The 3 x 3 blocks (a, b), a <= b, of the stiffness of a cell; the others are left as they are.
template <mesh::SolidKind kind>
void set_stiffness(const CellGradients<kind>& cell, const CellModuli& C, typename SolidElement<kind>::Stiffness& K) {
  using Element = SolidElement<kind>;
  for (int b = 0; b < Element::nodes; ++b)
    for (int a = 0; a <= b; ++a) {
      base::Mat3 sum = base::Mat3::Zero();  // of g_a g_b^T
      for (int g = 0; g < Element::points; ++g) {
        const auto& G = cell.at[g];
        for (int j = 0; j < 3; ++j) {
          const double scaled = cell.volume[g] * G(b, j);
          for (int i = 0; i < 3; ++i) sum(i, j) += G(a, i) * scaled;
        }
      }
      base::Mat3 block = C.lambda * sum + C.mu * sum.transpose();
      block.diagonal().array() += C.mu * sum.trace();
      if constexpr (Element::b_bar)
        block += (C.mean_bulk * cell.sum) * cell.mean.row(a).transpose().lazyProduct(cell.mean.row(b));
      K.template block<3, 3>(3 * a, 3 * b) = block;
    }
}

/// Stress (11, 22, 33, 12, 23, 31) at the points of a cell, one column each; u: 3 x nodes.
template <mesh::SolidKind kind>
Eigen::Matrix<double, 6, SolidElement<kind>::points> point_stress(const CellGradients<kind>& cell, const CellModuli& C,
                                                                  const typename SolidElement<kind>::Corners& u) {
  using Element = SolidElement<kind>;
  Eigen::Matrix<double, 6, Element::points> stress;
  const double mean = C.mean_bulk * base::Mat3(u.lazyProduct(cell.mean)).trace();
  for (int g = 0; g < Element::points; ++g) {
    const base::Mat3 H = u.lazyProduct(cell.at[g]);
    base::Mat3 s = C.mu * (H + H.transpose());
    s.diagonal().array() += C.lambda * H.trace() + mean;
    stress.col(g) << s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(2, 0);
  }
  return stress;
}

/// Calls f with the element of a kind.
template <class F>
auto with_element(mesh::SolidKind kind, F f) {
  using enum mesh::SolidKind;
  return kind == tet4 ? f(SolidElement<tet4>()) : kind == tet10 ? f(SolidElement<tet10>()) : f(SolidElement<hex8>());
}

}  // namespace reye::fem
