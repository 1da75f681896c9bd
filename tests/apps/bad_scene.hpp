#pragma once
#include "command.hpp"
#include "scenes.hpp"

/// Scenes that the command must refuse.
namespace reye::test {

struct BadScene {
  std::string name;
  std::vector<std::pair<std::string, std::string>> changes;
  std::string more;     ///< put at the end of the scene
  std::string message;  ///< the whole of it; FOLDER stands for the folder of the scene
};

inline const std::string holder = R"([support.holder]
edge     = "slider_top"
x        = "fixed"
y        = { force_N_per_mm = -20.0, history = "press" }
rotation = "fixed"
)";
inline const std::string rough = R"(friction  = 0.3
wear      = { law = "energy", secondary_mm3_per_J = 3.0e-5, primary_mm3_per_J = 2.0e-5 }
)";

inline void add_geometry(const Place& place) {
  const std::string text = blocks_geo;
  place.write("blocks.geo", text);
  place.write("left.geo", changed(text, {{"{1, 0, 0, 2, 1}", "{-3, 0, 0, 2, 1}"}}));
  place.write("twice.geo",
              "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {1, 0, 0, 2, 1};\nRectangle(2) = {1, 0, 0, 2, 1};\n"
              "Rectangle(3) = {0, -1, 0, 4, 1};\nPhysical Surface(\"base\") = {3};\n");
  place.write("ball.geo", "SetFactory(\"OpenCASCADE\");\nSphere(1) = {0, 0, 0, 1};\nDelete { Volume{1}; }\n");
  place.write("empty.geo", "");
  place.write("comment.geo", "// nothing\n");
  place.write("garbage.geo", "garbage(\n");
  place.write("syntax.geo", "Point = (\n");
  place.write("garbage.step", "garbage(\n");
  place.write("part.stl", "solid");
  place.write("long.csv", "arc_length_mm,height_mm\n0,0\n1,0.1\n3,0\n");
  place.write("deep.csv", "arc_length_mm,height_mm\n0.5,0\n1,-1.5\n1.5,0\n");
  place.write("ends.csv", "arc_length_mm,height_mm\n0.5,0.1\n1,0\n");
  fs::create_directories(place / "folder.step");
  for (const char* file : {"solid.step", "mixed.msh"})
    fs::copy_file(std::string(REYE_SOURCE_DIR) + "/tests/cad/data/" + file, place / file);
}

/// Exit code 2, the message and nothing else, nothing created or changed.
inline void expect_refused(const BadScene& bad) {
  const Place place;
  add_geometry(place);
  place.write("scene.toml", changed(blocks, bad.changes) + bad.more);
  const auto before = place.files();
  const auto told = place.reye({"run", "scene.toml", "--out", "out", "--quiet"});
  auto message = bad.message + '\n';
  for (auto at = message.find("FOLDER"); at != std::string::npos; at = message.find("FOLDER"))
    message.replace(at, 6, place.work().string());
  EXPECT_EQ(told.code, 2) << bad.name;
  EXPECT_EQ(told.err, message) << bad.name;
  EXPECT_EQ(told.out, "") << bad.name;
  EXPECT_EQ(place.files(), before) << bad.name;
}

}  // namespace reye::test
