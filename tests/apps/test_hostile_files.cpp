#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <cerrno>
#include <cstddef>

#include "command.hpp"
#include "places.hpp"
#include "scenes.hpp"
#include "support/sanitizers.hpp"

using namespace reye;

namespace {

struct WithRefusals : test::WithBlocks {
  WithRefusals() : WithBlocks(test::blocks, "scene.toml") {}
  /// What the command says of the scene with these changes, once it is sure that nothing was written.
  test::Told refused(const std::vector<std::string>& words) const {
    const auto before = files();
    const auto told = reye(words);
    EXPECT_EQ(told.code, 2) << words.front();
    EXPECT_EQ(told.out, "") << words.front();
    EXPECT_EQ(files(), before) << words.front();
    return told;
  }
};

/// From here on the process gets no filter of system calls, as in some containers.
void deny_filters() {
  constexpr std::uint32_t set_filter = PR_SET_SECCOMP;
  sock_filter program[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_seccomp, 3, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_prctl, 0, 3),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, set_filter, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog filter{sizeof program / sizeof *program, program};
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter, 0, 0);
}

}  // namespace

// A script that runs a program must be refused by every command that reads a scene, and nothing run.
TEST(HostileFiles, ScriptThatRunsAProgram) {
  const WithRefusals place;
  place.write("blocks.geo", "SystemCall \"touch harm\";\n" + std::string(test::blocks_geo));
  const std::string message =
      "scene.toml:1: geometry = \"blocks.geo\": line 1: SystemCall is neither a command that Reye lets a script use "
      "nor a "
      "variable that it sets; take it out, or run with --trust-geometry if you trust the file\n";
  for (const char* command : {"check", "plan", "mesh", "run"})
    EXPECT_EQ(place.refused({command, "scene.toml"}).err, message);
}

// With --trust-geometry a script must be allowed what gmsh allows.
TEST(HostileFiles, TrustedScript) {
  const WithRefusals place;
  place.write("blocks.geo", "SystemCall \"touch harm\";\n" + std::string(test::blocks_geo));
  const auto told = place.reye({"check", "scene.toml", "--trust-geometry"});
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_TRUE(test::fs::exists(place / "harm"));
}

// A file that makes its reader crash must be refused with the file and what happened.
TEST(HostileFiles, FileThatCrashesItsReader) {
  const WithRefusals place;
  test::fs::copy_file(std::string(REYE_SOURCE_DIR) + "/tests/cad/data/broken/line_32.step", place / "line_32.step");
  place.write("scene.toml", test::changed(test::blocks, {{"blocks.geo", "line_32.step"}}));
  const auto told = place.refused({"check", "scene.toml"});
  EXPECT_TRUE(
      reye::support::address_sanitizer ||  // which turns the crash into an ordinary end
      told.err.starts_with("scene.toml:1: geometry = \"line_32.step\": the program that reads it crashes on it"))
      << told.err;
}

// Where the system has no filter for the program that reads files, a warning must say so, and the scene be read.
TEST(HostileFiles, SystemWithoutFilter) {
  const WithRefusals place;
  const auto told = place.reye({"check", "scene.toml"});
  EXPECT_EQ(told.code, 0);
  EXPECT_FALSE(test::holds(told.err, "seccomp"));
  const auto without = place.start({REYE_COMMAND, "check", "scene.toml"}, 0, "", deny_filters).wait();
  EXPECT_EQ(without.code, 0) << without.err;
  EXPECT_EQ(without.out, told.out);
  EXPECT_TRUE(test::holds(without.err, "warning: geometry: this system has no filter of system calls (seccomp)"))
      << without.err;
}

// A scene without bounds in its numbers must be refused with key and line, in no time.
TEST(HostileFiles, ScenesWithoutBounds) {
  const WithRefusals place;
  const auto told_of = [&](const std::string& text) {
    place.write("scene.toml", text);
    return place.refused({"check", "scene.toml"}).err;
  };
  std::string deep = "[a";
  for (int i = 0; i < 20000; ++i) deep += ".a";
  EXPECT_EQ(told_of(deep + "]\n"), "scene.toml:1: is not TOML: a key of more than 32 parts\n");
  std::string nested = "x = ", closing;
  for (int i = 0; i < 250; ++i) {
    nested += "{ a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a = ";
    closing += " }";
  }
  EXPECT_EQ(told_of(nested + "1" + closing + "\n"), "scene.toml:1: is not TOML: values nested more than 64 deep\n");
  const std::string blocks = test::blocks;
  std::string corners = "press = [";
  for (int i = 0; i <= 20000; ++i) corners += "[" + std::to_string(i / 20000.0) + ", 1.0], ";
  EXPECT_TRUE(test::holds(told_of(test::changed(blocks, {{"press = [[0.0, 0.0], [1.0, 1.0]]", corners + "]"}})),
                          "has 20001 pairs; 10000 are the most"));
  EXPECT_TRUE(test::holds(
      told_of(test::changed(blocks, {{"play = [\"press\"]", "play = [\"press\"]\nincrements = 1000000000"}})),
      "step[0].increments = 1000000000: must lie in [1, 1e+05]"));
  EXPECT_TRUE(test::holds(told_of(test::changed(blocks, {{"[[step]]\n", "[[step]]\nname = \"press\"\n"}}) +
                                  "\n[spectrum]\nsteps = [\"press\"]\ntimes = 1000000000\n"),
                          "spectrum.times = 1000000000: must lie in [1, 1e+05]"));
}

// A rigid body with elements far too small must be refused with how many it would take.
TEST(HostileFiles, RigidOutlineWithoutBounds) {
  const WithRefusals place;
  place.write("scene.toml",
              test::changed(test::blocks, {{"[body.base]\nmaterial = \"steel\"\nmesh     = { far_size_mm = 0.5",
                                            "[body.base]\nrigid = true\nmesh     = { far_size_mm = 1e-9"}}));
  const auto told = place.refused({"check", "scene.toml"});
  EXPECT_TRUE(test::holds(told.err, "body.base: would need about 1e+10 nodes")) << told.err;
}
