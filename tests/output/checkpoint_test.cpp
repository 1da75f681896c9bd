#include "output/run/checkpoint.hpp"

#include <gtest/gtest.h>

#include <random>

#include "output/folder/files.hpp"
#include "output/run/checksum.hpp"
#include "output/run/commit.hpp"
#include "output/run/layout.hpp"
#include "output/run/serialize.hpp"
#include "output/run/state_archive.hpp"
#include "sample_run.hpp"
#include "support/texts.hpp"

using namespace reye::output;
using reye::support::holds;

namespace {

Origin origin() { return {"0.1.0", "c0ffee", 7, "abc"}; }

/// A folder with the tables that the checkpoint counts.
struct SampleFolder : sample::TemporaryFolder {
  SampleFolder() {
    for (const char* table : {"history.csv", "remesh.csv", "surface_pad_primary.csv"})
      atomic_write(*this / table, "head\none\ntwo\n");
  }
};

Checkpoint checkpoint(const std::string& payload) {
  return {origin(), {2, 1, {{"surface_pad_primary.csv", 2}}, {0.0, 100.0}}, payload};
}

/// The container of a body.
std::string sealed(const std::string& body) {
  std::string head("REYECKP6");
  for (const std::uint64_t value : {static_cast<std::uint64_t>(body.size()), checksum(body)})
    for (int i = 0; i < 8; ++i) head += static_cast<char>((value >> (8 * i)) & 0xff);
  return head + body;
}

/// The reasons against all candidates, as one text.
std::string reasons(const CheckpointSearch& search) {
  std::string all;
  for (const auto& refusal : search.refusals) all += refusal + '\n';
  return all;
}

}  // namespace

// A checkpoint comes back with every byte and what the folder held.
TEST(Checkpoint, ReadsBack) {
  SampleFolder dir;
  const std::string payload("a\0b\nc", 5);
  save_checkpoint(dir.str(), checkpoint(payload));
  const auto search = load_checkpoint(dir.str(), origin());
  ASSERT_TRUE(search.found) << reasons(search);
  EXPECT_EQ(search.found->payload, payload);
  EXPECT_EQ(search.found->counters, checkpoint("").counters);
}

// The newest checkpoint is taken, the one before it is kept.
TEST(Checkpoint, NewestWinsAndPreviousStays) {
  SampleFolder dir;
  for (const char* payload : {"one", "two", "three"}) save_checkpoint(dir.str(), checkpoint(payload));
  EXPECT_EQ(load_checkpoint(dir.str(), origin()).found->payload, "three");
  sample::fs::remove(dir / "checkpoint/current.bin");
  const auto search = load_checkpoint(dir.str(), origin());
  EXPECT_EQ(search.found->payload, "two");
  EXPECT_TRUE(holds(reasons(search), "current.bin: missing"));
}

// Without any checkpoint the search says so.
TEST(Checkpoint, MissingIsSaid) {
  SampleFolder dir;
  const auto search = load_checkpoint(dir.str(), origin());
  EXPECT_FALSE(search.found);
  EXPECT_EQ(search.refusals.size(), 2u);
}

// Cut at any length, the file is refused as truncated and the previous one taken.
TEST(Checkpoint, TruncatedAtAnyByteFallsBack) {
  SampleFolder dir;
  save_checkpoint(dir.str(), checkpoint("old"));
  save_checkpoint(dir.str(), checkpoint("new"));
  const std::string whole = read_text(dir / "checkpoint/current.bin");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    atomic_write(dir / "checkpoint/current.bin", whole.substr(0, size));
    const auto search = load_checkpoint(dir.str(), origin());
    ASSERT_TRUE(search.found);
    ASSERT_EQ(search.found->payload, "old") << size;
    ASSERT_TRUE(holds(reasons(search), "truncated")) << size;
  }
}

// Signs that change in two numbers must change the checksum, as must zeros at the end and an exchange of words.
TEST(Checksum, SeesWhatCouldCancel) {
  const std::string bytes = "0123456789abcdef01234567";
  std::string signs = bytes, exchanged = "89abcdef0123456701234567";
  signs[7] = static_cast<char>(signs[7] ^ 0x80);
  signs[15] = static_cast<char>(signs[15] ^ 0x80);
  for (const auto& other : {signs, exchanged, bytes + '\0', bytes.substr(0, 23)})
    EXPECT_NE(checksum(other), checksum(bytes)) << other;
}

// With any byte altered, the file is refused and the previous one taken.
TEST(Checkpoint, AnyAlteredByteFallsBack) {
  SampleFolder dir;
  save_checkpoint(dir.str(), checkpoint("old"));
  save_checkpoint(dir.str(), checkpoint("new"));
  const std::string whole = read_text(dir / "checkpoint/current.bin");
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string altered = whole;
    altered[i] = static_cast<char>(altered[i] ^ 0x10);
    atomic_write(dir / "checkpoint/current.bin", altered);
    const auto search = load_checkpoint(dir.str(), origin());
    ASSERT_TRUE(search.found && search.found->payload == "old") << i;
    ASSERT_TRUE(holds(reasons(search), "altered") || holds(reasons(search), "truncated") ||
                holds(reasons(search), "older program"))
        << reasons(search);
  }
}

