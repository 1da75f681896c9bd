#pragma once
#include "support/surfaces.hpp"

/// Straight sides that touch.
namespace reye::support {

inline FacingOptions straight(int secondary, int primary, double from = 0.0, double to = 1.0) {
  FacingOptions o;
  o.secondary = secondary;
  o.primary = primary;
  o.bend = o.jitter = o.gap = o.strain = 0.0;
  o.from = from;
  o.to = to;
  return o;
}

}  // namespace reye::support
