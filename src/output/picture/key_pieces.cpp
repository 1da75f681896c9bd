#include "output/picture/key_pieces.hpp"

#include <algorithm>
#include <sstream>

#include "base/formatted.hpp"
#include "output/folder/text.hpp"
#include "output/picture/canvas.hpp"

namespace reye::output {

namespace {

/// A history as a small curve between its least and largest factor.
std::string small_curve(const std::string& name, const scene::History& history, const Vec2& at) {
  constexpr double w = 190.0, h = 44.0;
  double least = 0.0, most = 0.0;
  for (const auto& corner : history) {
    least = std::min(least, corner[1]);
    most = std::max(most, corner[1]);
  }
  const double range = most > least ? most - least : 1.0;
  std::string path;
  for (const auto& corner : history)
    path += base::formatted("%c%.1f %.1f", path.empty() ? 'M' : 'L', at.x() + w * corner[0],
                            at.y() + h * (most - corner[1]) / range);
  const double zero = at.y() + h * most / range;
  return base::formatted("<path d=\"M%.1f %.1fh%g\" stroke=\"#d9dde2\"/>", at.x(), zero, w) + "<path d=\"" + path +
         "\" fill=\"none\" stroke=\"#1f5fa8\" stroke-width=\"1.4\"/>" +
         base::formatted("<text x=\"%.1f\" y=\"%.1f\" font-size=\"12\" fill=\"#2b2f36\">", at.x(), at.y() - 6.0) +
         escaped(name + ", from " + rounded(least) + " to " + rounded(most)) + "</text>\n";
}

}  // namespace

std::string key_text(double x, double y, const std::string& words, const char* colour) {
  return base::formatted("<text x=\"%.1f\" y=\"%.1f\" font-size=\"13\" fill=\"%s\">", x, y, colour) + escaped(words) +
         "</text>\n";
}

std::string key_lines(double x, double& y, const std::string& words, double line_height) {
  constexpr double width_of_a_character = 6.6, indent = 14.0, margin = 20.0;
  std::string svg, line;
  double left = x;
  const auto end_line = [&] {
    svg += key_text(left, y, line);
    y += line_height;
    left = x + indent;
    line.clear();
  };
  std::istringstream stream(words);
  for (std::string word; stream >> word;) {
    const auto letters = static_cast<double>(line.size() + 1 + word.size());
    if (!line.empty() && left + width_of_a_character * letters > picture_width - margin) end_line();
    line += (line.empty() ? "" : " ") + word;
  }
  end_line();
  return svg;
}

std::string history_curves(const std::map<std::string, scene::History>& histories, double left, double& y) {
  constexpr double step = 260.0, row = 84.0;
  constexpr std::size_t columns = 4;
  std::string svg;
  std::size_t column = 0;
  for (const auto& [name, history] : histories) {
    svg += small_curve(name, history, {left + step * static_cast<double>(column), y});
    if (++column < columns) continue;
    column = 0;
    y += row;
  }
  if (column > 0) y += row;
  return svg;
}

std::string whole_picture(const std::string& title, double left, const std::string& content, double height) {
  return base::formatted(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %g %.0f\" font-family=\"Helvetica, Arial, "
             "DejaVu Sans, sans-serif\">\n<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n",
             picture_width, height) +
         base::formatted("<text x=\"%g\" y=\"28\" font-size=\"18\" font-weight=\"bold\" fill=\"#2b2f36\">", left) +
         escaped(title) + "</text>\n" + content + "</svg>\n";
}

}  // namespace reye::output
