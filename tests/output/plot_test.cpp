#include "output/report/plot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "output/folder/text.hpp"
#include "support/texts.hpp"

using namespace reye::output;
using reye::support::holds;
using Labels = std::vector<std::string>;

// Ticks are 1, 2 or 5 times a power of ten, inside the range, with labels that differ.
TEST(Ticks, AreRound) {
  EXPECT_EQ(nice_ticks(0.0, 10.0, 5).labels, (Labels{"0", "2", "4", "6", "8", "10"}));
  EXPECT_EQ(nice_ticks(-0.3, 0.3, 6).labels, (Labels{"−0.3", "−0.2", "−0.1", "0.0", "0.1", "0.2", "0.3"}));
  EXPECT_EQ(nice_ticks(0.0, 18000.0, 4).labels, (Labels{"0", "5000", "10000", "15000"}));
  EXPECT_EQ(nice_ticks(0.0, 0.004, 4).labels, (Labels{"0.000", "0.001", "0.002", "0.003", "0.004"}));
}

// Very small and very large values share one power of ten.
TEST(Ticks, ShareAPowerOfTen) {
  const Ticks small = nice_ticks(0.0, 4e-7, 4), large = nice_ticks(0.0, 2e9, 4);
  EXPECT_EQ(small.exponent, -7);
  EXPECT_EQ(small.labels, (Labels{"0", "1", "2", "3", "4"}));
  EXPECT_EQ(large.exponent, 9);
  EXPECT_EQ(large.labels, (Labels{"0.0", "0.5", "1.0", "1.5", "2.0"}));
}

// Any range gives at least two ticks, one without width or that is not finite included.
TEST(Ticks, NeverFail) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Range range : {Range{3.0, 3.0}, Range{0.0, 0.0}, Range{nan, 1.0}, Range{-1e300, 1e300}, Range{5.0, 1.0},
                            Range{1.0, 1.0 + 1e-15}, Range{0.0, 1e-308}})
    EXPECT_GE(nice_ticks(range.low, range.high).values.size(), 2u) << range.low << ' ' << range.high;
}

// A range grown to whole steps holds the old one.
TEST(Ticks, RoundedOutHoldsTheRange) {
  const Range range = rounded_out({0.13, 2.47}, 6);
  EXPECT_DOUBLE_EQ(range.low, 0.0);
  EXPECT_DOUBLE_EQ(range.high, 2.5);
}

// A figure shows title, both labels and the legend, and a value that is not finite interrupts its line.
TEST(Svg, ShowsWhatItIsGiven) {
  Figure figure{.id = "f", .title = "p < q", .x_label = "x, mm", .y_label = "p, MPa"};
  figure.lines.push_back({.label = "one", .x = {0, 1, 2, 3}, .y = {0, 1, NAN, 2}});
  const std::string text = svg(figure);
  for (const char* part : {"p &lt; q", "x, mm", "p, MPa", ">one<", "clip-f"}) EXPECT_TRUE(holds(text, part)) << part;
  EXPECT_FALSE(holds(text, "nan"));
  const auto path = text.substr(text.find("<path"));
  EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 2);
  EXPECT_EQ(text, svg(figure));
}

// A figure without lines or points is still a figure.
TEST(Svg, EmptyDataIsNoCrash) {
  Figure figure{.id = "f", .title = "t", .x_label = "x", .y_label = "y"};
  EXPECT_TRUE(holds(svg(figure), "</svg>"));
  figure.lines.push_back({.label = "none"});
  EXPECT_TRUE(holds(svg(figure), "</svg>"));
  EXPECT_TRUE(holds(svg_bars({}), "</svg>"));
}

// The largest bar is the longest; labels and texts are there.
TEST(Svg, BarsAreDrawn) {
  const std::string text = svg_bars({{"algebra", 2.0, "2 s"}, {"mortar", 1.0, "1 s"}});
  EXPECT_TRUE(holds(text, ">algebra<") && holds(text, ">1 s<"));
}

// Thinning a long line keeps its peaks.
TEST(Thinned, KeepsPeaks) {
  Line line;
  for (int i = 0; i < 100000; ++i) {
    line.x.push_back(i);
    line.y.push_back(i == 54321 ? 7.0 : (i == 4321 ? -7.0 : std::sin(0.01 * i)));
  }
  const Line thin = thinned(line, 1000);
  EXPECT_LE(thin.x.size(), 1000u);
  EXPECT_EQ(*std::max_element(thin.y.begin(), thin.y.end()), 7.0);
  EXPECT_EQ(*std::min_element(thin.y.begin(), thin.y.end()), -7.0);
  EXPECT_TRUE(std::is_sorted(thin.x.begin(), thin.x.end()));
}

// Numbers for readers keep whole digits, use powers of ten only outside 1e-3 .. 1e6, and end where they say something.
TEST(Rounded, IsReadable) {
  EXPECT_EQ(rounded(16200.5, 4), "16200");
  EXPECT_EQ(rounded(0.00161, 4), "0.00161");
  EXPECT_EQ(rounded(3.14e-14, 2), "3.1 · 10⁻¹⁴");
  EXPECT_EQ(rounded(2e6, 8), "2 · 10⁶");
  EXPECT_EQ(rounded(1.25e-7, 4), "1.25 · 10⁻⁷");
  EXPECT_EQ(rounded(1e10, 3), "1 · 10¹⁰");
  EXPECT_EQ(rounded(0.0), "0");
  EXPECT_EQ(rounded(NAN), "–");
}

// A moment must draw its lines where the figure would draw them as its own, and be seen for its share of the film.
TEST(Svg, MomentsStandWhereLinesDo) {
  const Line line{.x = {0.0, 1.0, 2.0}, .y = {1.0, 3.0, 2.0}};
  Figure still{.id = "f", .title = "t", .x_label = "x", .y_label = "y", .lines = {line}};
  still.x_range = Range{0.0, 2.0};
  still.y_range = Range{0.0, 4.0};
  Figure moving = still;
  moving.lines.clear();
  moving.moments = {{.caption = "early"}, {.caption = "late", .lines = {line}}};
  const std::string one = svg(still), film = svg(moving);
  const auto from = one.find("<path"), to = one.find("/>", from);
  EXPECT_TRUE(holds(film, one.substr(from, to - from)));
  EXPECT_TRUE(holds(film, "values=\"inline;none\" keyTimes=\"0;0.500000\" dur=\"0.50s\""));
  EXPECT_TRUE(holds(film, "values=\"none;inline\" keyTimes=\"0;0.500000\" dur=\"0.50s\""));
  moving.moments.erase(moving.moments.begin());
  EXPECT_FALSE(holds(svg(moving), "<animate"));
}

// Exact ranges must be kept as they are, others are rounded out.
TEST(Svg, ExactRanges) {
  Figure figure{.id = "f", .title = "t", .x_label = "x", .y_label = "y"};
  figure.moments = {{.lines = {{.x = {0.0, 1.0}, .y = {0.37, 0.91}}}}};
  figure.x_range = Range{0.0, 1.0};
  figure.y_range = Range{0.37, 0.91};
  figure.exact_ranges = true;
  EXPECT_TRUE(holds(svg(figure), "<path d=\"M76.00 340.00L696.00 40.00\""));
  figure.exact_ranges = false;
  EXPECT_FALSE(holds(svg(figure), "<path d=\"M76.00 340.00L696.00 40.00\""));
}
