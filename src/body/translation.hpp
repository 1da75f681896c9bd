#pragma once
#include "base/two_part.hpp"

namespace reye::body {

using base::Matrix;
using base::TwoPart;
using base::Vec2;
using base::Vector;

/// How the columns q of a body hold its rigid translation: q = T a + v. S T = 0, but computed S T a is a rounding
/// error, which hides equilibrium where a stiff body moves far under a small force. Without T a only S v is rounded.
/// The same of the columns [y; q] of a nonlinear body and its stress.   [README (8)]
class Translation {
 public:
  Translation() = default;
  /// T, one row per column of q: its value when the body moves by one along x, along y; zero where that is not rigid.
  explicit Translation(const Matrix& T);
  Translation part(const std::vector<int>& columns) const;

  /// a: the mean motion, by which v is least.
  Vec2 of(const Vector& q) const;
  /// v = q - T a, rounded once.
  Vector without(const Vec2& a, const TwoPart& q) const;
  Vector without(const TwoPart& q) const;
  /// T a + v
  TwoPart with(const Vec2& a, const Vector& v) const;

 private:
  base::ExactSum moved(Eigen::Index column, const Vec2& a) const;

  Matrix T_;
  Matrix mean_;  ///< pseudo-inverse of T
};

}  // namespace reye::body