// Checkpoints of another scene or another version are refused with that reason, those of another layout with both
// commits; another commit of the same layout is no reason.
TEST(Checkpoint, OtherOriginsAreRefused) {
  SampleFolder dir;
  save_checkpoint(dir.str(), checkpoint("x"));
  const auto refused = [&](Origin own) {
    const auto search = load_checkpoint(dir.str(), own);
    return search.found ? std::string() : reasons(search);
  };
  EXPECT_TRUE(holds(refused({"0.1.0", "c0ffee", 7, "def"}), "of another scene"));
  EXPECT_TRUE(holds(refused({"0.2.0", "c0ffee", 7, "abc"}), "of another version, 0.1.0 instead of 0.2.0"));
  const auto layout = refused({"0.1.0", "c0ffee", 8, "abc"});
  EXPECT_TRUE(holds(layout, "written by the build of commit c0ffee, whose layout the build of commit ")) << layout;
  EXPECT_TRUE(holds(layout, commit())) << layout;
  EXPECT_EQ(refused({"0.1.0", "f00d", 7, "abc"}), "");
}

// A checkpoint from before layouts had a name is refused as one of an older program.
TEST(Checkpoint, OlderContainerIsRefused) {
  SampleFolder dir;
  save_checkpoint(dir.str(), checkpoint("x"));
  auto bytes = read_text(dir / "checkpoint/current.bin");
  bytes[7] = '2';
  atomic_write(dir / "checkpoint/current.bin", bytes);
  EXPECT_TRUE(holds(reasons(load_checkpoint(dir.str(), origin())), "written by an older program"));
}

// Where a table holds fewer whole rows than a checkpoint says, the checkpoint before is taken, and kept by the next
// save.
TEST(Checkpoint, TablesTooShortFallBack) {
  SampleFolder dir;
  auto old = checkpoint("old");
  old.counters = {0, 0, {}, {}};
  save_checkpoint(dir.str(), old);
  save_checkpoint(dir.str(), checkpoint("new"));
  for (const char* table : {"history.csv", "remesh.csv", "surface_pad_primary.csv"}) {
    const std::string whole = read_text(dir / table);
    ASSERT_EQ(load_checkpoint(dir.str(), origin()).found->payload, "new");
    atomic_write(dir / table, "head\non");
    const auto search = load_checkpoint(dir.str(), origin());
    EXPECT_EQ(search.found.has_value() && search.previous, true) << table;
    EXPECT_TRUE(holds(reasons(search), std::string(table) + " holds fewer than")) << reasons(search);
    atomic_write(dir / table, whole);
  }
  atomic_write(dir / "history.csv", "head\none\n");
  restore_previous(dir.str());
  EXPECT_EQ(load_checkpoint(dir.str(), origin()).found->payload, "old");
  save_checkpoint(dir.str(), old);
  EXPECT_TRUE(load_checkpoint(dir.str(), origin()).found);
  sample::fs::remove(dir / "checkpoint/current.bin");
  EXPECT_EQ(load_checkpoint(dir.str(), origin()).found->payload, "old");
}

