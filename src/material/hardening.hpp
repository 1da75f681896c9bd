#pragma once
#include <algorithm>
#include <cmath>

#include "base/dual.hpp"
#include "material/material.hpp"

/// Yield stress sigma_y(p) [MPa] over accumulated plastic strain p >= 0; a dual p carries the slope.
namespace reye::material {

template <class T>
T yield_stress(const LinearHardening& h, const T& p) {
  return p * h.modulus_MPa + h.yield_MPa;
}

template <class T>
T yield_stress(const VoceHardening& h, const T& p) {
  using std::exp;
  return p * h.modulus_MPa + h.yield_MPa + (1.0 - exp(p * (-h.rate))) * (h.saturation_MPa - h.yield_MPa);
}

template <class T>
T yield_stress(const SwiftHardening& h, const T& p) {
  using std::exp, std::log;
  return exp(log(p + h.offset) * h.exponent) * h.strength_MPa;
}

/// At a corner the slope is that to its right: loading continues.
template <class T>
T yield_stress(const TableHardening& h, const T& p) {
  const auto beyond = [](double x, const std::array<double, 2>& point) { return x < point[0]; };
  const auto right = std::upper_bound(h.points.begin(), h.points.end(), base::value(p), beyond);
  if (right == h.points.end()) return T(h.points.back()[1]);
  if (right == h.points.begin()) return T(h.points.front()[1]);
  const auto& [p0, y0] = *(right - 1);
  const auto& [p1, y1] = *right;
  return (p - p0) * ((y1 - y0) / (p1 - p0)) + y0;
}

template <class T>
T yield_stress(const Hardening& hardening, const T& p) {
  return std::visit([&](const auto& h) { return yield_stress(h, p); }, hardening);
}

}  // namespace reye::material
