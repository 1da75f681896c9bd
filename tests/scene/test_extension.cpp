#include "scene/extension.hpp"
#include "scene/fixed_part.hpp"

#include <gtest/gtest.h>

using namespace reye::scene;

namespace {

const std::string extended_scene = R"(E_MPa = 200e3
[[step]]
name = "press"
[[step]]
name = "wear"
cycles = 400
[limit.life]
depth_mm = 0.1
)";

std::string fixed(const std::string& toml) { return fixed_part(parse(toml), toml); }

std::string edited(const std::string& from, const std::string& to) {
  std::string toml = extended_scene;
  return toml.replace(toml.find(from), from.size(), to);
}

}  // namespace

// Limits, how many cycles the last step has, and comments must not count; anything else must, so must whether it has
// cycles at all.
TEST(Extension, FixedPart) {
  for (const auto& same : {edited("= 400", "= 1e6 # more"), edited("depth_mm = 0.1", "depth_mm = 0.2"),
                           edited("[limit.life]\ndepth_mm = 0.1\n", ""), "# a scene\n\n" + extended_scene})
    EXPECT_EQ(fixed(same), fixed(extended_scene)) << same;
  for (const auto& other :
       {edited("200e3", "210e3"), edited("\"press\"", "\"push\""), edited("cycles = 400", "cycles = 0"),
        edited("cycles = 400\n", ""), extended_scene + "[[step]]\nname = \"more\"\n",
        edited("name = \"press\"", "name = \"press\"\ncycles = 3")})
    EXPECT_NE(fixed(other), fixed(extended_scene)) << other;
}

// The cycles of a last step that a spectrum repeats must count, for they are not its end alone.
TEST(Extension, SpectrumFixesCycles) {
  const std::string spectrum = "[spectrum]\nsteps = [\"wear\"]\ntimes = 3\n";
  EXPECT_NE(fixed(edited("= 400", "= 500") + spectrum), fixed(extended_scene + spectrum));
}
