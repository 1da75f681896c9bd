#include <gtest/gtest.h>

#include "example.hpp"
#include "folder.hpp"
#include "scene/choose_elements.hpp"
#include "scene/read.hpp"

using namespace reye;

namespace {

using Words = std::vector<std::pair<std::string, std::string>>;

/// The example with some words replaced.
scene::Scene read_with(const Words& words) {
  const test::Folder folder;
  std::string text = test::example;
  for (const auto& [from, to] : words) text = test::replaced(text, from, to);
  test::Folder::write("scene.toml", text);
  test::Folder::write("cylinder_on_flat.step", "ISO-10303-21;");
  return scene::read("scene.toml");
}

const std::pair<std::string, std::string> forced{"motion_mm = 0.025", "force_N_per_mm = 8.0"};

std::vector<int> orders(const scene::Scene& s) {
  std::vector<int> orders;
  for (const auto& body : s.geometry.bodies) orders.push_back(body.mesh.order);
  return orders;
}

using Orders = std::vector<int>;
using contact::DualOrder;

}  // namespace

/// A contact that something moves by a given way while it wears keeps first order, and nothing is said.
TEST(ChooseElements, MovedStaysFirstOrder) {
  const auto s = read_with({});
  EXPECT_EQ(orders(s), (Orders{1, 1}));
  EXPECT_EQ(s.contacts[0].dual, DualOrder::quadratic);
  EXPECT_TRUE(scene::element_choices(s).empty());
}

/// A contact with friction and wear that only forces drive gets second order and linear multipliers, with the reason.
TEST(ChooseElements, ForcedGetsSecondOrder) {
  const auto s = read_with({forced});
  EXPECT_EQ(orders(s), (Orders{2, 2}));
  EXPECT_EQ(s.contacts[0].dual, DualOrder::linear);
  const auto choices = scene::element_choices(s);
  ASSERT_EQ(choices.size(), 1U);
  EXPECT_EQ(scene::in_words(s, choices[0])
                .find("contact pad: only forces drive it, so that it slips in part at most: second "
                      "order for cylinder, flat and linear multipliers"),
            0U);
}

/// What only presses before the cycles is no sliding, even by a given way.
TEST(ChooseElements, PressedByAWayBefore) {
  const auto s = read_with({forced, {"y        = { force_N_per_mm = -18.5", "y        = { motion_mm = -0.001"}});
  EXPECT_EQ(orders(s), (Orders{2, 2}));
}

/// What the scene says stays: an order leaves all bodies of the contact as they are, a basis of multipliers itself.
TEST(ChooseElements, WhatIsWrittenStays) {
  const auto first = read_with({forced, {"[body.flat]\n", "[body.flat]\norder = 1\n"}});
  EXPECT_EQ(orders(first), (Orders{1, 1}));
  EXPECT_EQ(first.contacts[0].dual, DualOrder::quadratic);
  EXPECT_TRUE(scene::element_choices(first).empty());
  const auto quadratic = read_with({forced, {"[contact.pad]\n", "[contact.pad]\ndual = \"quadratic\"\n"}});
  EXPECT_EQ(orders(quadratic), (Orders{2, 2}));
  EXPECT_EQ(quadratic.contacts[0].dual, DualOrder::quadratic);
  const auto second = read_with({forced, {"[body.flat]\n", "[body.flat]\norder = 2\n"}});
  EXPECT_EQ(orders(second), (Orders{1, 2}));
  EXPECT_EQ(second.contacts[0].dual, DualOrder::linear);
  EXPECT_EQ(scene::element_choices(second).size(), 1U);
}

/// Without wear nothing recedes: first order stays.
TEST(ChooseElements, WithoutWear) {
  const auto s = read_with({forced, {"cycles = 18000", "wear = false\ncycles = 18000"}});
  EXPECT_EQ(orders(s), (Orders{1, 1}));
}
