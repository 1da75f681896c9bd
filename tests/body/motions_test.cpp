#include <gtest/gtest.h>

#include "body/motions.hpp"
#include "support/bodies.hpp"
#include "support/meshes.hpp"

namespace {

using namespace reye;
using body::Drive;
using support::fixed_edge;
using support::loaded;
using support::rectangle;
using Names = std::vector<std::string>;

const Names all{"translation along x", "translation along y", "rotation"};

body::BodyInput free_body(base::Analysis analysis = base::Analysis::plane_strain) {
  return support::elastic(1.0, 0.3, analysis);
}

Names unheld(const body::BodyInput& in, bool friction = false) {
  return body::unheld_motions(rectangle({.size = {3, 2}}), in, friction);
}

// A body without supports must have all its three motions reported, one with a clamped edge none.
TEST(motions, free_and_clamped) {
  auto in = free_body();
  EXPECT_EQ(unheld(in), all);
  in.supports = {fixed_edge("wall", "left")};
  EXPECT_EQ(unheld(in), Names{});
}

// A roller must leave the sliding along it, a pin the rotation.
TEST(motions, roller_and_pin) {
  auto in = free_body();
  in.supports = {fixed_edge("roller", "bottom")};
  in.supports[0].x.drive = Drive::free;
  EXPECT_EQ(unheld(in), Names{"translation along x"});
  in.supports[0] = {};
  in.supports[0].point_mm = base::Vec2{3, 2};
  in.supports[0].x.drive = in.supports[0].y.drive = Drive::fixed;
  EXPECT_EQ(unheld(in), Names{"rotation"});
}

// An oblique free direction must be named by its components.
TEST(motions, oblique_roller) {
  auto in = free_body();
  in.supports = {fixed_edge("roller", "bottom")};
  in.supports[0].x.drive = Drive::free;
  in.supports[0].angle_deg = 45.0;
  EXPECT_EQ(unheld(in), Names{"translation along (0.707, 0.707)"});
}

// A rigid edge holds what it names: its rotation fixed and its translations free leaves the translations.
TEST(motions, rigid_edge) {
  auto in = free_body();
  body::Support s;
  s.name = s.edge = "top";
  s.rotation.drive = Drive::fixed;
  in.supports = {s};
  EXPECT_EQ(unheld(in), (Names{"translation along x", "translation along y"}));
}

// A load excuses only the motion it works on, and only where a contact can answer it.
TEST(motions, loads_excuse_with_contact) {
  auto in = free_body();
  body::Support head;
  head.name = head.edge = "top";
  head.x.drive = Drive::fixed;
  head.rotation.drive = Drive::fixed;
  head.y = loaded(-5.0);
  in.supports = {head};
  EXPECT_EQ(unheld(in), Names{"translation along y"});
  in.contact_boundaries = {"bottom"};
  EXPECT_EQ(unheld(in), Names{});
  in.supports[0].x.drive = Drive::free;
  EXPECT_EQ(unheld(in), Names{"translation along x"});
  EXPECT_EQ(unheld(in, true), Names{});
}

// Friction excuses every motion of a body in contact, and none without contact.
TEST(motions, friction_excuses) {
  auto in = free_body();
  EXPECT_EQ(unheld(in, true), all);
  in.contact_boundaries = {"bottom"};
  EXPECT_EQ(unheld(in, true), Names{});
}

// A pressure that balances itself must excuse nothing.
TEST(motions, balanced_load_excuses_nothing) {
  auto in = free_body();
  in.contact_boundaries = {"bottom"};
  in.boundary_loads = {{"pull", "top", -1.0, {0, 0}, {}, ""}};
  EXPECT_EQ(unheld(in), (Names{"translation along x", "rotation"}));
  auto m = rectangle({.size = {3, 2}});
  m.boundaries["all"] = {m.outline.front()};
  in.boundary_loads = {{"bath", "all", 3.0, {0, 0}, {}, ""}};
  EXPECT_EQ(body::unheld_motions(m, in, false), all);
}

// In axisymmetry only the motion along the axis can be free.
TEST(motions, axisymmetric) {
  auto in = free_body(base::Analysis::axisymmetric);
  EXPECT_EQ(unheld(in), Names{"translation along y"});
}

}  // namespace
