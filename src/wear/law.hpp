#pragma once

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

}  // namespace reye::wear
