#include "command.hpp"
#include "places.hpp"
#include "scenes.hpp"

using namespace reye;

// The picture of a scene must name its bodies, sides, supports with value and history, and the gap that is drawn; the
// check that draws it writes nothing else.
TEST(Picture, OfAScene) {
  const test::Place place;
  place.write("blocks.geo", test::changed(test::blocks_geo, {{"{1, 0, 0, 2, 1}", "{1, 0.005, 0, 2, 1}"}}));
  place.write("scene.toml", test::blocks);
  const auto before = place.files();
  const auto told = place.reye({"check", "scene.toml", "--picture", "scene.svg"});
  ASSERT_EQ(told.code, 0) << told.err;
  EXPECT_EQ(place.files().size(), before.size() + 1);
  const auto picture = test::read(place / "scene.svg");
  for (const char* words :
       {"<svg xmlns", "body slider: steel, E 200000 MPa, nu 0.3", "secondary side slider_bottom",
        "primary side base_top", "gap 5 µm",
        "support holder on slider_top: x fixed, y -20 N/mm × press, rotation fixed", "press, from 0 to 1", "</svg>"})
    EXPECT_TRUE(test::holds(picture, words)) << words;
  for (const char* broken : {"nan", "inf"}) EXPECT_FALSE(test::holds(picture, broken)) << broken;
}

// A run must draw its scene before it begins, and its report must show that picture first.
TEST(Picture, FirstInTheReport) {
  const test::WithWearing place;
  ASSERT_EQ(place.reye({"run", "wearing.toml"}).code, 0);
  const auto picture = test::read(place / "wearing.out/scene.svg"),
             page = test::read(place / "wearing.out/report.html");
  EXPECT_TRUE(test::holds(page, picture));
  EXPECT_LT(page.find("<figure id=\"scene\">"), page.find("<h2>Results</h2>"));
}
