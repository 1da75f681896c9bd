#pragma once
#include <string>
#include <vector>

namespace reye::output {

/// Marks of an axis: round values (1, 2 or 5 times a power of ten) inside [low, high] and their labels.
/// Labels carry the value divided by 10^exponent; exponent is 0 unless the values are very large or small.
struct Ticks {
  std::vector<double> values;
  std::vector<std::string> labels;
  int exponent = 0;
};

/// About `target` ticks, never fewer than two. A range without width is widened first, as in `widened`.
Ticks nice_ticks(double low, double high, int target = 6);

struct Range {
  double low = 0.0, high = 1.0;
  double width() const { return high - low; }
};

/// The range itself, or one about its value when it has no width, or [0, 1] when it is not finite.
Range widened(Range range);

/// The range grown outwards to whole tick steps.
Range rounded_out(Range range, int target = 6);

}  // namespace reye::output
