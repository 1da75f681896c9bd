#include "output/picture/canvas.hpp"

#include <algorithm>

#include "base/formatted.hpp"
#include "output/folder/text.hpp"
#include "output/picture/ticks.hpp"

namespace reye::output {

Box box_of(const Points& points) {
  Box box{points.front(), points.front()};
  for (const Vec2& x : points) {
    box.low = box.low.cwiseMin(x);
    box.high = box.high.cwiseMax(x);
  }
  return box;
}

Canvas::Canvas(const Box& field, const Box& shown) : field_(field) {
  constexpr double margin = 1.08;
  const Vec2 size = (margin * shown.size()).cwiseMax(1e-12), middle = 0.5 * (shown.low + shown.high);
  scale_ = std::min(field.size().x() / size.x(), field.size().y() / size.y());
  const Vec2 half = 0.5 / scale_ * field.size();
  seen_ = {middle - half, middle + half};
}

Vec2 Canvas::pixel(const Vec2& mm) const {
  return {field_.low.x() + scale_ * (mm.x() - seen_.low.x()), field_.high.y() - scale_ * (mm.y() - seen_.low.y())};
}

std::string Canvas::path(const Points& x) const {
  std::string text;
  for (const Vec2& point : x) {
    const Vec2 p = pixel(point);
    text += text.empty() ? 'M' : 'L';
    base::append_tenths(p.x(), text);
    text += ' ';
    base::append_tenths(p.y(), text);
  }
  return text;
}

void Canvas::area(const std::vector<Points>& loops, const std::string& colour) {
  std::string all;
  for (const auto& loop : loops) all += path(loop) + 'Z';
  inside_ += "<path d=\"" + all + "\" fill=\"" + colour +
             "\" fill-rule=\"evenodd\" stroke=\"#4a5058\" stroke-width=\"0.9\"/>\n";
}

void Canvas::line(const Points& x, const std::string& colour, double width, const std::string& dashes) {
  inside_ += "<path d=\"" + path(x) + "\" fill=\"none\" stroke=\"" + colour +
             base::formatted("\" stroke-width=\"%g\"", width) +
             (dashes.empty() ? "" : " stroke-dasharray=\"" + dashes + '"') + "/>\n";
}

void Canvas::edges(const std::vector<std::pair<Vec2, Vec2>>& all, const std::string& colour, double width) {
  std::string text;
  for (const auto& [a, b] : all) text += path({a, b});
  inside_ += "<path d=\"" + text + "\" fill=\"none\" stroke=\"" + colour +
             base::formatted("\" stroke-width=\"%g\"/>\n", width);
}

void Canvas::mark(const Vec2& mm, const Vec2& aside, const std::string& letter, const std::string& colour) {
  constexpr double radius = 9.0;
  const Vec2 at = pixel(mm), inner(radius + 1.0, radius + 1.0);
  const Vec2 p = (at + aside).cwiseMax(field_.low + inner).cwiseMin(field_.high - inner);
  outside_ += base::formatted(
      "<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"%s\"/><circle cx=\"%.1f\" cy=\"%.1f\" r=\"%g\" fill=\"#fff\" "
      "stroke=\"%s\" stroke-width=\"1.4\"/><text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\" font-size=\"11\" "
      "font-weight=\"bold\" fill=\"%s\">%s</text>\n",
      at.x(), at.y(), p.x(), p.y(), colour.c_str(), p.x(), p.y(), radius, colour.c_str(), p.x(), p.y() + 4.0,
      colour.c_str(), letter.c_str());
}

void Canvas::arrow(const Vec2& mm, const Vec2& pixels, bool both, const std::string& colour) {
  const Vec2 tip = pixel(mm) + (both ? Vec2(0.5 * pixels) : Vec2(Vec2::Zero())), tail = tip - pixels;
  const Vec2 along = pixels.normalized(), across(-along.y(), along.x());
  const auto head = [&](const Vec2& at, const Vec2& back) {
    const Vec2 a = at + 8.0 * back + 3.5 * across, b = at + 8.0 * back - 3.5 * across;
    outside_ += base::formatted("<path d=\"M%.1f %.1fL%.1f %.1fL%.1f %.1fZ\" fill=\"%s\"/>", at.x(), at.y(), a.x(),
                                a.y(), b.x(), b.y(), colour.c_str());
  };
  outside_ += base::formatted("<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"%s\" stroke-width=\"2\"/>", tail.x(), tail.y(),
                              tip.x(), tip.y(), colour.c_str());
  head(tip, -along);
  if (both) head(tail, along);
  outside_ += '\n';
}

void Canvas::note(const Vec2& mm, const std::string& text, const std::string& colour) {
  const Vec2 p = pixel(mm);
  const bool left = p.x() > 0.5 * (field_.low.x() + field_.high.x());
  outside_ +=
      base::formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"none\" stroke=\"%s\" stroke-width=\"1.5\"/>",
                      p.x(), p.y(), colour.c_str());
  outside_ += base::formatted(
                  "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" font-size=\"12\" fill=\"%s\" stroke=\"#fff\" "
                  "stroke-width=\"3\" paint-order=\"stroke\">",
                  p.x() + (left ? -8.0 : 8.0), p.y() - 7.0, left ? "end" : "start", colour.c_str()) +
              escaped(text) + "</text>\n";
}

void Canvas::axes(const std::string& title) {
  const auto marks = [&](int axis, auto draw) {
    for (const double x : nice_ticks(seen_.low[axis], seen_.high[axis]).values) draw(x);
  };
  marks(0, [&](double x) {
    const double p = pixel({x, 0.0}).x();
    outside_ += base::formatted(
        "<path d=\"M%.1f %.1fv5\" stroke=\"#6a717c\"/><text x=\"%.1f\" y=\"%.1f\" "
        "text-anchor=\"middle\" font-size=\"11\" fill=\"#6a717c\">%.6g</text>\n",
        p, field_.high.y(), p, field_.high.y() + 16.0, x);
  });
  marks(1, [&](double y) {
    const double p = pixel({0.0, y}).y();
    outside_ += base::formatted(
        "<path d=\"M%.1f %.1fh-5\" stroke=\"#6a717c\"/><text x=\"%.1f\" y=\"%.1f\" "
        "text-anchor=\"end\" font-size=\"11\" fill=\"#6a717c\">%.6g</text>\n",
        field_.low.x(), p, field_.low.x() - 7.0, p + 4.0, y);
  });
  outside_ += base::formatted("<text x=\"%.1f\" y=\"%.1f\" font-size=\"13\" font-weight=\"bold\" fill=\"#2b2f36\">",
                              field_.low.x(), field_.low.y() - 8.0) +
              escaped(title) + "</text>\n";
}

std::string Canvas::svg(const std::string& id) const {
  const std::string box = base::formatted("x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"", field_.low.x(),
                                          field_.low.y(), field_.size().x(), field_.size().y());
  return "<clipPath id=\"" + id + "\"><rect " + box + "/></clipPath>\n<g clip-path=\"url(#" + id + ")\">\n" + inside_ +
         "</g>\n<rect " + box + " fill=\"none\" stroke=\"#b6bcc4\"/>\n" + outside_;
}

}  // namespace reye::output
