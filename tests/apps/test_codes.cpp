#include "command.hpp"
#include "places.hpp"
#include "scenes.hpp"

using namespace reye;

namespace {

/// A place with the small scenes in it.
struct WithScenes : test::WithWearing {
  WithScenes() {
    write("blocks.geo", test::blocks_geo);
    write("blocks.toml", test::blocks);
  }
};

}  // namespace

// A command line that cannot be understood must end with 2, a request for help or version with 0; nothing is written.
TEST(Codes, CommandLine) {
  const WithScenes place;
  const auto before = place.files();
  const std::vector<std::vector<std::string>> wrong = {{},
                                                       {"wear"},
                                                       {"run"},
                                                       {"run", "blocks.toml", "--fast"},
                                                       {"run", "blocks.toml", "again"},
                                                       {"run", "blocks.toml", "--out"},
                                                       {"report"}};
  for (const auto& words : wrong) {
    const auto told = place.reye(words);
    EXPECT_EQ(told.code, 2) << (words.empty() ? "" : words.back());
    EXPECT_FALSE(told.err.empty());
    EXPECT_EQ(told.out, "");
  }
  for (const char* word : {"--help", "--version"}) EXPECT_EQ(place.reye({word}).code, 0) << word;
  EXPECT_TRUE(test::holds(place.reye({"--help"}).out, "--version"));
  EXPECT_EQ(place.files(), before);
}

// A good run must end with 0, say where its results lie, and leave every file of the contract.
TEST(Codes, GoodRun) {
  const WithScenes place;
  const auto told = place.reye({"run", "wearing.toml"});
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_TRUE(test::holds(told.out, "done: 400 cycles, 5 blocks"));
  EXPECT_TRUE(test::holds(told.out, "page ./wearing.out/report.html"));
  for (const char* file :
       {"series.pvd", "surfaces.pvd", "history.csv", "surface_pad_secondary.csv", "surface_pad_primary.csv",
        "summary.json", "log.txt", "checkpoint/current.bin", "report.html", "scene.svg", "figures/overview-pad.svg"})
    EXPECT_TRUE(test::fs::exists(place / "wearing.out" / file)) << file;
  EXPECT_TRUE(test::holds(test::read(place / "wearing.out/summary.json"), R"("status": "done",)"));
}

// Away from a terminal progress must be plain lines: no return to the line's start, no escape codes.
TEST(Codes, PlainProgress) {
  const WithScenes place;
  const auto told = place.reye({"run", "wearing.toml", "--out", "o"});
  EXPECT_TRUE(test::holds(told.err, "press            cycle 0 (load)  increment 2/2"));
  EXPECT_TRUE(test::holds(told.err, "\nwear             cycle 400  increment 16/16"));
  EXPECT_EQ((told.out + told.err).find_first_of("\r\033"), std::string::npos);
  EXPECT_EQ(told.err.back(), '\n');
}

// With --quiet a good run must print nothing at all.
TEST(Codes, Quiet) {
  const WithScenes place;
  place.write("good.toml", test::changed(test::wearing, {{"jump = 100", "jump = 50"}}));
  const auto told = place.reye({"run", "good.toml", "--quiet"});
  EXPECT_EQ(told.code, 0);
  EXPECT_EQ(told.out + told.err, "");
}

// `check` and `plan` must read scene and geometry and write nothing.
TEST(Codes, CheckAndPlan) {
  const WithScenes place;
  const auto before = place.files();
  const auto check = place.reye({"check", "blocks.toml"});
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_TRUE(test::holds(check.out, "body slider: area 2 mm^2, box [1, 3] x [0, 1] mm, 15 nodes, 8 cells\n"));
  EXPECT_TRUE(test::holds(check.out, "  boundary slider_bottom: 2 mm, 5 nodes\n"));
  EXPECT_TRUE(check.out.ends_with("ok\n"));
  const auto plan = place.reye({"plan", "wearing.toml"});
  EXPECT_EQ(plan.code, 0) << plan.err;
  EXPECT_TRUE(test::holds(plan.out, "contact pad: "));
  EXPECT_TRUE(test::holds(plan.out, "step \"wear\": 400 cycles in blocks of 100, 16 increments a cycle\n"));
  EXPECT_TRUE(test::holds(plan.out, "skipped: body disc is linear"));
  EXPECT_EQ(place.files(), before);
}

// `mesh` must write the meshes and nothing else.
TEST(Codes, Mesh) {
  const WithScenes place;
  const auto told = place.reye({"mesh", "blocks.toml"});
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_EQ(told.out, "./blocks.out/mesh.vtu\n");
  const auto files = place.files("blocks.out");
  ASSERT_EQ(files.size(), 1U);
  EXPECT_TRUE(test::holds(files.begin()->second, "<VTKFile type=\"UnstructuredGrid\""));
}

