#pragma once
#include <cmath>

/// Wear laws: from pressure, shear and slip to removed volume, and the book that is kept of it.
namespace reye::wear {

/// none: no wear. energy: removed volume = alpha times frictional work. archard: = k times pressure times slip.
enum class LawKind { none, energy, archard };

/// A wear law of one contact with the coefficient of each side in consistent units:
/// energy alpha [mm^2/N] = 1e-3 * alpha [mm^3/J]; archard k [1/MPa] = [mm^2/N].
struct Law {
  LawKind kind = LawKind::none;
  double secondary = 0.0;
  double primary = 0.0;

  bool wears() const { return kind != LawKind::none && (secondary > 0.0 || primary > 0.0); }
};

/// What a node's slip does to the surface, before the coefficient: frictional work |lambda_t slip| (energy)
/// or |lambda_n slip| (archard). lambda [MPa], weighted slip [mm^2 per mm] give [mJ per mm].
template <class T>
T work(const Law& law, const T& lambda_n, const T& lambda_t, const T& weighted_slip) {
  using std::abs;
  if (law.kind == LawKind::none) return T(0.0);
  return abs((law.kind == LawKind::energy ? lambda_t : lambda_n) * weighted_slip);
}

/// The book of one contact: what the law's work ought to remove against what was removed.
struct Ledger {
  double work = 0.0;               ///< sum of the law's work over increments and nodes, times the cycle jump
  double removed_secondary = 0.0;  ///< removed by shape steps as strips, plus what still waits in the gap
  double removed_primary = 0.0;

  /// |removed - sum of coefficient x work| / sum; 0 while nothing was worn.
  double relative_error(const Law& law) const;
};

}  // namespace reye::wear
