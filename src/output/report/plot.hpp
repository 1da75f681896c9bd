#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/linalg.hpp"
#include "output/picture/ticks.hpp"

/// A small SVG plotter: line figures and bars as text, the same bytes for the same input.
namespace reye::output {

struct Line {
  std::string label{};  ///< empty: not in the legend
  std::vector<double> x{}, y{};
  std::string colour = "#1f5fa8";
  double width = 1.8;
  bool dashed = false;
  bool dots = false;  ///< mark the points: few values, or values far apart
};

/// A filled region: polygons, holes among them running the other way round.
struct Area {
  std::string colour{};
  std::vector<base::Points> loops{};
};

/// Areas, and lines above them, shown for a while, with their label.
struct Moment {
  std::string caption{};
  std::vector<Area> areas{};
  std::vector<Line> lines{};
};

/// Explains what is coloured by a value with `scale_colour`.
struct ColourScale {
  std::string label;
  Range range;
  int steps = 32;
};

struct Figure {
  std::string id{};  ///< file name and prefix of ids inside the SVG
  std::string title{}, x_label{}, y_label{};
  std::vector<Area> areas{};  ///< below the lines
  std::vector<Line> lines{};
  std::vector<Moment> moments{};  ///< shown one after the other, `moment_seconds` each, again and again
  std::optional<ColourScale> scale{};
  std::optional<Range> x_range{};  ///< else from the data
  std::optional<Range> y_range{};
  bool y_down = false;  ///< depth grows downwards
  bool y_from_zero = false;
  std::optional<double> aspect{};  ///< width over height of the field, which then is as wide as one with a scale
  bool exact_ranges = false;  ///< not rounded out: shapes keep their angles when the ranges are in the plot's aspect
};

/// Width over height of the field of a figure without legend and scale.
inline constexpr double plot_aspect = 620.0 / 300.0;

inline constexpr double moment_seconds = 0.25;

struct Bar {
  std::string label{};
  double value = 0.0;
  std::string text{};  ///< beside the bar
};

/// The figure as one <svg> element. Points that are not finite interrupt their line. Moments move by SMIL, without any
/// script; where that is not supported, and on paper, the last one is shown.
std::string svg(const Figure& figure);

/// Figures side by side as one <svg> element: a picture that stands alone.
std::string svg_row(const std::vector<Figure>& figures);

/// Horizontal bars as one <svg> element.
std::string svg_bars(const std::vector<Bar>& bars);

/// Colour of t in [0, 1], from dark blue over teal and green to orange; still ordered in grey print.
std::string scale_colour(double t);

/// The i-th of a few colours that stay apart in print and for the colour-blind.
std::string line_colour(std::size_t i);

/// At most about `limit` points: of each run of points its lowest and highest stay.
Line thinned(const Line& line, std::size_t limit);

}  // namespace reye::output