// `report` must make page and figures again, byte for byte, and refuse what holds no run without touching it.
TEST(Codes, Report) {
  const WithScenes place;
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", "o", "--quiet"}).code, 0);
  const auto before = place.files("o");
  test::fs::remove_all(place / "o/figures");
  test::fs::remove(place / "o/report.html");
  const auto told = place.reye({"report", "o"});
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_EQ(told.out, "o/report.html\n");
  EXPECT_EQ(place.files("o"), before);
  test::fs::create_directories(place / "empty");
  for (const char* folder : {"empty", "nowhere"}) {
    const auto refused = place.reye({"report", folder});
    EXPECT_EQ(refused.code, 2);
    EXPECT_EQ(refused.err, std::string("dir = ") + folder + ": holds no run of reye\n");
  }
  EXPECT_TRUE(test::fs::is_empty(place / "empty"));
  EXPECT_FALSE(test::fs::exists(place / "nowhere"));
}

// A run that cannot continue must end with 1, with the reason and the last good state on disk.
TEST(Codes, FailedSolve) {
  const WithScenes place;
  place.write("hard.toml", test::wearing + "\n[solver]\nmax_newton = 1\nmax_cutbacks = 0\n");
  const auto told = place.reye({"run", "hard.toml", "--quiet"});
  EXPECT_EQ(told.code, 1);
  const auto summary = test::read(place / "hard.out/summary.json");
  EXPECT_TRUE(test::holds(summary, R"("status": "failed",)"));
  EXPECT_TRUE(test::holds(summary, "no convergence in 1 iterations"));
  EXPECT_TRUE(test::holds(
      told.err, "reye: hard.toml:39: step \"press\", cycle 0, progress 0 to 0.5: no convergence in 1 iterations"));
  EXPECT_TRUE(test::fs::exists(place / "hard.out/series.pvd"));
  EXPECT_TRUE(test::fs::exists(place / "hard.out/report.html"));
}

// A fresh mesh larger than the scene allows must end the run with 1, say how many nodes it would need, and leave the
// last good state on disk.
TEST(Codes, FailedRemesh) {
  const WithScenes place;
  place.write("pin.toml", test::changed(test::worn_pin,
                                        {{"every_blocks = 1", "every_blocks = 3\nautomatic = false\nmax_dofs = 200"}}));
  const auto told = place.reye({"run", "pin.toml", "--quiet"});
  EXPECT_EQ(told.code, 1);
  EXPECT_TRUE(test::holds(told.err, "\nreye: remeshing body disc (every 3 blocks, as asked for): ")) << told.err;
  EXPECT_TRUE(test::holds(told.err, "a new mesh would need about ")) << told.err;
  EXPECT_TRUE(test::holds(told.err, " nodes (at most 100)")) << told.err;
  const auto summary = test::read(place / "pin.out/summary.json");
  EXPECT_TRUE(test::holds(summary, R"("status": "failed",)"));
  EXPECT_TRUE(test::fs::exists(place / "pin.out/checkpoint/current.bin"));
  EXPECT_TRUE(test::fs::exists(place / "pin.out/series.pvd"));
}

// Wear that no mesh can follow must end the run with 1 and name the body and what is gone of it, in the last line; what
// was reached stays on disk.
TEST(Codes, FailedShape) {
  const WithScenes place;
  const std::string eaten =
      test::changed(test::blocks, {{"friction  = 0.3\n", "imposed_sliding_mm = 1000.0\n"},
                                   {R"(law = "energy", secondary_mm3_per_J = 3.0e-5, primary_mm3_per_J = 2.0e-5)",
                                    R"(law = "archard", secondary_per_MPa = 1e-5)"}});
  place.write("deep.toml", eaten + "\n[[step]]\nname = \"wear\"\ncycles = 50\n");  // a tenth of the block per cycle
  const auto told = place.reye({"run", "deep.toml", "--quiet"});
  EXPECT_EQ(told.code, 1);
  EXPECT_TRUE(
      told.err.ends_with("reye: deep.toml:40: body slider is worn by 0.8 mm of the 1 mm that it measured at cycle 0, "
                         "0.2 mm are left (cycle 8); end the run before with a limit with stop = true, "
                         "or check the wear coefficients\n"))
      << told.err;
  const auto summary = test::read(place / "deep.out/summary.json");
  EXPECT_TRUE(test::holds(summary, R"("status": "failed",)"));
  EXPECT_TRUE(test::holds(summary, R"("reason": "deep.toml:40: body slider is worn by 0.8 mm)"));
  EXPECT_GE(test::lines(place / "deep.out/history.csv"), 10);
  EXPECT_TRUE(test::fs::exists(place / "deep.out/report.html"));
}

// A command that was copied without what it starts and loads must name what is missing, not blame the geometry file.
TEST(Codes, PartsMissing) {
  const WithScenes place;
  test::fs::create_directories(place / "bin");
  const std::string reye = place / "bin/reye", importer = place / "bin/reye-import";
  test::fs::copy_file(REYE_COMMAND, reye);
  const auto told = [&] { return place.start({reye, "check", "blocks.toml"}).wait(); };
  EXPECT_EQ(told().code, 1);
  EXPECT_TRUE(test::holds(told().err, "reye: the importer " + importer + " cannot be started: ")) << told().err;
  test::fs::copy_file(test::fs::path(REYE_COMMAND).replace_filename("reye-import"), importer);
  EXPECT_EQ(told().code, 1);
  EXPECT_TRUE(test::holds(told().err, "reye: gmsh cannot be loaded: ")) << told().err;
  EXPECT_TRUE(test::holds(told().err, place / "lib/reye/libreye_gmsh.so: ")) << told().err;
}
