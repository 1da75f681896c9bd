#include "apps/command.hpp"
#include "apps/scenes.hpp"

using namespace reye;

// A file that keeps OpenCASCADE computing must be refused by name once it has taken twenty seconds of the processor.
TEST(EndlessReader, RefusedByItsTime) {
  const test::Place place;
  const std::string file = std::string(REYE_SOURCE_DIR) + "/tests/cad/data/broken/cut900.brep";
  place.write("scene.toml", test::changed(test::blocks, {{"blocks.geo", file}}));
  const auto told = place.reye({"check", "scene.toml"});
  EXPECT_EQ(told.code, 2);
  EXPECT_NE(told.err.find("takes more than 20 s of computing"), std::string::npos) << told.err;
}
