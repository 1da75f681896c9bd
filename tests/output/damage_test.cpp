#include <gtest/gtest.h>

#include <random>

#include "base/errors.hpp"
#include "output/folder/files.hpp"
#include "output/report/report.hpp"
#include "output/run/sweep_table.hpp"
#include "sample_run.hpp"
#include "support/sanitizers.hpp"
#include "support/texts.hpp"

using namespace reye::output;
using reye::support::holds;

namespace {

const std::vector<std::string> read_again = {
    ".reye.json", "summary.json", "history.csv", "surface_pad_secondary.csv", "surface_pad_primary.csv", "remesh.csv"};

/// A run that is done, with all its tables.
void write_done(const std::string& dir) {
  RunWriter writer(dir, sample::scene());
  writer.begin();
  for (int block = 0; block < 4; ++block) {
    for (int k = 1; k <= 5; ++k) writer.increment(sample::increment(k, 100.0 * block));
    writer.remesh(sample::remesh(100.0 * block));
    writer.frame(sample::frame(100.0 * block, 8));
  }
  writer.finish(sample::summary(reye::base::Analysis::plane_strain, 300.0));
}

/// What a report of the folder says: empty when it is made.
std::string said(const std::string& dir, bool animation = false) {
  try {
    write_report(dir, animation);
    return {};
  } catch (const reye::base::InputError& error) {
    return error.what();
  }
}

/// Some bytes replaced, inserted, left out, or all that follows cut.
std::string altered(std::string text, std::mt19937& random) {
  for (int n = 1 + static_cast<int>(random() % 4); n > 0 && !text.empty(); --n) {
    const std::size_t at = random() % text.size();
    switch (random() % 6) {
      case 0:
        text[at] = static_cast<char>(random());
        break;
      case 1:
        text[at] = "0123456789.,-e\n\"{}[]:="[random() % 22];
        break;
      case 2:
        text.insert(at, 1 + random() % 5, "9,\n\"e-"[random() % 6]);
        break;
      case 3:
        text.erase(at, 1 + random() % 20);
        break;
      case 4:
        text.resize(at);
        break;
      default:
        text.replace(at, 1, "null");
        break;
    }
  }
  return text;
}

}  // namespace

// A table of a run that is done must be refused where it is cut between two rows, too, and looks whole.
TEST(Damage, CutBetweenRows) {
  sample::TemporaryFolder dir;
  write_done(dir.str());
  for (const std::string file : {"history.csv", "surface_pad_secondary.csv"}) {
    const std::string whole = read_text(dir / file);
    atomic_write(dir / file, whole.substr(0, whole.find('\n', whole.size() / 2) + 1));
    EXPECT_TRUE(holds(said(dir.str()), file + " is damaged: it ends at cycle ")) << said(dir.str());
    atomic_write(dir / file, whole);
  }
}

// A file that is missing from a run that is done, cut, or something else altogether must be named, each in a sentence.
TEST(Damage, TheFileIsNamed) {
  sample::TemporaryFolder dir;
  write_done(dir.str());
  ASSERT_EQ(said(dir.str()), "");
  for (const auto& file : read_again) {
    const std::string whole = read_text(dir / file), path = dir / file;
    for (const auto& [what, text] : {std::pair<std::string, std::string>("garbage", std::string("\0\x7f\xff{[\n", 7)),
                                     {"empty", ""},
                                     {"cut", whole.substr(0, whole.size() / 2)}}) {
      atomic_write(path, text);
      EXPECT_TRUE(holds(said(dir.str()), file + " is damaged: ")) << file << ' ' << what << ": " << said(dir.str());
    }
    sample::fs::remove(path);
    const bool may_be_missing = file == "summary.json" || file == "remesh.csv";
    const std::string missing = file == ".reye.json" ? "holds no run of reye"
                                : may_be_missing     ? ""
                                                     : file + " is damaged: it is missing";
    EXPECT_TRUE(holds(said(dir.str()), missing)) << file;
    sample::fs::create_directory(path);
    EXPECT_TRUE(holds(said(dir.str()), file)) << file << ": " << said(dir.str());
    sample::fs::remove(path);
    atomic_write(path, whole);
  }
  EXPECT_EQ(said(dir.str()), "");
}

// If any bytes of a folder are altered, a report must be made or refused with a sentence; nothing else may happen.
TEST(Damage, AnyAlteredBytes) {
  sample::TemporaryFolder dir;
  write_done(dir.str());
  std::mt19937 random(3);
  int refused = 0;
  for (int k = 0; k < 600; ++k) {
    const auto& file = read_again[random() % read_again.size()];
    const std::string whole = read_text(dir / file);
    atomic_write(dir / file, altered(whole, random));
    EXPECT_NO_THROW(refused += !said(dir.str()).empty()) << file;
    EXPECT_NO_THROW(read_end(dir.str()));
    atomic_write(dir / file, whole);
  }
  EXPECT_GT(refused, 200);
}

// A damaged frame must be named by the report that moves.
TEST(Damage, Frames) {
  sample::TemporaryFolder dir;
  write_done(dir.str());
  ASSERT_EQ(said(dir.str(), true), "");
  std::mt19937 random(4);
  for (const char* file : {"frames/bodies_000001.vtu", "frames/surface_000001.vtp"}) {
    const std::string whole = read_text(dir / file);
    for (const std::string& text : {std::string(), std::string("garbage"), whole.substr(0, whole.size() / 2)}) {
      atomic_write(dir / file, text);
      EXPECT_TRUE(holds(said(dir.str(), true), std::string(file) + " is damaged")) << said(dir.str(), true);
    }
    for (int k = 0; k < 40 && !support::address_sanitizer; ++k) {  // sizes may be altered to what no memory holds
      atomic_write(dir / file, altered(whole, random));
      EXPECT_NO_THROW(said(dir.str(), true));
    }
    const auto at = whole.find("AQAAAAAAAA", whole.find("format=\"binary\""));
    ASSERT_NE(at, whole.npos);
    atomic_write(dir / file, std::string(whole).replace(at, 10, "AQAAAP///w"));
    EXPECT_TRUE(holds(said(dir.str(), true), std::string(file) + " is damaged")) << "a count beyond all memory";
    atomic_write(dir / file, whole);
  }
}

// A summary that cannot be read must leave the other members of a sweep in the table, and say so of its own.
TEST(Damage, BrokenMember) {
  sample::TemporaryFolder dir;
  write_done(dir.str());
  EXPECT_EQ(read_end(dir.str()).status, "done");
  const std::string whole = read_text(dir / "summary.json");
  for (const std::string& text :
       {std::string("{\"status\": 3}"), std::string("[1]"), std::string("\xff"), whole.substr(0, 99), std::string()}) {
    atomic_write(dir / "summary.json", text);
    EXPECT_EQ(read_end(dir.str()).status, "damaged") << text;
    EXPECT_TRUE(holds(read_end(dir.str()).reason, "summary.json cannot be read"));
  }
  auto end = read_end(dir.str());
  end.figures = {{"cycles", "5e-324"}, {"life_cycles.deep", "4e-320"}};
  EXPECT_EQ(life_bands({{"member_000", {}, end}}).size(), 1u);
}
