#include <gtest/gtest.h>

#include <limits>

#include "base/errors.hpp"
#include "mortar/solid/facet_geometry.hpp"
#include "mortar/solid/skin_pairs.hpp"
#include "support/skins.hpp"

namespace {

using namespace reye;
using base::Vec3;
using base::Vector;
using mesh::FacetKind;
using mortar::Skin;
using mortar::SkinDual;

constexpr std::array<FacetKind, 3> skin_kinds{FacetKind::tri3, FacetKind::quad4, FacetKind::tri6};

double largest(const base::SparseMatrix& a) {
  return a.nonZeros() == 0 ? 0.0 : Eigen::Map<const Vector>(a.valuePtr(), a.nonZeros()).cwiseAbs().maxCoeff();
}

/// A curved secondary side above a curved primary one, both distorted, partly covered.
struct CurvedPair {
  Skin secondary, primary;
};

CurvedPair curved_pair(FacetKind a, FacetKind b) {
  const auto bowl = [](const Vec3& x) {
    return Vec3(x.x(), x.y(), x.z() + 0.05 * std::sin(2 * x.x()) * std::cos(3 * x.y()));
  };
  const auto secondary = test::skin_grid({.kind = a, .nx = 5, .ny = 4, .height = 0.02, .up = false, .shaken = 0.2});
  const auto primary =
      test::skin_grid({.kind = b, .nx = 4, .ny = 6, .lo = {0.3, -0.3}, .hi = {1.2, 0.8}, .shaken = 0.2});
  return {test::curved(secondary, bowl), test::curved(primary, bowl)};
}

// Turned and moved, the integrals must be the same, and normals turn with the sides.
TEST(solid_skin, invariant_under_rotation) {
  for (FacetKind a : skin_kinds)
    for (FacetKind b : skin_kinds) {
      const auto [secondary, primary] = curved_pair(a, b);
      const auto I = mortar::integrate(secondary, primary, {.search_mm = 0.3});
      const auto J = mortar::integrate(test::turned(secondary, 30.0), test::turned(primary, 30.0), {.search_mm = 0.3});
      EXPECT_GT(I.covered.sum(), 0.4);
      EXPECT_LT(largest(I.D - J.D), 1e-12 * largest(I.D));
      EXPECT_LT(largest(I.M - J.M), 1e-12 * largest(I.D));
      EXPECT_LT(largest(I.T - J.T), 1e-12 * largest(I.D));
      const Skin normals{{}, I.normal}, zero{{}, base::Points3{Vec3::Zero()}};
      const Vec3 shift = test::turned(zero, 30.0).x[0];
      const auto expected = test::turned(normals, 30.0);
      for (std::size_t j = 0; j < secondary.x.size(); ++j)
        EXPECT_LT((J.normal[j] - (expected.x[j] - shift)).norm(), 1e-12);
    }
}

// Forces must balance: row sums of D and M agree; D is diagonal but beside points without multiplier; T is never
// negative and adds up to the covered area.
TEST(solid_skin, balance) {
  for (FacetKind a : skin_kinds)
    for (FacetKind b : skin_kinds)
      for (SkinDual dual : {SkinDual::linear, SkinDual::quadratic}) {
        const auto [secondary, primary] = curved_pair(a, b);
        const auto I = mortar::integrate(secondary, primary, {.search_mm = 0.3, .dual = dual});
        const Vector of_M = I.M * Vector::Ones(I.M.cols()), of_D = I.D * Vector::Ones(I.D.cols());
        EXPECT_LT((of_M - of_D).cwiseAbs().maxCoeff(), 1e-15);
        EXPECT_EQ((of_D - I.covered).cwiseAbs().maxCoeff(), 0.0);
        for (int k = 0; k < I.D.outerSize(); ++k)
          for (base::SparseMatrix::InnerIterator it(I.D, k); it; ++it) {
            EXPECT_TRUE(I.carries[it.row()]);
            EXPECT_TRUE(it.row() == it.col() || !I.carries[it.col()]);
          }
        for (int k = 0; k < I.T.nonZeros(); ++k) EXPECT_GE(I.T.valuePtr()[k], -1e-18);
        EXPECT_NEAR(I.T.sum(), I.covered.sum(), 1e-14);
      }
}

// Against a copy of itself M must be D, by biorthogonality through the other facets' functions, though sides are
// curved.
TEST(solid_skin, against_itself_M_is_D) {
  for (FacetKind kind : skin_kinds)
    for (SkinDual dual : {SkinDual::linear, SkinDual::quadratic}) {
      const auto side = curved_pair(kind, kind).secondary;
      Skin other = side;  // seen from the other side
      for (auto& facet : other.facets) {
        std::reverse(facet.nodes.begin(), facet.nodes.begin() + mesh::facet_corners(kind));
        if (kind == FacetKind::tri6) std::swap(facet.nodes[3], facet.nodes[4]);
      }
      const auto I = mortar::integrate(side, other, {.search_mm = 0.3, .dual = dual});
      EXPECT_LT(largest(I.M - I.D), 1e-13 * largest(I.D)) << static_cast<int>(kind);
      EXPECT_LT(test::offset_error(I, side, other), 1e-13 * largest(I.D));
      // Curved edges are seen as two chords.
      EXPECT_NEAR(I.covered.sum(), I.area.sum(), kind == FacetKind::tri6 ? 1e-4 : 1e-5);
    }
}

/// Largest error of the gap at inner corners of a ball's cap over a plane, or in a cup about its centre.
double gap_error(FacetKind kind, int n, bool cup) {
  constexpr double radius = 10.0, gap = 0.01;
  const auto flat = test::skin_grid({.kind = kind, .nx = n, .ny = n, .lo = {-2, -2}, .hi = {2, 2}, .up = false});
  const auto ball = test::curved(flat, test::onto_sphere(radius));
  const int fine = cup ? 3 * n / 2 + 1 : 3;
  auto primary = test::skin_grid({.kind = kind, .nx = fine, .ny = fine, .lo = {-3, -3}, .hi = {3, 3.1}});
  if (cup) primary = test::curved(primary, test::onto_sphere(radius + gap));
  if (!cup)
    for (auto& x : primary.x) x.z() = -radius - gap;
  const auto I = mortar::integrate(ball, primary, {.search_mm = 1.0});
  double error = 0.0;
  for (std::size_t j = 0; j < ball.x.size(); ++j) {
    const Vec3 x = ball.x[j];
    if (flat.x[j].head<2>().cwiseAbs().maxCoeff() > 1.34) continue;
    if (std::abs(x.norm() - radius) > 1e-12) continue;  // a control point
    const auto row = static_cast<Eigen::Index>(j);
    Vec3 offset;
    for (int c = 0; c < 3; ++c) {
      const Vector of_primary = I.M * test::coordinate(primary, c), own = I.D * test::coordinate(ball, c);
      offset[c] = of_primary[row] - own[row];
    }
    const double expected = cup ? gap : (-radius - gap - x.z()) / I.normal[j].z();
    error = std::max(error, std::abs(I.normal[j].dot(offset) / I.covered[row] - expected));
  }
  return error;
}

// The weighted gap of a ball over a plane must approach the gap at the node with the square of the facets' size; on
// tri6 faster. So it must in a cup where facets' sagittas exceed the clearance.
TEST(solid_skin, gap_of_a_sphere_is_of_second_order) {
  for (FacetKind kind : skin_kinds)
    for (bool cup : {false, true}) {
      const double coarse = gap_error(kind, 6, cup), fine = gap_error(kind, 12, cup), finest = gap_error(kind, 24, cup);
      EXPECT_GT(std::log2(fine / finest), 1.7) << static_cast<int>(kind) << " cup " << cup;
      EXPECT_GT(std::log2(coarse / finest), 3.4) << static_cast<int>(kind) << " cup " << cup;
    }
}

/// The top of a box (group 0) and its side towards x (group 1), which share an edge at x = 1.
Skin top_and_side(FacetKind kind, int side_group) {
  Skin top = test::skin_grid({.kind = kind, .nx = 2, .ny = 2});
  Skin side = test::mapped(test::skin_grid({.kind = kind, .nx = 2, .ny = 2}),
                           [](const Vec3& x) { return Vec3(1.0, x.y(), -x.x()); });
  for (auto& facet : side.facets) facet.group = side_group;
  std::vector<int> shared(side.x.size(), -1);
  Skin both = top;
  for (std::size_t i = 0; i < side.x.size(); ++i) {
    for (std::size_t j = 0; j < top.x.size(); ++j)
      if ((side.x[i] - top.x[j]).norm() < 1e-12) shared[i] = static_cast<int>(j);
    if (shared[i] >= 0) continue;
    shared[i] = static_cast<int>(both.x.size());
    both.x.push_back(side.x[i]);
  }
  for (auto facet : side.facets) {
    for (int j = 0; j < facet.count(); ++j) facet.nodes[j] = shared[facet.nodes[j]];
    both.facets.push_back(facet);
  }
  return both;
}

// At the edge of a box the normal must be that of the face which is covered, of both faces where both are, and of all
// where none is.
TEST(solid_skin, normals_at_edges_are_of_the_groups_that_are_covered) {
  for (FacetKind kind : skin_kinds) {
    const auto box = top_and_side(kind, 1);
    const auto above = test::skin_grid({.kind = kind, .lo = {-1, -1}, .hi = {3, 2}, .up = false});
    const auto beside = test::mapped(test::skin_grid({.kind = kind, .lo = {-1, -1}, .hi = {2, 2}, .up = false}),
                                     [](const Vec3& x) { return Vec3(1.0, x.y(), -x.x()); });
    const auto far = test::mapped(above, [](const Vec3& x) { return Vec3(x.x(), x.y(), x.z() + 9.0); });
    const auto both = test::joined_skins(above, beside);
    const Vec3 up(0, 0, 1), out(1, 0, 0), between = (up + out).normalized();
    for (const auto& [primary, expected] : {std::pair{&above, up}, {&beside, out}, {&both, between}, {&far, between}}) {
      const auto I = mortar::integrate(box, *primary, {.search_mm = 0.1});
      for (std::size_t j = 0; j < box.x.size(); ++j) {
        const bool on_edge = box.x[j].x() == 1.0 && box.x[j].z() == 0.0;
        const Vec3 normal = on_edge ? expected : box.x[j].x() == 1.0 ? out : up;
        EXPECT_LT((I.normal[j] - normal).norm(), 1e-14);
      }
    }
  }
}

// Facets of one group must share the normal at their edge, whatever is covered.
TEST(solid_skin, one_group_has_one_normal) {
  const auto box = top_and_side(FacetKind::quad4, 0);
  const auto above = test::skin_grid({.kind = FacetKind::quad4, .lo = {-1, -1}, .hi = {3, 2}, .up = false});
  const auto I = mortar::integrate(box, above, {.search_mm = 0.1});
  for (std::size_t j = 0; j < box.x.size(); ++j)
    if (box.x[j].x() == 1.0 && box.x[j].z() == 0.0) {
      EXPECT_LT((I.normal[j] - Vec3(1, 0, 1).normalized()).norm(), 1e-14);
    }
}

// Pairs kept while a side moves must give the same integrals, bit by bit, as pairs found at each call, and must be
// found again where it has moved beyond the margin.
TEST(solid_skin, kept_pairs_change_nothing) {
  for (FacetKind kind : skin_kinds) {
    auto [secondary, primary] = curved_pair(kind, FacetKind::quad4);
    mortar::SkinPairs pairs;
    pairs.margin_mm = 0.1;
    int found = 0;
    for (int step = 0; step < 12; ++step) {
      for (auto& x : primary.x) x += Vec3(0.03, 0.01, 0.004);
      if (!mortar::pairs_hold(pairs, secondary, primary, 0.3)) ++found;
      const auto kept = mortar::integrate(secondary, primary, {.search_mm = 0.3}, pairs);
      const auto fresh = mortar::integrate(secondary, primary, {.search_mm = 0.3});
      EXPECT_EQ(largest(kept.D - fresh.D), 0.0);
      EXPECT_EQ(largest(kept.M - fresh.M), 0.0);
    }
    EXPECT_GE(found, 3);
    EXPECT_LE(found, 5);
  }
}

// Facets that are not asked for must keep their integrals of before, and the others must get those of now; forces must
// balance all the same.
TEST(solid_skin, only_the_facets_asked_for_are_fresh) {
  for (FacetKind kind : skin_kinds) {
    auto [secondary, primary] = curved_pair(kind, FacetKind::quad4);
    mortar::SkinPairs pairs;
    pairs.margin_mm = 0.1;
    const auto before = mortar::integrate(secondary, primary, {.search_mm = 0.3}, pairs);
    for (auto& x : primary.x) x += Vec3(0.03, 0.01, 0.004);
    std::vector<char> fresh(secondary.facets.size(), 0);
    for (std::size_t f = 0; f < fresh.size() / 2; ++f) fresh[f] = 1;
    const auto mixed = mortar::integrate(secondary, primary, {.search_mm = 0.3}, pairs, fresh);
    const auto now = mortar::integrate(secondary, primary, {.search_mm = 0.3});
    std::vector<char> of_fresh(secondary.x.size(), 0), of_kept(secondary.x.size(), 0);
    for (std::size_t f = 0; f < fresh.size(); ++f) {
      bool bare = false;  // beside a point without multiplier the basis is another one, of where the facets are now
      for (int k = 0; k < secondary.facets[f].count(); ++k) bare = bare || !mixed.carries[secondary.facets[f].nodes[k]];
      for (int k = 0; k < secondary.facets[f].count(); ++k) {
        if (fresh[f] || bare) of_fresh[secondary.facets[f].nodes[k]] = 1;
        if (!fresh[f]) of_kept[secondary.facets[f].nodes[k]] = 1;
      }
    }
    const Vector rows = mixed.M * Vector::Ones(mixed.M.cols()) - mixed.D * Vector::Ones(mixed.D.cols());
    EXPECT_LT(rows.cwiseAbs().maxCoeff(), 1e-15);
    int kept = 0, renewed = 0;
    for (int j = 0; j < static_cast<int>(secondary.x.size()); ++j) {
      if (!now.carries[j] || !before.carries[j] || (of_fresh[j] && of_kept[j])) continue;
      const auto& expected = of_fresh[j] ? now : before;
      EXPECT_EQ((mixed.M.row(j) - expected.M.row(j)).norm(), 0.0);
      EXPECT_EQ((mixed.T.row(j) - expected.T.row(j)).norm(), 0.0);
      ++(of_fresh[j] ? renewed : kept);
    }
    EXPECT_GE(kept, 2);
    EXPECT_GE(renewed, 2);
  }
}

// A side that changed its facets must not be paired by what was found before.
TEST(solid_skin, pairs_of_another_mesh_do_not_hold) {
  const auto [secondary, primary] = curved_pair(FacetKind::quad4, FacetKind::quad4);
  mortar::SkinPairs pairs;
  EXPECT_FALSE(mortar::pairs_hold(pairs, secondary, primary, 0.3));
  mortar::find_pairs(secondary, primary, 0.3, pairs);
  EXPECT_TRUE(mortar::pairs_hold(pairs, secondary, primary, 0.3));
  EXPECT_FALSE(mortar::pairs_hold(pairs, secondary, primary, 0.31));
  Skin other = primary;
  std::swap(other.facets[0], other.facets[1]);
  EXPECT_FALSE(mortar::pairs_hold(pairs, secondary, other, 0.3));
  EXPECT_FALSE(mortar::pairs_hold(pairs, secondary, test::turned(primary, 1.0), 0.3));
}

// What has no meaning must be refused with an error.
TEST(solid_skin, refuses_what_has_no_meaning) {
  const auto [secondary, primary] = curved_pair(FacetKind::tri3, FacetKind::quad4);
  EXPECT_THROW(mortar::integrate(secondary, primary, {}), base::InputError);
  Skin lost = primary;
  lost.x[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(mortar::integrate(secondary, lost, {.search_mm = 0.3}), base::SolveError);
  Skin flat = secondary;
  flat.x[flat.facets[2].nodes[1]] = flat.x[flat.facets[2].nodes[0]];
  EXPECT_THROW(mortar::integrate(flat, primary, {.search_mm = 0.3}), base::MeshError);
  Skin dangling = primary;
  dangling.facets[0].nodes[2] = 4000;
  EXPECT_THROW(mortar::integrate(secondary, dangling, {.search_mm = 0.3}), base::MeshError);
}

// Sides without facets must give empty integrals.
TEST(solid_skin, empty_sides) {
  const auto [secondary, primary] = curved_pair(FacetKind::tri3, FacetKind::quad4);
  const auto I = mortar::integrate(secondary, {}, {.search_mm = 0.3});
  EXPECT_EQ(I.M.cols(), 0);
  EXPECT_EQ(I.covered.sum(), 0.0);
  EXPECT_EQ(mortar::integrate({}, primary, {.search_mm = 0.3}).D.rows(), 0);
}

// The area of a facet and its points' shares must be known: a unit square, and a sphere's triangle of second order.
TEST(solid_skin, areas_and_normals_of_facets) {
  for (FacetKind kind : skin_kinds) {
    const auto square = test::turned(test::skin_grid({.kind = kind, .nx = 3, .ny = 2, .shaken = 0.2}), 30.0);
    EXPECT_NEAR(mortar::facet_areas(square).sum(), 1.0, 1e-14);
    EXPECT_NEAR(mortar::nodal_areas(square).sum(), 1.0, 1e-14);
    EXPECT_GT(mortar::nodal_areas(square).minCoeff(), 0.0);
    for (const Vec3& n : mortar::facet_normals(square)) EXPECT_NEAR(n.norm(), 1.0, 1e-15);
  }
  const auto cap =
      test::curved(test::skin_grid({.kind = FacetKind::tri6, .nx = 8, .ny = 8, .lo = {-1, -1}, .hi = {1, 1}}),
                   test::onto_sphere(1.0));
  // A face of the cube round a sphere sees a sixth of it.
  EXPECT_NEAR(mortar::facet_areas(cap).sum(), 4.0 * std::numbers::pi / 6.0, 2e-4);
}

}  // namespace
