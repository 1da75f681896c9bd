#include "output/report/contact_zone.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "output/folder/files.hpp"
#include "output/folder/vtk_frames.hpp"
#include "output/report/profiles.hpp"
#include "output/report/shape_figures.hpp"
#include "sample_run.hpp"

using namespace reye;
using namespace reye::output;

namespace {

DrawnSurfaces surfaces_of(const sim::Frame& frame) {
  sample::TemporaryFolder dir;
  atomic_write(dir / "s.vtp", surfaces_vtp(frame));
  return read_drawn_surfaces(dir / "s.vtp");
}

DrawnFrame drawn_of(const sim::Frame& frame) {
  sample::TemporaryFolder dir;
  atomic_write(dir / "b.vtu", bodies_vtu(frame));
  return read_drawn(dir / "b.vtu");
}

double largest_y(const Line& line) {
  double most = -INFINITY;
  for (const double y : line.y)
    if (std::isfinite(y)) most = std::max(most, y);
  return most;
}

const Figure* found(const std::vector<Figure>& all, const std::string& id) {
  for (const auto& figure : all)
    if (figure.id == id) return &figure;
  return nullptr;
}

}  // namespace

// The vector into a body must point away from the other one, on both sides and whichever way the line runs.
TEST(ContactZone, InwardPointsIntoTheBody) {
  const auto surfaces = surfaces_of(sample::frame(9000.0));
  ASSERT_EQ(surfaces.lines.size(), 2u);
  const auto into = inward(surfaces, Held::deformed);
  for (const auto& line : surfaces.lines)
    for (std::size_t i = line.begin; i < line.end; ++i)
      EXPECT_NEAR((into[i] - base::Vec2(0.0, line.body == 0 ? -1.0 : 1.0)).norm(), 0.0, 1e-12);
}

// Factors must be round, show wear at no more than an eighth of the window, and never make it smaller.
TEST(ContactZone, MagnificationIsRound) {
  const Window window{{0.0, 2.0}, {0.0, 1.0}};
  EXPECT_EQ(magnification(0.1, window), 1.0);
  EXPECT_EQ(magnification(1.0, window), 1.0);
  EXPECT_EQ(magnification(0.01, window), 10.0);
  EXPECT_EQ(magnification(0.002, window), 50.0);
  EXPECT_EQ(magnification(0.00025, window), 500.0);
  EXPECT_EQ(magnification(0.0, window), 1.0);
}

// Magnified wear must move the worn node by the factor times its depth into its body, and leave what is far below.
TEST(ContactZone, WearIsMagnified) {
  const auto frame = sample::frame(18000.0);
  const auto surfaces = surfaces_of(frame);
  const auto drawn = drawn_of(frame);
  const Window window = contact_window("pad", {surfaces}, Held::deformed, 2.0);
  const double factor = 20.0, depth = 0.0025;
  const auto lowest = [](const Moment& moment) {  // of the flat's outline, which ends at its surface
    double y = INFINITY;
    const Line& line = moment.lines.front();
    for (std::size_t i = 0; i < line.x.size(); ++i)
      if (std::abs(line.x[i] - 0.25) < 1e-9 && line.y[i] < 0.0) y = std::min(y, std::abs(line.y[i] + 0.01));
    return y;
  };
  EXPECT_NEAR(lowest(stressed_bodies(drawn, surfaces, window, stress_levels(300.0), 1.0)), 0.0, 1e-12);
  EXPECT_NEAR(lowest(stressed_bodies(drawn, surfaces, window, stress_levels(300.0), factor)), (factor - 1.0) * depth,
              1e-4);
}

// The levels of stress begin at zero, are round and hold the largest.
TEST(ContactZone, StressLevelsHoldTheLargest) {
  for (const double top : {0.0, 1e-9, 7.0, 86.0, 1234.5}) {
    const auto levels = stress_levels(top);
    EXPECT_EQ(levels.front(), 0.0);
    EXPECT_GE(levels.back(), top);
    EXPECT_GE(levels.size(), 3u);
  }
}

// The shape is drawn as it was and as it is, and once more with its wear magnified; then the stress.
TEST(ShapeFigures, BeforeAndAfter) {
  sample::TemporaryFolder dir;
  RunWriter writer(dir.str(), sample::scene());
  writer.begin();
  for (const double cycle : {0.0, 18000.0}) writer.frame(sample::frame(cycle, 40));
  const auto all = shape_figures(read_run(dir.str()), dir.str());
  const auto *whole = found(all, "shape-pad"), *magnified = found(all, "shape-magnified-pad");
  ASSERT_TRUE(whole && magnified && found(all, "stress-pad"));
  ASSERT_EQ(whole->lines.size(), 4u);  // both sides before, both after
  const double factor = std::stod(magnified->title.substr(magnified->title.find("×") + 2));
  EXPECT_NEAR(largest_y(magnified->lines[3]) - largest_y(whole->lines[3]), (factor - 1.0) * 0.0016, 1e-12);
  EXPECT_EQ(largest_y(whole->lines[1]), 0.0);
}

// Without frames for ParaView there is no shape to draw.
TEST(ShapeFigures, NeedFrames) {
  sample::TemporaryFolder dir;
  sample::write_run(dir.str(), 40);
  for (const auto& entry : sample::fs::directory_iterator(dir / "frames")) sample::fs::remove(entry.path());
  EXPECT_TRUE(shape_figures(read_run(dir.str()), dir.str()).empty());
}
