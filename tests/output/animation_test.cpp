#include "output/report/animation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "output/folder/files.hpp"
#include "output/folder/vtk_frames.hpp"
#include "output/report/drawn_frame.hpp"
#include "output/report/profiles.hpp"
#include "output/report/report.hpp"
#include "sample_run.hpp"
#include "support/texts.hpp"
#include "well_formed.hpp"

using namespace reye::output;
using reye::support::times;
using sample::well_formed;

namespace {

/// A run whose frames change their meshes, without summary.
void write_frames(const std::string& dir, int count) {
  RunWriter writer(dir, sample::scene());
  writer.begin();
  for (int k = 0; k < count; ++k) writer.frame(sample::frame(18000.0 * k / (count - 1), 8 + k % 3));
}

}  // namespace

// A frame must come back with its deformed points, every edge once, and as outline those of one element only.
TEST(DrawnFrame, EdgesAndOutline) {
  sample::TemporaryFolder dir;
  const auto frame = sample::frame(1000.0, 8);
  atomic_write(dir / "f.vtu", bodies_vtu(frame));
  const auto drawn = read_drawn(dir / "f.vtu");
  EXPECT_EQ(drawn.cycle, 1000.0);
  ASSERT_EQ(drawn.x.size(), 27u + 27u + 4u);
  EXPECT_EQ(drawn.x[5], frame.bodies[0].mesh->X[5] + frame.bodies[0].u[5]);
  std::vector<int> all(3), outline(3);
  for (const auto& edge : drawn.edges) {
    ++all[static_cast<std::size_t>(edge.body)];
    outline[static_cast<std::size_t>(edge.body)] += edge.outline;
  }
  EXPECT_EQ(all, (std::vector<int>{8 * 3 + 9 * 2, 8 * 3 + 9 * 2, 4}));  // blocks of 8 x 2 cells, a bar of 4 edges
  EXPECT_EQ(outline, (std::vector<int>{20, 20, 4}));
  EXPECT_THROW(read_drawn(dir / "none.vtu"), std::runtime_error);
}

// Each moving figure must have a moment per frame, in their order, and the last must hold the last rows of the tables.
TEST(Animation, MomentsAreTheFrames) {
  sample::TemporaryFolder dir;
  write_frames(dir.str(), 10);
  const auto run = read_run(dir.str());
  const auto all = moving_figures(run, dir.str());
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].id, "moving-bodies-pad");
  EXPECT_EQ(all[1].id, "moving-pressure-pad");
  EXPECT_EQ(all[2].id, "moving-depth-pad");
  for (const auto& figure : all) {
    ASSERT_EQ(figure.moments.size(), 10u);
    for (std::size_t k = 0; k < 10; ++k)
      EXPECT_TRUE(figure.moments[k].caption.starts_with("cycle " + std::to_string(2000 * k)));
  }
  for (std::size_t side = 0; side < 2; ++side) {
    const auto& surface = run.contacts[0].sides[side];
    const auto& rows = surface.frames.back();
    const auto& line = all[2].moments.back().lines[side];
    ASSERT_EQ(line.y.size(), rows.end - rows.begin);
    for (std::size_t i = 0; i < line.y.size(); ++i)
      EXPECT_DOUBLE_EQ(line.y[i], 1e3 * surface.table.column("wear_depth_mm")[rows.begin + i]);
    if (side == 0) {
      for (std::size_t i = 0; i < line.y.size(); ++i)
        EXPECT_EQ(all[1].moments.back().lines[0].y[i], surface.table.column("pressure_MPa")[rows.begin + i]);
    }
  }
}

// The bodies must be drawn where they are, in the aspect of the plot: the window holds the whole contact, and the
// stress of each body is coloured in its band.
TEST(Animation, BodiesStandWhereTheyAre) {
  sample::TemporaryFolder dir;
  write_frames(dir.str(), 3);
  const auto run = read_run(dir.str());
  const auto bodies = moving_figures(run, dir.str()).front();
  EXPECT_NEAR(bodies.x_range->width() / bodies.y_range->width(), plot_aspect, 1e-12);
  EXPECT_LT(bodies.x_range->low, 0.25 - 0.47);
  EXPECT_GT(bodies.x_range->high, 0.25 + 0.47);
  const auto& moment = bodies.moments.back();
  ASSERT_EQ(moment.areas.size(), 2u);  // one band, since stress is the same everywhere; the rigid bar
  EXPECT_EQ(moment.areas[0].loops.size(), 2u);
  EXPECT_TRUE(moment.caption.find("up to 117 MPa") != std::string::npos) << moment.caption;
  EXPECT_TRUE(bodies.title.find("wear ×") != std::string::npos) << bodies.title;
}

// However many frames there are, no more than sixty are shown, the last among them, and the page stays small.
TEST(Animation, IsBounded) {
  sample::TemporaryFolder dir;
  write_frames(dir.str(), 200);
  write_report(dir.str(), true);
  const std::string page = read_text(dir / "report.html");
  EXPECT_TRUE(well_formed(page));
  EXPECT_EQ(times("<g class=\"moment\"", page), 3u * 60u);
  EXPECT_EQ(times(">cycle 18000", page), 3u);
  EXPECT_LT(page.size(), 3000000u);
  for (const char* outside : {"src=", "href=", "@import", "url(http"}) EXPECT_EQ(times(outside, page), 0u) << outside;
}

// Each moving picture must be well-formed by itself and move without a script, each moment for its part of the time.
TEST(Animation, MovesByItself) {
  sample::TemporaryFolder dir;
  write_frames(dir.str(), 4);
  write_report(dir.str(), true);
  for (const char* id : {"moving-bodies-pad", "moving-pressure-pad", "moving-depth-pad"}) {
    const std::string picture = read_text(dir / ("figures/" + std::string(id) + ".svg"));
    EXPECT_TRUE(well_formed(picture)) << id;
    EXPECT_EQ(times("<g class=\"moment\"", picture), 4u);
    EXPECT_EQ(times("display=\"none\"", picture), 3u);  // without animation the last one is seen
    EXPECT_EQ(times("values=\"none;inline;none\" keyTimes=\"0;0.250000;0.500000\" dur=\"1.00s\"", picture), 1u);
  }
}

// A run with one frame, or asked for no animation, must have none.
TEST(Animation, OnlyWhereSomethingMoves) {
  sample::TemporaryFolder dir;
  write_frames(dir.str(), 3);
  write_report(dir.str());
  EXPECT_EQ(times("Animation", read_text(dir / "report.html")), 0u);
  sample::TemporaryFolder single;
  RunWriter writer(single.str(), sample::scene());
  writer.begin();
  writer.frame(sample::frame(0.0));
  write_report(single.str(), true);
  EXPECT_EQ(times("Animation", read_text(single / "report.html")), 0u);
}
