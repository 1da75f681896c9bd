#pragma once
#include <array>
#include <vector>

#include "base/linalg.hpp"

namespace reye::cad {

using base::Points;
using base::Vec2;

/// A line in the plane near which the mesh is fine. Within `depth` of the line, and not beyond its ends,
/// the size is `size`; with distance d from that strip it is size + (growth - 1) d, the linear law
/// under which neighbouring elements differ by the ratio `growth`.
struct SizeSource {
  Points line;
  double depth = 0.0;
  double size = 0.0;
  std::array<double, 4> box{};  ///< of the line, for a quick lower bound
};

template <class Archive>
void pass(Archive& archive, SizeSource& source) {
  archive(source.line), archive(source.depth), archive(source.size), archive(source.box);
}

SizeSource make_source(Points line, double depth, double size);

/// Wished element size over the plane [mm]: the smallest of the sources' laws and the far size.
class SizeField {
 public:
  SizeField(double far_size, double growth) : far_(far_size), slope_(growth - 1.0) {}
  void add(SizeSource source) { sources_.push_back(std::move(source)); }
  double operator()(const Vec2& p) const;

  /// Names the members for `Writer` and `Reader`.
  template <class Archive>
  friend void pass(Archive& archive, SizeField& field) {
    archive(field.far_), archive(field.slope_), archive(field.sources_);
  }

  double far_size() const { return far_; }
  double slope() const { return slope_; }

 private:
  double far_ = 1.0;
  double slope_ = 0.3;
  std::vector<SizeSource> sources_;
};

/// Elements a strip of the given length and depth with its graded surroundings will hold, up to far size:
/// int dA / size^2 over the strip and the half-stadiums around it.
double estimated_elements(double length, double depth, double size, double far_size, double growth);

}  // namespace reye::cad
