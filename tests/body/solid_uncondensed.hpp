#pragma once
#include <gtest/gtest.h>

#include <Eigen/QR>
#include <map>

#include "algebra/decompose.hpp"
#include "body/solid_inputs.hpp"
#include "fem/solid/solid_loads.hpp"
#include "fem/solid/solid_stiffness.hpp"

/// The equations of solids without condensation, and what must hold against them.
namespace reye::support::solids {

/// Nodal forces of loads times driven values.
inline Vector external(const SolidBody& b, const Vector& s) {
  const auto& m = *b.input().mesh;
  Vector f = Vector::Zero(3 * m.node_count());
  for (size_t k = 0; k < b.driven().size(); ++k) {
    if (b.driven()[k].load < 0) continue;
    const auto& load = b.input().loads[b.driven()[k].load];
    const double factor = s[static_cast<Eigen::Index>(k)];
    if (load.face.empty())
      f += factor * fem::body_load(m, load.force_N_per_mm3);
    else
      f += factor * (fem::face_load(m, mesh::facets_of(m, load.face), load.pressure_MPa, load.traction_MPa) +
                     fem::face_force(m, mesh::facets_of(m, load.face), load.force_N));
  }
  return f;
}

/// Nodal forces that do the work of forces on retained points.
inline Vector nodal(const SolidBody& b, const Vector& f) {
  Vector F = Vector::Zero(3 * b.input().mesh->node_count());
  std::map<int, std::array<int, 2>> ends;
  for (const auto& facet : control_facets(b.input()))
    for (int e = 0; facet.kind == mesh::FacetKind::tri6 && e < 3; ++e)
      ends[facet.nodes[3 + e]] = {facet.nodes[e], facet.nodes[(e + 1) % 3]};
  for (size_t k = 0; k < b.retained().size(); ++k) {
    const int node = b.retained()[k];
    const Vec3 force = f.segment<3>(3 * static_cast<Eigen::Index>(k));
    const auto found = ends.find(node);
    F.segment<3>(3 * node) += found == ends.end() ? force : Vec3(2.0 * force);
    if (found == ends.end()) continue;
    for (int end : found->second) F.segment<3>(3 * end) -= 0.5 * force;
  }
  return F;
}

/// The uncondensed equations: stationary 1/2 u K u - F u + 1/2 q k q - p q under linear constraints on u and the
/// motions q of rigid faces, six each; constraints may repeat one another.
struct Uncondensed {
  Matrix K;
  Vector F;
  std::vector<std::pair<Vector, double>> rows;

  Uncondensed(const SolidBody& b, const Vector& f, const Vector& s) {
    const auto& input = b.input();
    const auto& m = *input.mesh;
    const Eigen::Index n = 3 * m.node_count(), all = n + 6 * static_cast<Eigen::Index>(input.supports.size());
    K = Matrix::Zero(all, all);
    K.topLeftCorner(n, n) = Matrix(fem::stiffness(m, input.material));
    F = Vector::Zero(all);
    F.head(n) = external(b, s) + nodal(b, f);
    for (int k = 0; k < static_cast<int>(input.supports.size()); ++k) {
      const auto value = [&](int motion) {
        for (size_t d = 0; d < b.driven().size(); ++d)
          if (b.driven()[d].support == k && b.driven()[d].motion == motion) return s[static_cast<Eigen::Index>(d)];
        return 0.0;
      };
      input.supports[k].rigid ? add_rigid(input, k, n + 6 * k, value) : add_by_node(input, k, all, value);
      if (!input.supports[k].rigid)
        for (int j = 0; j < 6; ++j) K(n + 6 * k + j, n + 6 * k + j) = 1.0;
    }
  }

  template <class Value>
  void add_by_node(const SolidInput& input, int k, Eigen::Index all, Value value) {
    const auto& support = input.supports[k];
    const auto hold = [&](int node, const Vec3& d, double to) {
      Vector row = Vector::Zero(all);
      row.segment<3>(3 * node) = d;
      rows.emplace_back(row, to);
    };
    for (int m = 0; m < 3; ++m)
      for (int node : nodes_of_face(*input.mesh, support.face))
        if (support.along[m].drive != Drive::free) hold(node, support.axes.col(m), value(m));
    if (support.normal.drive != Drive::free)
      for (const auto& at : mesh::node_normals(input.mesh->X, mesh::facets_of(*input.mesh, support.face)))
        hold(at.node, at.normal, value(6));
  }

