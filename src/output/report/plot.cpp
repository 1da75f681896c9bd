#include "output/report/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/formatted.hpp"
#include "output/folder/text.hpp"

namespace reye::output {

namespace {

constexpr double width = 720.0, left = 76.0, bottom_space = 52.0, plot_height = 300.0;
constexpr const char* ink = "#2b2f36";
constexpr const char* faint = "#e3e6ea";

std::string fixed(double value) { return base::fixed(value, 2); }

std::string attribute(const char* name, double value) { return std::string(" ") + name + "=\"" + fixed(value) + '"'; }

struct TextStyle {
  const char* anchor = "start";
  double size = 13.0;
  bool bold = false;
  bool upright = false;  ///< turned by a quarter, reading upwards
};

std::string text_at(double x, double y, const std::string& text, const TextStyle& style = {}) {
  std::string element = "<text" + attribute("x", x) + attribute("y", y) + attribute("font-size", style.size) +
                        " text-anchor=\"" + style.anchor + '"';
  if (style.bold) element += " font-weight=\"600\"";
  if (style.upright) element += " transform=\"rotate(-90 " + fixed(x) + ' ' + fixed(y) + ")\"";
  return element + '>' + escaped(text) + "</text>\n";
}

std::string line_between(std::array<double, 4> p, const std::string& colour, double stroke, bool dashed = false) {
  return "<line" + attribute("x1", p[0]) + attribute("y1", p[1]) + attribute("x2", p[2]) + attribute("y2", p[3]) +
         " stroke=\"" + colour + '"' + attribute("stroke-width", stroke) + (dashed ? " stroke-dasharray=\"6 4\"" : "") +
         "/>\n";
}

std::string svg_open(double height, double wide = width) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + fixed(wide) + ' ' + fixed(height) +
         "\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" fill=\"" + ink + "\" role=\"img\">\n" +
         "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
}

/// Approximate width of a text of this size, for the layout of a legend.
double text_width(const std::string& text, double size) {
  const auto letters = std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; });
  return 0.56 * size * static_cast<double>(letters);
}

/// The layout of a figure, in pixels.
struct Layout {
  double right = width - 24.0;
  double top = 44.0;
  double bottom = 0.0;
  Range x, y;
  bool y_down = false;

  double px(double value) const { return left + (value - x.low) / x.width() * (right - left); }
  double py(double value) const {
    const double t = (value - y.low) / y.width();
    return y_down ? top + t * (bottom - top) : bottom - t * (bottom - top);
  }
};

Range range_of(const std::vector<Line>& lines, bool of_x, const std::optional<Range>& within) {
  Range range{INFINITY, -INFINITY};
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.x.size(); ++i) {
      const double value = of_x ? line.x[i] : line.y[i];
      const bool seen = !within || (line.x[i] >= within->low && line.x[i] <= within->high);
      if (!seen || !std::isfinite(value)) continue;
      range = {std::min(range.low, value), std::max(range.high, value)};
    }
  return widened(range);
}

struct LegendEntry {
  const Line* line;
  double x, y;
};

/// Legend entries in rows under the title; returns the y where the plot may begin.
double lay_out_legend(const Figure& figure, double right, std::vector<LegendEntry>& entries) {
  double x = left, y = 44.0;
  for (const auto& line : figure.lines) {
    if (line.label.empty()) continue;
    const double needed = 34.0 + text_width(line.label, 12.5) + 18.0;
    if (x > left && x + needed > right + 18.0) {
      x = left;
      y += 19.0;
    }
    entries.push_back({&line, x, y});
    x += needed;
  }
  return entries.empty() ? 40.0 : y + 16.0;
}

std::string draw_legend(const std::vector<LegendEntry>& entries) {
  std::string out;
  for (const auto& [line, x, y] : entries) {
    out += line_between({x, y - 4.0, x + 26.0, y - 4.0}, line->colour, std::max(line->width, 1.8), line->dashed);
    out += text_at(x + 32.0, y, line->label, {.size = 12.5});
  }
  return out;
}

std::string with_power(const std::string& label, int exponent) {
  return exponent == 0 ? label : label + "  ×" + power_of_ten(exponent);
}

