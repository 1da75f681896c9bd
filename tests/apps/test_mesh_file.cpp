#include "command.hpp"
#include "scenes.hpp"

using namespace reye;

namespace {

struct WithBothMeshes : test::Place {
  WithBothMeshes() { write("wearing.geo", test::wearing_geo); }

  /// Writes the scene, once on its CAD file and once on the mesh that `reye mesh` makes of it.
  void write_both(const std::string& scene) {
    write("cad.toml", scene);
    ASSERT_EQ(reye({"mesh", "cad.toml", "--out", "m"}).code, 0);
    write("mesh.toml", test::changed(scene, {{"wearing.geo", "m/mesh.vtu"}}));
  }
};

}  // namespace

// A scene that runs on the mesh that was written of it must give the bytes of one that makes it, in either order of
// elements.
TEST(MeshFile, RunsAsItWasMade) {
  for (const char* order : {"order = 1", "order = 2"}) {
    WithBothMeshes place;
    place.write_both(test::changed(
        test::wearing, {{"[body.disc]", std::string("[body.disc]\n") + order}, {"cycles = 400", "cycles = 200"}}));
    for (const char* name : {"cad", "mesh"}) {
      const auto told = place.reye({"run", std::string(name) + ".toml", "--out", name, "--quiet"});
      ASSERT_EQ(told.code, 0) << told.err;
    }
    for (const char* file : {"history.csv", "surface_pad_secondary.csv", "surface_pad_primary.csv"})
      EXPECT_EQ(test::read(place / "cad" / file), test::read(place / "mesh" / file)) << file << order;
  }
}

// What is no mesh must be refused with the file and the rule, and write nothing.
TEST(MeshFile, Refused) {
  WithBothMeshes place;
  place.write_both(test::wearing);
  const std::string whole = test::read(place / "m/mesh.vtu");
  const std::pair<std::string, const char*> broken[] = {
      {"no xml at all\n", "is not a .vtu: it must begin as XML does"},
      {whole.substr(0, whole.size() / 2), "holds no mesh"},
      {test::changed(whole, {{"UnstructuredGrid", "PolyData"}}), "VTK cannot read it"}};
  for (const auto& [text, rule] : broken) {
    place.write("m/mesh.vtu", text);
    const auto told = place.reye({"run", "mesh.toml", "--out", "o"});
    EXPECT_EQ(told.code, 2) << told.err;
    EXPECT_TRUE(test::holds(told.err, std::string("mesh.vtu\": ") + rule)) << told.err;
    EXPECT_FALSE(test::fs::exists(place / "o"));
  }
}