  template <class Value>
  void add_rigid(const SolidInput& input, int k, Eigen::Index q, Value value) {
    const auto& support = input.supports[k];
    const Vec3 c = centre_of(input, k);
    for (int node : nodes_of_face(*input.mesh, support.face))
      for (int i = 0; i < 3; ++i) {
        Vector row = Vector::Zero(K.rows());
        row[3 * node + i] = 1.0;
        for (int m = 0; m < 3; ++m) {
          row[q + m] = -support.axes(i, m);
          row[q + 3 + m] = -Vec3(support.axes.col(m)).cross(input.mesh->X[node] - c)[i];
        }
        rows.emplace_back(row, 0.0);
      }
    for (int m = 0; m < 6; ++m) {
      const Motion& motion = m < 3 ? support.along[m] : support.about[m - 3];
      Vector row = Vector::Zero(K.rows());
      row[q + m] = 1.0;
      if (motion.drive == Drive::loaded) {
        F[q + m] = value(m);
        K(q + m, q + m) = motion.stiffness;
      } else if (motion.drive != Drive::free) {
        rows.emplace_back(row, value(m));
      }
    }
  }

  Vector solve() const {
    const auto n = K.rows(), c = static_cast<Eigen::Index>(rows.size());
    Matrix A = Matrix::Zero(n + c, n + c);
    Vector rhs(n + c);
    A.topLeftCorner(n, n) = K;
    rhs.head(n) = F;
    for (Eigen::Index j = 0; j < c; ++j) {
      A.block(n + j, 0, 1, n) = 300.0 * rows[j].first.transpose();
      A.block(0, n + j, n, 1) = 300.0 * rows[j].first;
      rhs[n + j] = 300.0 * rows[j].second;
    }
    return algebra::least_squares(A, rhs).topRows(n);
  }
};

inline Points3 nodes(const Vector& x, int count) {
  Points3 u;
  for (int k = 0; k < count; ++k) u.push_back(x.segment<3>(3 * k));
  return u;
}

inline double largest(const Points3& u) {
  double value = 0.0;
  for (const Vec3& v : u) value = std::max(value, v.norm());
  return value;
}

inline double difference(const Points3& a, const Points3& b) {
  double value = 0.0;
  for (size_t k = 0; k < a.size(); ++k) value = std::max(value, (a[k] - b[k]).norm());
  return value / largest(b);
}

/// The displacements of retained points from those of nodes.
inline Vector points_of(const SolidBody& b, const Points3& u) {
  const Points3 p = mesh::control_points(control_facets(b.input()), u);
  Vector v(3 * static_cast<Eigen::Index>(b.retained().size()));
  for (size_t k = 0; k < b.retained().size(); ++k) v.segment<3>(3 * static_cast<Eigen::Index>(k)) = p[b.retained()[k]];
  return v;
}

/// Sum over the nodes of a face of K u - F, and its moment about the support's centre.
inline Eigen::Matrix<double, 6, 1> reaction(const SolidBody& b, const Points3& u, const Vector& f, const Vector& s,
                                            int k) {
  const auto& m = *b.input().mesh;
  Vector v(3 * m.node_count());
  for (int j = 0; j < m.node_count(); ++j) v.segment<3>(3 * j) = u[j];
  const Vector R = fem::stiffness(m, b.input().material) * v - external(b, s) - nodal(b, f);
  Eigen::Matrix<double, 6, 1> r = Eigen::Matrix<double, 6, 1>::Zero();
  for (int node : nodes_of_face(m, b.input().supports[k].face)) {
    r.head<3>() += R.segment<3>(3 * node);
    r.tail<3>() += (m.X[node] - centre_of(b.input(), k)).cross(Vec3(R.segment<3>(3 * node)));
  }
  return r;
}

/// A held body must move as the uncondensed equations say, at every node and at what is retained.
inline SolidBody expect_uncondensed(const SolidInput& input, const std::string& retained) {
  SolidBody b(input, nodes_of_face(*input.mesh, retained));
  const Vector f = wave(b.C().rows()), s = 0.1 * wave(static_cast<Eigen::Index>(b.driven().size()));
  EXPECT_EQ(b.A().cols(), 0);
  const Points3 exact = nodes(Uncondensed(b, f, s).solve(), input.mesh->node_count());
  const Points3 u = b.displacements(f, s, Vector());
  EXPECT_LT(difference(u, exact), 1e-10);
  const Vector p = b.C().times(f) + b.U() * s, q = points_of(b, exact);
  EXPECT_LT((p - q).norm(), 1e-10 * q.norm());
  EXPECT_EQ((b.C().dense() - b.C().dense().transpose()).norm(), 0.0);
  return b;
}

/// Resultants of supports that share no node must be those of K u - F.
inline void expect_reactions(const SolidBody& b, std::initializer_list<int> supports) {
  const Vector f = wave(b.C().rows()), s = 0.1 * wave(static_cast<Eigen::Index>(b.driven().size()));
  const Vector r = b.F() * f + b.G() * s;
  const Points3 u = b.displacements(f, s, Vector::Zero(b.A().cols()));
  for (int k : supports)
    EXPECT_LT((r.segment<6>(6 * k) - reaction(b, u, f, s, k)).norm(), 1e-10 * r.norm()) << "support " << k;
}

}  // namespace reye::support::solids
