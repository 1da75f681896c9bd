#include "body/condensed_tangent.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "algebra/decompose.hpp"
#include "algebra/product.hpp"
#include "solids.hpp"
#include "support/bodies.hpp"
#include "support/meshes.hpp"
#include "support/tangent.hpp"

namespace {

using namespace reye;
using base::Kinematics;
using base::Matrix;
using base::Vec2;
using base::Vector;
using body::Tangent;

/// A block whose upper side is pressed in at one place, so that it yields there alone.
struct Dented {
  mesh::Mesh mesh = support::rectangle({.size = {3, 2}, .nx = 24, .ny = 16, .distortion = 0.3});
  body::BodyInput input;
  body::ShapePtr shape = body::make_shape(mesh);

  explicit Dented(Kinematics kinematics) : input(support::made_of(support::metal, kinematics)) {
    input.supports = {support::fixed_edge("foot", "bottom")};
    input.contact_boundaries = {"top"};
  }

  /// The unknowns without translation of a dent so deep.
  Vector at(const body::NonlinearEquations& of, double depth) const {
    base::Points u;
    for (const Vec2& X : mesh.X)
      u.push_back({0.0, -depth * X.y() * std::exp(-8.0 * (X - Vec2(1.5, 2.0)).squaredNorm())});
    const body::NonlinearBody body(shape, input);
    Vector q = Vector::Zero(of.columns.retained);
    body::TwoPart y(Vector::Zero(of.interior()));
    body.seat(u, q, y);
    return of.deformation(y, body::TwoPart(q));
  }
};

/// The tangent of all cells, condensed by dense matrices.
struct Dense {
  Matrix ii, ic, ci, cc;