std::string draw_axes(const Figure& figure, const Layout& at) {
  std::string out;
  const Ticks tx = nice_ticks(at.x.low, at.x.high, 8), ty = nice_ticks(at.y.low, at.y.high, 6);
  for (std::size_t i = 0; i < tx.values.size(); ++i) {
    const double x = at.px(tx.values[i]);
    out += line_between({x, at.top, x, at.bottom}, faint, 1.0);
    out += text_at(x, at.bottom + 18.0, tx.labels[i], {.anchor = "middle", .size = 12.0});
  }
  for (std::size_t i = 0; i < ty.values.size(); ++i) {
    const double y = at.py(ty.values[i]);
    out += line_between({left, y, at.right, y}, faint, 1.0);
    out += text_at(left - 8.0, y + 4.0, ty.labels[i], {.anchor = "end", .size = 12.0});
  }
  out += "<rect" + attribute("x", left) + attribute("y", at.top) + attribute("width", at.right - left) +
         attribute("height", at.bottom - at.top) + " fill=\"none\" stroke=\"#9aa1ab\"/>\n";
  out +=
      text_at(0.5 * (left + at.right), at.bottom + 40.0, with_power(figure.x_label, tx.exponent), {.anchor = "middle"});
  return out + text_at(20.0, 0.5 * (at.top + at.bottom), with_power(figure.y_label, ty.exponent),
                       {.anchor = "middle", .upright = true});
}

std::string draw_line(const Line& line, const Layout& at) {
  std::string path;
  bool down = false;
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    const bool finite = std::isfinite(line.x[i]) && std::isfinite(line.y[i]);
    if (finite) path += (down ? 'L' : 'M') + fixed(at.px(line.x[i])) + ' ' + fixed(at.py(line.y[i]));
    down = finite;
  }
  if (path.empty()) return {};
  std::string dots;
  for (std::size_t i = 0; line.dots && i < line.x.size(); ++i)
    if (std::isfinite(line.x[i]) && std::isfinite(line.y[i]))
      dots += "<circle" + attribute("cx", at.px(line.x[i])) + attribute("cy", at.py(line.y[i])) + " r=\"3\" fill=\"" +
              line.colour + "\"/>\n";
  return dots + "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + line.colour + '"' +
         attribute("stroke-width", line.width) + " stroke-linejoin=\"round\" stroke-linecap=\"round\"" +
         (line.dashed ? " stroke-dasharray=\"6 4\"" : "") + "/>\n";
}

/// To a tenth of a pixel, without points closer than that would show; a hairline of its own colour closes the seam to
/// the area beside it.
std::string draw_area(const Area& area, const Layout& at) {
  constexpr double seen = 0.6;
  std::string path;
  for (const auto& loop : area.loops) {
    double last_x = NAN, last_y = NAN;
    for (const auto& p : loop) {
      const double x = at.px(p.x()), y = at.py(p.y());
      if (std::hypot(x - last_x, y - last_y) < seen) continue;
      path += (std::isnan(last_x) ? 'M' : 'L') + base::fixed(x, 1) + ' ' + base::fixed(y, 1);
      last_x = x;
      last_y = y;
    }
    path += 'Z';
  }
  return "<path d=\"" + path + "\" fill=\"" + area.colour + "\" stroke=\"" + area.colour +
         "\" stroke-width=\"0.6\"/>\n";
}

/// The time in the film at which the k-th of so many moments is shown.
std::string timing(std::size_t k, std::size_t count) {
  if (count < 2) return {};
  const auto part = [&](std::size_t i) {
    return base::formatted("%.6f", static_cast<double>(i) / static_cast<double>(count));
  };
  std::string values = k == 0 ? "inline" : "none;inline", times = k == 0 ? "0" : "0;" + part(k);
  if (k + 1 < count) {
    values += ";none";
    times += ';' + part(k + 1);
  }
  return "<animate attributeName=\"display\" calcMode=\"discrete\" repeatCount=\"indefinite\" values=\"" + values +
         "\" keyTimes=\"" + times + "\" dur=\"" + fixed(moment_seconds * static_cast<double>(count)) + "s\"/>\n";
}

std::string draw_moments(const Figure& figure, const Layout& at, const std::string& clip) {
  const std::size_t count = figure.moments.size();
  std::string out;
  for (std::size_t k = 0; k < count; ++k) {
    out += "<g class=\"moment\"" + std::string(k + 1 < count ? " display=\"none\">\n" : ">\n") + timing(k, count);
    out += text_at(at.right + (figure.scale ? 64.0 : 0.0), 22.0, figure.moments[k].caption,
                   {.anchor = "end", .size = 12.0}) +
           "<g clip-path=\"url(#" + clip + ")\">\n";
    for (const auto& area : figure.moments[k].areas) out += draw_area(area, at);
    for (const auto& line : figure.moments[k].lines) out += draw_line(line, at);
    out += "</g>\n</g>\n";
  }
  return out;
}

