#pragma once

namespace reye::verification {

/// geo/column (references B6): a confined column under fixed compression, K = M / H, wear kept in the gap: mm and MPa.
struct Column {
  static constexpr double M = 2e5 * 0.7 / (1.3 * 0.4), K = M / 10.0, compression = 0.01;
  static constexpr double k = 1e-7;  ///< of Archard's law [1/MPa]
};

}  // namespace reye::verification