  Dense(const body::NonlinearEquations& of, const body::Interior& before, const Vector& v, Tangent tangent) {
    const base::SparseMatrix K =
        support::tangent(of.mesh(), of.solid, of.displacement(v), {before.history, before.F0}, of.pattern);
    const base::SparseMatrix B = of.expansion(v);
    Matrix all = B.transpose() * K * B;
    if (tangent == Tangent::symmetric_part) all = 0.5 * (all + all.transpose()).eval();
    const int n = of.interior(), m = of.columns.retained;
    ii = all.topLeftCorner(n, n), ic = all.topRightCorner(n, m);
    ci = all.bottomLeftCorner(m, n), cc = all.bottomRightCorner(m, m);
  }
  Matrix schur() const { return cc - algebra::product(ci, algebra::least_squares(ii, ic)); }
  Vector condense(const Vector& r) const {
    return r.tail(cc.rows()) - algebra::product(ci, algebra::least_squares(ii, r.head(ii.rows())));
  }
  Vector recover(const Vector& r, const Vector& c) const {
    return algebra::least_squares(ii, r.head(ii.rows()) - ic * c);
  }
};

double difference(const Matrix& a, const Matrix& b) { return (a - b).norm() / b.norm(); }

class CondensedTangent : public testing::TestWithParam<std::tuple<Kinematics, Tangent>> {};

// Made of cells that change and cells whose tangent is kept, the tangent must be that of all cells, loaded, yielding
// and unloaded: exactly at small strain, at finite strain within the turn and stretch at which cells count as changed.
TEST_P(CondensedTangent, IsThatOfAllCells) {
  const auto [kinematics, asked] = GetParam();
  const Dented block(kinematics);
  const body::NonlinearEquations of(block.shape, block.input);
  const double near = kinematics == Kinematics::small ? 1e-10 : 0.01;
  body::Interior before{body::TwoPart(Vector::Zero(of.interior())), fem::virgin(of.mesh(), of.solid), {}};
  body::CondensedTangent tangent(of);
  double most = 0.0;
  for (const double depth : {0.0, 1e-4, 2e-3, 3e-3, 4e-3, 3.9e-3, 1e-3, 3e-3}) {
    const Vector v = block.at(of, depth);
    tangent.measure(of, before, v, {});
    tangent.make(of, before, asked);
    const Dense dense(of, before, v, asked);
    EXPECT_LT(difference(tangent.schur(), dense.schur()), near) << depth;
    const Vector loads = Vector::LinSpaced(v.size(), -1.0, 2.0).array().sin();
    const Vector retained = Vector::LinSpaced(of.columns.retained, 0.0, 3.0).array().cos();
    EXPECT_LT(difference(tangent.condense(loads), dense.condense(loads)), near) << depth;
    EXPECT_LT(difference(tangent.recover(loads, retained).head(of.interior()), dense.recover(loads, retained)), near)
        << depth;
    EXPECT_LE(tangent.changing, 0.5) << depth;
    most = std::max(most, tangent.changing);
    before.history = fem::updated(of.mesh(), of.solid, of.displacement(v), {before.history, before.F0});
  }
  EXPECT_GT(most, 0.02);
}

// Asked for exactly after its symmetric part was kept, the tangent must be exact in the kept cells, too: at the place
// where it is made to round-off, which the symmetric part is not.
TEST(CondensedTangent, ExactIsExactInKeptCells) {
  const Dented block(Kinematics::finite);
  const body::NonlinearEquations of(block.shape, block.input);
  const body::Interior before{body::TwoPart(Vector::Zero(of.interior())), fem::virgin(of.mesh(), of.solid), {}};
  const Vector v = block.at(of, 3e-3);
  const auto exact = Dense(of, before, v, Tangent::exact).schur();
  body::CondensedTangent tangent(of);
  tangent.measure(of, before, v, {});
  tangent.make(of, before, Tangent::symmetric_part);
  EXPECT_GT(difference(tangent.schur(), exact), 1e-5);
  tangent.make(of, before, Tangent::exact);
  EXPECT_LT(difference(tangent.schur(), exact), 1e-10);
  EXPECT_LE(tangent.changing, 0.5);
}

// Cells that have hardly moved keep their tangent, but not where an exact one is asked for.
TEST(CondensedTangent, ExactIsExactInCellsThatHaveHardlyMoved) {
  const Dented block(Kinematics::finite);
  const body::NonlinearEquations of(block.shape, block.input);
  const body::Interior before{body::TwoPart(Vector::Zero(of.interior())), fem::virgin(of.mesh(), of.solid), {}};
  const Vector start = block.at(of, 3e-4), v = block.at(of, 3.1e-4);  // elastic
  body::CondensedTangent tangent(of);
  tangent.measure(of, before, start, {});
  tangent.make(of, before, Tangent::symmetric_part);
  const Matrix kept = tangent.schur();
  tangent.measure(of, before, v, {});
  tangent.make(of, before, Tangent::symmetric_part);
  EXPECT_EQ(difference(tangent.schur(), kept), 0.0);
  tangent.make(of, before, Tangent::exact);
  EXPECT_LT(difference(tangent.schur(), Dense(of, before, v, Tangent::exact).schur()), 1e-10);
}

// What a symmetric part leaves out of a step must be the skew part times it, nearly that of all cells where some are
// kept; exact tangents leave out nothing, nor do those of small strain.
TEST(CondensedTangent, LeavesOutTheSkewPart) {
  for (const auto kinematics : {Kinematics::small, Kinematics::finite})
    for (const Tangent asked : {Tangent::symmetric_part, Tangent::exact}) {
      const Dented block(kinematics);
      const body::NonlinearEquations of(block.shape, block.input);
      const body::Interior before{body::TwoPart(Vector::Zero(of.interior())), fem::virgin(of.mesh(), of.solid), {}};
      body::CondensedTangent tangent(of);
      const Vector start = block.at(of, 3e-3), end = block.at(of, 3.1e-3);
      tangent.measure(of, before, start, {});
      tangent.make(of, before, asked);
      EXPECT_EQ(tangent.left_out(of), 0.0);
      tangent.measure(of, before, end, {});
      if (kinematics == Kinematics::small || asked == Tangent::exact) {
        EXPECT_EQ(tangent.left_out(of), 0.0);
        continue;
      }
      const Dense exact(of, before, start, Tangent::exact);
      const Vector i = (end - start).head(of.interior()), c = (end - start).tail(of.columns.retained);
      const Vector left = 0.5 * (exact.ii * i - exact.ii.transpose() * i + exact.ic * c - exact.ci.transpose() * c);
      EXPECT_GT(left.cwiseAbs().maxCoeff(), 0.0);
      EXPECT_NEAR(tangent.left_out(of), left.cwiseAbs().maxCoeff(), 0.01 * left.cwiseAbs().maxCoeff());
    }
}

INSTANTIATE_TEST_SUITE_P(strain, CondensedTangent,
                         testing::Combine(testing::Values(Kinematics::small, Kinematics::finite),
                                          testing::Values(Tangent::symmetric_part, Tangent::exact)));

}  // namespace
