#include "fem/frame.hpp"

#include <cmath>

namespace reye::fem {

base::Points in_frame(const base::Points& X, const base::Points& u, double angle) {
  if (angle == 0.0) return u;
  const double c = std::cos(angle), s = std::sin(angle);
  const Eigen::Matrix2d back{{c, s}, {-s, c}};
  base::Points w(u.size());
  for (std::size_t i = 0; i < u.size(); ++i) w[i] = back * (X[i] + u[i]) - X[i];
  return w;
}

std::array<double, 4> turned(const std::array<double, 4>& s, double angle) {
  const double c = std::cos(angle), d = std::sin(angle);
  return {c * c * s[0] + d * d * s[1] - 2.0 * c * d * s[2], d * d * s[0] + c * c * s[1] + 2.0 * c * d * s[2],
          c * d * (s[0] - s[1]) + (c * c - d * d) * s[2], s[3]};
}

}  // namespace reye::fem
