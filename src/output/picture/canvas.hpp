#pragma once
#include <string>
#include <vector>

#include "base/linalg.hpp"

/// Drawing in millimetres onto a field of an SVG picture.
namespace reye::output {

using base::Points;
using base::Vec2;

/// A rectangle, in mm or in pixels.
struct Box {
  Vec2 low{0.0, 0.0}, high{0.0, 0.0};
  Vec2 size() const { return high - low; }
  bool holds(const Vec2& x) const {
    return x.x() >= low.x() && x.x() <= high.x() && x.y() >= low.y() && x.y() <= high.y();
  }
};

/// The box about some points.
Box box_of(const Points& points);

/// A field of a picture that shows a part of the plane, as much of it as fills the field at equal scales.
class Canvas {
 public:
  /// `field`: its pixels, y downwards; `shown`: what must be seen [mm].
  Canvas(const Box& field, const Box& shown);

  const Box& field() const { return field_; }
  const Box& seen() const { return seen_; }  ///< what is seen [mm]
  Vec2 pixel(const Vec2& mm) const;
  double pixels_per_mm() const { return scale_; }

  /// Adds a filled area bounded by closed loops.
  void area(const std::vector<Points>& loops, const std::string& colour);
  /// Adds a line; `dashes` as SVG writes them, empty: solid.
  void line(const Points& x, const std::string& colour, double width, const std::string& dashes = {});
  /// Adds short straight lines as one.
  void edges(const std::vector<std::pair<Vec2, Vec2>>& all, const std::string& colour, double width);
  /// Adds a letter in a circle, at some pixels from a place.
  void mark(const Vec2& mm, const Vec2& aside, const std::string& letter, const std::string& colour);
  /// Adds an arrow of so many pixels that ends (or begins) at a place; with two heads it goes both ways.
  void arrow(const Vec2& mm, const Vec2& pixels, bool both, const std::string& colour);
  /// Adds a text beside a place.
  void note(const Vec2& mm, const std::string& text, const std::string& colour);
  /// Adds axes with round marks, in mm.
  void axes(const std::string& title);

  /// The field as SVG; `id` is that of its clip path.
  std::string svg(const std::string& id) const;

 private:
  std::string path(const Points& x) const;

  Box field_, seen_;
  double scale_ = 1.0;
  std::string inside_, outside_;  ///< cut off at the field, and not
};

}  // namespace reye::output
