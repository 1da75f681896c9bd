#include <gtest/gtest.h>

#include "solver/solid/near_facets.hpp"
#include "support/skins.hpp"

using namespace reye;
using base::Vec3;
using base::Vector;
using contact::SkinStatus;

namespace {

/// A row of four facets, 1 mm each, above one large facet; gaps grow along it.
struct Row {
  contact::SkinSetup setup;
  contact::SkinPlace place;
  std::vector<SkinStatus> status;
  solver::WholeIntegrals whole;

  Row() {
    int column = 0;
    const auto fill = [&](contact::SkinSide& side, int nx) {
      side.skin = test::skin_grid({.kind = mesh::FacetKind::quad4, .nx = nx, .ny = 1, .hi = {4, 1}});
      for (std::size_t j = 0; j < side.skin.x.size(); ++j) side.points.push_back({0, static_cast<int>(j), column++});
    };
    fill(setup.secondary, 4);
    fill(setup.primary, 1);
    const std::size_t count = setup.secondary.points.size();
    place.carries.assign(count, 1);
    status.assign(count, SkinStatus::open);
    whole.u = Vector::Zero(3 * column);
    for (const Vec3& x : setup.secondary.skin.x) whole.gap.push_back(0.1 * x.x());
  }

  std::vector<char> near(const Vector& u) const { return near_facets(setup, place, status, whole, u); }
  Vector moved(double secondary_mm, double primary_mm) const {
    Vector u = Vector::Zero(whole.u.size());
    u[0] = secondary_mm;
    u[u.size() - 1] = primary_mm;
    return u;
  }
};

// Where nothing has moved, facets with an open gap at all of their points must keep their integrals.
TEST(solid_near_facets, open_ones_stay_while_nothing_moves) {
  const Row row;
  EXPECT_EQ(row.near(row.moved(0.0, 0.0)), (std::vector<char>{1, 0, 0, 0}));
}

// The motions of both sides must add up, and ten times that must reach the facets whose gaps are no larger.
TEST(solid_near_facets, motions_of_both_sides_reach_farther) {
  const Row row;
  EXPECT_EQ(row.near(row.moved(0.0101, 0.0)), (std::vector<char>{1, 1, 0, 0}));
  EXPECT_EQ(row.near(row.moved(0.0101, -0.01)), (std::vector<char>{1, 1, 1, 0}));
  EXPECT_EQ(row.near(row.moved(0.05, 0.05)), (std::vector<char>{1, 1, 1, 1}));
}

// A facet must follow with one point in contact, whatever its gap was, and one with a point that is not covered,
// since it may lose what covers it.
TEST(solid_near_facets, what_touches_or_is_not_known_follows) {
  Row row;
  row.status[4] = SkinStatus::slip;
  EXPECT_EQ(row.near(row.moved(0.0, 0.0)), (std::vector<char>{1, 0, 0, 1}));
  for (std::size_t j = 0; j < row.place.carries.size(); ++j)
    if (row.setup.secondary.skin.x[j].x() > 0.5 && row.setup.secondary.skin.x[j].x() < 2.5) row.place.carries[j] = 0;
  EXPECT_EQ(row.near(row.moved(0.0, 0.0)), (std::vector<char>{1, 1, 1, 1}));
}

}  // namespace
