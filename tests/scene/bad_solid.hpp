#pragma once
#include "bad_scene.hpp"
#include "solid_example.hpp"

namespace reye::test {

/// The example of solids with some texts replaced, and the whole message it must be refused with.
inline void expect_solid_refused(const std::vector<BadScene>& scenes) {
  for (const auto& bad : scenes) {
    std::string text = solid_example;
    for (const auto& [from, to] : bad.changes) text = replaced(text, from, to);
    EXPECT_EQ(solid_refusal(text), bad.message) << bad.name;
  }
}

}  // namespace reye::test
