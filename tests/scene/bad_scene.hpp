#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "example.hpp"
#include "folder.hpp"
#include "scene/read.hpp"

namespace reye::test {

/// The example with some texts replaced, and the whole message it must be refused with.
struct BadScene {
  std::string name;
  std::vector<std::pair<std::string, std::string>> changes;
  std::string message;
};

/// What reading this text says; empty when it is accepted.
inline std::string refusal(const std::string& text) {
  const Folder folder;
  Folder::write("scene.toml", text);
  Folder::write("cylinder_on_flat.step", "ISO-10303-21;");
  Folder::write("empty.geo", "");
  Folder::write("part.stl", "solid");
  Folder::write("wrong.csv", "s,h\n0,0\n1,0\n");
  Folder::write("short.csv", "arc_length_mm,height_mm\n0,0\n");
  Folder::write("back.csv", "arc_length_mm,height_mm\n0,0\n2,0\n1,0\n");
  Folder::write("infinite.csv", "arc_length_mm,height_mm\n0,0\n1,inf\n");
  Folder::write("empty.csv", "");
  std::filesystem::create_directory("folder.msh");
  try {
    scene::read("scene.toml");
  } catch (const base::InputError& error) {
    return error.what();
  }
  return {};
}

inline void expect_refused(const BadScene& bad) {
  std::string text = example;
  for (const auto& [from, to] : bad.changes) text = replaced(text, from, to);
  EXPECT_EQ(refusal(text), bad.message) << bad.name;
}

}  // namespace reye::test
