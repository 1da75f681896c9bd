#include "body/imposed.hpp"

#include <algorithm>
#include <cmath>

namespace reye::body {

void add(Imposed& to, const Motion& motion, double weight) {
  if (motion.drive != Drive::moved) return;
  for (const auto& part : motion.parts) to[part.history] += weight * part.value;
}

void add(Imposed& to, const Imposed& other, double weight) {
  for (const auto& [history, amplitude] : other) to[history] += weight * amplitude;
}

bool same(const Imposed& a, const Imposed& b) {
  double scale = 0.0;
  for (const auto& value : {a, b})
    for (const auto& [history, amplitude] : value) scale = std::max(scale, std::abs(amplitude));
  Imposed difference = a;
  add(difference, b, -1.0);
  return std::all_of(difference.begin(), difference.end(),
                     [&](const auto& part) { return std::abs(part.second) <= 1e-12 * scale; });
}

}  // namespace reye::body
