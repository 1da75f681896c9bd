#include "output/checkpoint.hpp"

#include <gtest/gtest.h>

#include "output/files.hpp"
#include "output/serialize.hpp"
#include "sample_run.hpp"

using namespace reye::output;

namespace {

Checkpoint checkpoint(const std::string& payload) {
  return {{"0.1.0", "abc", {12, 3, {{"surface_pad_primary.csv", 40}}, {0.0, 100.0}}}, payload};
}

/// The reasons against all candidates, as one text.
std::string reasons(const CheckpointSearch& search) {
  std::string all;
  for (const auto& refusal : search.refusals) all += refusal + '\n';
  return all;
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

// A checkpoint comes back with every byte and what the folder held.
TEST(Checkpoint, ReadsBack) {
  sample::TemporaryFolder dir;
  const std::string payload("a\0b\nc", 5);
  save_checkpoint(dir.str(), checkpoint(payload));
  const auto search = load_checkpoint(dir.str(), "0.1.0", "abc");
  ASSERT_TRUE(search.found) << reasons(search);
  EXPECT_EQ(search.found->payload, payload);
  EXPECT_EQ(search.found->info.counters, checkpoint("").info.counters);
}

// The newest checkpoint is taken, the one before it is kept.
TEST(Checkpoint, NewestWinsAndPreviousStays) {
  sample::TemporaryFolder dir;
  for (const char* payload : {"one", "two", "three"}) save_checkpoint(dir.str(), checkpoint(payload));
  EXPECT_EQ(load_checkpoint(dir.str(), "0.1.0", "abc").found->payload, "three");
  sample::fs::remove(dir / "checkpoint/current.bin");
  const auto search = load_checkpoint(dir.str(), "0.1.0", "abc");
  EXPECT_EQ(search.found->payload, "two");
  EXPECT_TRUE(holds(reasons(search), "current.bin: missing"));
}

// Without any checkpoint the search says so.
TEST(Checkpoint, MissingIsSaid) {
  sample::TemporaryFolder dir;
  const auto search = load_checkpoint(dir.str(), "0.1.0", "abc");
  EXPECT_FALSE(search.found);
  EXPECT_EQ(search.refusals.size(), 2u);
}

// Cut at any length, the file is refused as truncated and the previous one taken.
TEST(Checkpoint, TruncatedAtAnyByteFallsBack) {
  sample::TemporaryFolder dir;
  save_checkpoint(dir.str(), checkpoint("old"));
  save_checkpoint(dir.str(), checkpoint("new"));
  const std::string whole = read_text(dir / "checkpoint/current.bin");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    atomic_write(dir / "checkpoint/current.bin", whole.substr(0, size));
    const auto search = load_checkpoint(dir.str(), "0.1.0", "abc");
    ASSERT_TRUE(search.found);
    ASSERT_EQ(search.found->payload, "old") << size;
    ASSERT_TRUE(holds(reasons(search), "truncated")) << size;
  }
}

// With any byte altered, the file is refused and the previous one taken.
TEST(Checkpoint, AnyAlteredByteFallsBack) {
  sample::TemporaryFolder dir;
  save_checkpoint(dir.str(), checkpoint("old"));
  save_checkpoint(dir.str(), checkpoint("new"));
  const std::string whole = read_text(dir / "checkpoint/current.bin");
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string altered = whole;
    altered[i] = static_cast<char>(altered[i] ^ 0x10);
    atomic_write(dir / "checkpoint/current.bin", altered);
    const auto search = load_checkpoint(dir.str(), "0.1.0", "abc");
    ASSERT_TRUE(search.found && search.found->payload == "old") << i;
    ASSERT_TRUE(holds(reasons(search), "altered") || holds(reasons(search), "truncated")) << reasons(search);
  }
}

// Checkpoints of another scene or another version are refused with that reason.
TEST(Checkpoint, OtherSceneOrVersionIsRefused) {
  sample::TemporaryFolder dir;
  save_checkpoint(dir.str(), checkpoint("x"));
  const auto scene = load_checkpoint(dir.str(), "0.1.0", "def");
  EXPECT_FALSE(scene.found);
  EXPECT_TRUE(holds(reasons(scene), "of another scene"));
  const auto version = load_checkpoint(dir.str(), "0.2.0", "abc");
  EXPECT_FALSE(version.found);
  EXPECT_TRUE(holds(reasons(version), "of another version, 0.1.0 instead of 0.2.0"));
}

// The same state gives the same bytes.
TEST(Checkpoint, SameBytes) { EXPECT_EQ(packed(checkpoint("state")), packed(checkpoint("state"))); }

// Vectors, matrices and sparse matrices come back bit by bit, empty ones too.
TEST(Serialize, EigenReadsBack) {
  const reye::base::Vector v = reye::base::Vector::LinSpaced(7, 0.1, 0.7), none;
  const reye::base::Matrix m = v * v.transpose();
  const std::vector<reye::base::Vec2> points{{1.0 / 3.0, -0.0}, {1e-310, 2.0}};
  reye::base::SparseMatrix s(3, 4), hollow(2, 2);
  s.insert(1, 2) = 0.1;
  s.insert(2, 0) = 5.0;
  const std::string bytes = to_bytes(v, none, m, points, s, hollow);
  reye::base::Vector v2, none2 = v;
  reye::base::Matrix m2;
  std::vector<reye::base::Vec2> points2;
  reye::base::SparseMatrix s2, hollow2;
  from_bytes(bytes, v2, none2, m2, points2, s2, hollow2);
  EXPECT_EQ(v2, v);
  EXPECT_EQ(none2.size(), 0);
  EXPECT_EQ(m2, m);
  EXPECT_EQ(points2, points);
  EXPECT_EQ(reye::base::Matrix(s2), reye::base::Matrix(s));
  EXPECT_EQ(hollow2.nonZeros(), 0);
  EXPECT_EQ(to_bytes(v2, none2, m2, points2, s2, hollow2), bytes);
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