std::string draw_scale(const ColourScale& scale, const Layout& at) {
  const double x = at.right + 22.0, height = at.bottom - at.top;
  const int steps = scale.steps;
  std::string out;
  for (int i = 0; i < steps; ++i) {
    const double y = at.bottom - (i + 1) * height / steps;
    out += "<rect" + attribute("x", x) + attribute("y", y) + attribute("width", 14.0) +
           attribute("height", height / steps + 0.5) + " fill=\"" + scale_colour((i + 0.5) / steps) + "\"/>\n";
  }
  const Range range = widened(scale.range);
  const Ticks ticks = nice_ticks(range.low, range.high, 5);
  for (std::size_t i = 0; i < ticks.values.size(); ++i) {
    const double y = at.bottom - (ticks.values[i] - range.low) / range.width() * height;
    out += text_at(x + 20.0, y + 4.0, ticks.labels[i], {.size = 12.0});
  }
  return out +
         text_at(width - 4.0, at.top - 8.0, with_power(scale.label, ticks.exponent), {.anchor = "end", .size = 12.5});
}

Layout lay_out(const Figure& figure, std::vector<LegendEntry>& legend) {
  Layout at;
  if (figure.scale || figure.aspect) at.right = width - 92.0;
  at.top = lay_out_legend(figure, at.right, legend);
  at.bottom = at.top + (figure.aspect ? (at.right - left) / *figure.aspect : plot_height);
  at.x = figure.x_range ? widened(*figure.x_range) : range_of(figure.lines, true, {});
  at.y = figure.y_range ? widened(*figure.y_range) : range_of(figure.lines, false, figure.x_range);
  if (figure.y_from_zero) at.y = widened({std::min(at.y.low, 0.0), std::max(at.y.high, 0.0)});
  if (!figure.exact_ranges) at.y = rounded_out(at.y);
  at.y_down = figure.y_down;
  return at;
}

}  // namespace

std::string svg(const Figure& figure) {
  std::vector<LegendEntry> legend;
  const Layout at = lay_out(figure, legend);
  std::string out = svg_open(at.bottom + bottom_space);
  out += text_at(left, 22.0, figure.title, {.size = 15.0, .bold = true});
  out += draw_legend(legend) + draw_axes(figure, at);
  const std::string clip = "clip-" + figure.id;
  const double beyond = figure.exact_ranges ? 0.0 : 4.0;  // a thick line along the frame stays whole
  out += "<clipPath id=\"" + clip + "\"><rect" + attribute("x", left - beyond) + attribute("y", at.top - beyond) +
         attribute("width", at.right - left + 2.0 * beyond) + attribute("height", at.bottom - at.top + 2.0 * beyond) +
         "/></clipPath>\n";
  out += "<g clip-path=\"url(#" + clip + ")\">\n";
  for (const auto& area : figure.areas) out += draw_area(area, at);
  for (const auto& line : figure.lines) out += draw_line(thinned(line, 1600), at);
  out += "</g>\n";
  out += draw_moments(figure, at, clip);
  if (figure.scale) out += draw_scale(*figure.scale, at);
  return out + "</svg>\n";
}

std::string svg_row(const std::vector<Figure>& figures) {
  std::string inside;
  double x = 0.0, tallest = 0.0;
  for (const auto& figure : figures) {
    std::vector<LegendEntry> legend;
    const double height = lay_out(figure, legend).bottom + bottom_space;
    tallest = std::max(tallest, height);
    const std::string place = attribute("x", x) + attribute("width", width) + attribute("height", height);
    inside += "<svg" + place + svg(figure).substr(4);
    x += width;
  }
  return svg_open(tallest, x) + inside + "</svg>\n";
}

std::string svg_bars(const std::vector<Bar>& bars) {
  double largest = 0.0, labels = 60.0;
  for (const auto& bar : bars) {
    largest = std::max(largest, bar.value);
    labels = std::max(labels, text_width(bar.label, 13.0));
  }
  const double start = labels + 16.0, room = width - start - 150.0;
  std::string out = svg_open(26.0 * static_cast<double>(bars.size()) + 8.0);
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const double y = 4.0 + 26.0 * static_cast<double>(i);
    const double length = largest > 0.0 ? std::max(1.0, room * bars[i].value / largest) : 1.0;
    out += text_at(start - 8.0, y + 17.0, bars[i].label, {.anchor = "end"});
    out += "<rect" + attribute("x", start) + attribute("y", y + 4.0) + attribute("width", length) +
           attribute("height", 17.0) + " fill=\"" + line_colour(0) + "\"/>\n";
    out += text_at(start + length + 8.0, y + 17.0, bars[i].text, {.size = 12.5});
  }
  return out + "</svg>\n";
}

}  // namespace reye::output