// Bytes altered under a right checksum must be refused or read as a checkpoint, whatever they say: no crash, no memory
// for sizes that the file cannot hold, no file outside of the folder.
TEST(Checkpoint, AlteredUnderARightChecksum) {
  const std::string whole = packed(checkpoint("payload"));
  std::mt19937 random(1);
  int refused = 0;
  for (int k = 0; k < 20000; ++k) {
    std::string body = whole.substr(24);
    for (int n = 1 + static_cast<int>(random() % 3); n > 0; --n)
      body[random() % body.size()] = static_cast<char>(random() % 5 == 0 ? 0xff : random());
    try {
      const auto read = unpacked(sealed(body), 7);
      EXPECT_LE(read.payload.size(), whole.size());
    } catch (const std::runtime_error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 5000);
  SampleFolder dir;
  auto outside = checkpoint("x");
  outside.counters.surface_rows = {{"../history.csv", 1}};
  sample::fs::create_directory(dir / "checkpoint");
  atomic_write(dir / "checkpoint/current.bin", packed(outside));
  EXPECT_TRUE(holds(reasons(load_checkpoint(dir.str(), origin())), "it counts rows that no table has"));
}

// Equal states give equal bytes.
TEST(Checkpoint, SameBytes) { EXPECT_EQ(packed(checkpoint("state")), packed(checkpoint("state"))); }

// Vectors and matrices come back bit by bit, empty ones too.
TEST(Serialize, EigenReadsBack) {
  const reye::base::Vector v = reye::base::Vector::LinSpaced(7, 0.1, 0.7), none;
  const reye::base::Matrix m = v * v.transpose();
  const std::vector<reye::base::Vec2> points{{1.0 / 3.0, -0.0}, {1e-310, 2.0}};
  const std::string bytes = to_bytes(v, m, points, none);
  reye::base::Vector v2, none2 = v;
  reye::base::Matrix m2;
  std::vector<reye::base::Vec2> points2;
  from_bytes(bytes, v2, m2, points2, none2);
  EXPECT_EQ(v2, v);
  EXPECT_EQ(none2.size(), 0);
  EXPECT_EQ(m2, m);
  EXPECT_EQ(points2, points);
  EXPECT_EQ(to_bytes(v2, m2, points2, none2), bytes);
}

// Everything that a fine zone says must come back: one made for a body that turns follows no contact, after a restart,
// too.
TEST(Serialize, FineZoneReadsBack) {
  const reye::cad::FineZone zone{.bodies = {"a"},
                                 .centre_mm = {1.0, 2.0},
                                 .half_width_mm = 3.0,
                                 .depth_mm = 4.0,
                                 .size_mm = 5.0,
                                 .angle_deg = 6.0,
                                 .contact = "pad",
                                 .key = "contact.pad.fine_zone[1]",
                                 .turns = true};
  reye::cad::FineZone back;
  from_bytes(to_bytes(zone), back);
  EXPECT_EQ(to_bytes(back), to_bytes(zone));
  EXPECT_EQ(back.key, zone.key);
  EXPECT_TRUE(back.turns);
}

// A matrix of a size that it cannot have, an invalid truth value and a pointer to another type are errors.
TEST(Serialize, ImpossibleBytesThrow) {
  reye::base::Vector v;
  for (const auto& [rows, cols] :
       {std::pair{std::int64_t{-1}, std::int64_t{1}}, {2, 2}, {1LL << 62, 1}, {1LL << 40, 1}})
    EXPECT_THROW(from_bytes(to_bytes(rows, cols, 1.0, 2.0), v), cereal::Exception);
  bool flag = false;
  EXPECT_THROW(from_bytes("\2", flag), cereal::Exception);
  std::vector<double> list;
  EXPECT_THROW(from_bytes(to_bytes(std::uint64_t{1} << 61), list), cereal::Exception);
  const auto number = std::make_shared<double>(1.0);
  std::shared_ptr<double> one;
  std::shared_ptr<int> other;
  const std::string shared = to_bytes(number, number);
  EXPECT_THROW(from_bytes(shared, one, other), cereal::Exception);
  std::shared_ptr<double> again;
  from_bytes(shared, one, again);
  EXPECT_EQ(one, again);
}

// The layout must change with any type inside, and not with values.
TEST(Serialize, LayoutTellsTypesApart) {
  const auto text = [](const auto&... values) {
    LayoutArchive archive;
    archive(values...);
    return archive.text();
  };
  EXPECT_EQ(text(1.0, std::vector<int>{1, 2}), text(2.0, std::vector<int>{}));
  EXPECT_NE(text(std::vector<int>{}), text(std::vector<long>{}));
  EXPECT_NE(text(reye::base::Vector()), text(reye::base::Matrix()));
  EXPECT_NE(text(std::map<std::string, double>{}), text(std::map<std::string, std::optional<double>>{}));
  EXPECT_NE(text(reye::mesh::CellKind::tri3), text(0));
  EXPECT_NE(text(std::vector<reye::body::Shape>{}), text(std::vector<reye::mesh::Mesh>{}));
  EXPECT_NE(state_layout(), 0u);
}

// Shapes come back with their meshes, and what was shared is shared again.
TEST(Serialize, ShapesReadBackAndStayShared) {
  auto mesh = sample::block(2, 1, 0.0);
  mesh.boundaries["top"] = {{3, 4, 5}};
  const reye::body::ShapePtr shape = reye::body::make_shape(mesh);
  const std::vector<reye::body::ShapePtr> shapes{shape, shape};
  std::vector<reye::body::ShapePtr> back;
  from_bytes(to_bytes(shapes), back);
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(back[0], back[1]);
  EXPECT_EQ(back[0]->mesh.X, mesh.X);
  EXPECT_EQ(back[0]->mesh.cells, mesh.cells);
  EXPECT_EQ(back[0]->mesh.boundaries, mesh.boundaries);
  EXPECT_EQ(back[0]->mesh.outline, mesh.outline);
  EXPECT_EQ(back[0]->born->X, mesh.X);
}

// Bytes that end early are an error, not garbage.
TEST(Serialize, ShortBytesThrow) {
  reye::base::Vector v = reye::base::Vector::Ones(5);
  std::string bytes = to_bytes(v);
  bytes.pop_back();
  EXPECT_THROW(from_bytes(bytes, v), cereal::Exception);
}
