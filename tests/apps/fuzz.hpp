#pragma once
#include <sys/resource.h>

#include <csignal>

#include "apps/command.hpp"
#include "apps/scenes.hpp"
#include "support/fuzz.hpp"

/// Damaged scenes and geometry files, one for every seed: the command must end with a code of its contract, in time,
/// within its memory, and with a sentence.
namespace reye::test {

/// A folder with what a trial needs, and the scene's name in it.
struct Trial {
  std::string what;  ///< which file was damaged
  std::map<std::string, std::string> files;
};

inline std::string shared(const std::string& file) { return read(std::string(REYE_SOURCE_DIR) + '/' + file); }

/// One of the scenes, damaged; its geometry whole.
inline Trial damaged_scene(unsigned seed) {
  static const std::vector<Trial> sound = [] {
    std::vector<Trial> all;
    for (const std::string& scene : {std::string(blocks), wearing, worn_pin})
      all.push_back({"", {{"scene.toml", scene}, {"blocks.geo", blocks_geo}, {"wearing.geo", wearing_geo}}});
    for (const auto& folder : fs::directory_iterator(std::string(REYE_SOURCE_DIR) + "/geo")) {
      if (!folder.is_directory()) continue;
      Trial trial;
      for (const auto& file : fs::directory_iterator(folder))
        if (file.is_regular_file()) trial.files[file.path().filename().string()] = read(file.path());
      if (trial.files.contains("scene.toml")) all.push_back(std::move(trial));
    }
    std::sort(all.begin() + 3, all.end(),
              [](const Trial& a, const Trial& b) { return a.files.at("scene.toml") < b.files.at("scene.toml"); });
    return all;
  }();
  Damage damage(seed);
  Trial trial = damage.below(2) == 0 ? sound[damage.below(3)] : damage.one_of(sound);
  trial.what = "scene";
  trial.files["scene.toml"] = damage.on(trial.files["scene.toml"]);
  return trial;
}

/// Two blocks in one of the formats, damaged; the scene whole.
inline Trial damaged_geometry(unsigned seed) {
  static const std::string folder = "tests/cad/data/blocks/";
  static const std::vector<std::string> names = {"blocks.step", "blocks.brep", "blocks.msh", "blocks.vtu",
                                                 "blocks.geo"};
  Damage damage(seed);
  const std::string name = damage.one_of(names);
  const std::string scene = changed(blocks, {{"blocks.geo", name}});
  const std::string found = changed(scene, {{"[body.slider]", "[body.slider]\nat = [2.0, 0.5]"},
                                            {"[body.base]", "[body.base]\nat = [2.0, -0.5]"}}) +
                            R"(
[boundary]
slider_bottom = { body = "slider", nearest_mm = [2.0, 0.0] }
slider_top    = { body = "slider", nearest_mm = [2.0, 1.0] }
base_top      = { body = "base", nearest_mm = [2.0, 0.0] }
base_bottom   = { body = "base", nearest_mm = [2.0, -1.0] }
)";
  const bool named = name == "blocks.geo" || name == "blocks.msh" || name == "blocks.vtu";
  return {name, {{"scene.toml", named ? scene : found}, {name, damage.on(shared(folder + name))}}};
}

/// For what a trial starts: memory within 4 GB, and an interrupt that ends it, though the tests may run where
/// interrupts are ignored (in the background of a script), which a process inherits.
inline void within_memory() {
  ::signal(SIGINT, SIG_DFL);
#if !defined(__SANITIZE_ADDRESS__)
  const rlimit limit{rlim_t{4} << 30, rlim_t{4} << 30};
  ::setrlimit(RLIMIT_AS, &limit);
#endif
}

/// The command's end, awaited for so many seconds, after some of which it is asked to stop; code -1: it hung.
inline Told ended(Running running, double asked_s, double most_s) {
  const auto start = std::chrono::steady_clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  for (bool asked = false; running.is_running() && passed() < most_s;) {
    if (!asked && passed() > asked_s) asked = running.signal_when(SIGINT, [] { return true; });
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  if (!running.is_running()) return running.wait();
  running.signal_when(SIGKILL, [] { return true; });
  Told told = running.wait();
  told.code = -1;
  return told;
}

/// `check` of a trial, and where that is content and `also_run` is wished, `run`. Damage may ask for a mesh of so many
/// elements that gmsh takes minutes: such a check must end at once when it is asked to.
inline void expect_an_end(const Trial& trial, unsigned seed, bool also_run) {
#if defined(__SANITIZE_ADDRESS__)
  constexpr double slower = 4.0;
#else
  constexpr double slower = 1.0;
#endif
  constexpr double most_s = 60.0 * slower, asked_s = 20.0, meshing_s = 40.0;
  constexpr int asked_to_end = 128 + SIGINT;
  const Place place;
  for (const auto& [name, text] : trial.files) place.write(name, text);
  const auto told = ended(place.start({REYE_COMMAND, "check", "scene.toml"}, 0, "", within_memory), meshing_s, most_s);
  EXPECT_TRUE(told.code == 0 || told.code == 2 || told.code == asked_to_end)
      << trial.what << ", seed " << seed << ": check ended with " << told.code << ": " << told.err;
  if (told.code == asked_to_end) return;
  EXPECT_FALSE((told.out + told.err).empty()) << trial.what << ", seed " << seed;
  if (told.code != 0 || !also_run) return;
  const auto run = ended(place.start({REYE_COMMAND, "run", "scene.toml"}, 0, "", within_memory), asked_s, most_s);
  EXPECT_TRUE(run.code == 0 || run.code == 1 || run.code == 2 || run.code == asked_to_end)
      << trial.what << ", seed " << seed << ": run ended with " << run.code << ": " << run.err;
  EXPECT_FALSE((run.out + run.err).empty()) << trial.what << ", seed " << seed;
}

/// One trial for each of `count` seeds from `first` on; REYE_FUZZ_FIRST and REYE_FUZZ_COUNT in the environment choose
/// others. Every so manyth is run.
template <class Make>
void expect_ends(Make make, unsigned first, unsigned count, unsigned run_every) {
  const auto given = [](const char* name, unsigned otherwise) {
    const char* const text = std::getenv(name);
    return text ? static_cast<unsigned>(std::stoul(text)) : otherwise;
  };
  first = given("REYE_FUZZ_FIRST", first);
  const unsigned end = first + given("REYE_FUZZ_COUNT", count);
  for (unsigned seed = first; seed < end; ++seed) expect_an_end(make(seed), seed, seed % run_every == 0);
}

}  // namespace reye::test
