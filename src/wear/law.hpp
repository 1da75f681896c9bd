#pragma once
#include <cmath>

#include "base/dual.hpp"

/// Wear laws: from pressure, shear and slip to removed volume, and the ledger that is kept of it.
namespace reye::wear {

/// none: no wear. energy: removed volume = alpha times frictional work. archard: = k times pressure times slip.
enum class LawKind { none, energy, archard };

/// A wear law of one contact with the coefficient of each side in consistent units:
/// energy alpha [mm^2/N] = 1e-3 * alpha [mm^3/J]; archard k [1/MPa] = [mm^2/N].
struct Law {
  LawKind kind = LawKind::none;
  double secondary = 0.0;
  double primary = 0.0;
  // The rate times (p / p_ref)^m (v / v_ref)^n; exponents > -1, an exponent of 0 leaves its factor out.
  double pressure_exponent = 0.0;
  double pressure_ref = 1.0;  ///< MPa
  double speed_exponent = 0.0;
  double speed_ref = 1.0;  ///< mm/s
  double threshold = 0.0;  ///< energy law: energy per area that must be dissipated at a node before it wears [mJ/mm^2]

  bool wears() const { return kind != LawKind::none && (secondary > 0.0 || primary > 0.0); }
};

/// A slipping secondary node in one increment, in scalars, whatever the dimension and the direction.
template <class T>
struct Sliding {
  T pressure{};  ///< MPa
  T friction{};  ///< work of the traction along the slip, not negative [mJ per mm]
  T distance{};  ///< of the slip, weighted by the covered length, not negative [mm^2 per mm]
  T covered{};   ///< length: slip = distance / covered [mm]
};

/// Sliding along a line, with the signs of shear [MPa] and weighted slip [mm^2 per mm].
template <class T>
Sliding<T> along_a_line(const T& pressure, const T& shear, const T& slip, const T& covered) {
  using std::abs;
  return {pressure, abs(shear * slip), abs(slip), covered};
}

/// The work of the slip before the coefficient, without exponents and threshold: frictional work (energy) or
/// |pressure distance| (archard) [mJ per mm]. A node that just closed, at zero pressure, wears with the pressure that
/// comes, whichever way it slides.
template <class T>
T plain_work(const Law& law, const Sliding<T>& s) {
  using std::abs;
  if (law.kind == LawKind::none) return T(0.0);
  return law.kind == LawKind::energy ? s.friction : abs(s.pressure * s.distance);
}

/// Further data of a node that the laws need, fixed while the equations of one increment are solved.
struct Start {
  double jump = 1.0;        ///< cycles that the increment stands for
  double duration_s = 0.0;  ///< of the increment in each of them; read where the law has a speed exponent only
  double energy = 0.0;      ///< dissipated at the node before this increment, since the start [mJ per mm]
  double area = 0.0;        ///< full nodal length on X [mm]
};

/// ratio^exponent. Below 1e-6 the ratio is taken as 1e-6: traction times the factor still falls to zero, its slope
/// stays finite.
template <class T>
T power(const T& ratio, double exponent) {
  using std::exp, std::log;
  constexpr double least = 1e-6;
  return exp(exponent * log(base::value(ratio) > least ? ratio : T(least)));
}

/// The part of the work that the node does beyond the threshold: max(0, E + jump work - E_th) - max(0, E - E_th),
/// over the jump, E_th = threshold x area.
template <class T>
T beyond_threshold(double threshold, const Start& start, const T& work) {
  const double lacking = threshold * start.area - start.energy;
  if (lacking <= 0.0) return work;
  const T beyond = work - lacking / start.jump;
  return base::value(beyond) > 0.0 ? beyond : T(0.0);
}

/// The work of the whole law at a node in one cycle: removed volume = coefficient x jump x work.    [README (1)]
/// Without exponents and threshold bit by bit the plain work.
template <class T>
T work(const Law& law, const Sliding<T>& s, const Start& start) {
  T w = plain_work(law, s);
  if (law.kind == LawKind::none) return w;
  if (law.threshold > 0.0) w = beyond_threshold(law.threshold, start, w);
  if (law.pressure_exponent != 0.0) w *= power(s.pressure / law.pressure_ref, law.pressure_exponent);
  if (law.speed_exponent != 0.0)
    w *= power(s.distance / (start.duration_s * law.speed_ref * s.covered), law.speed_exponent);
  return w;
}

/// The ledger of one contact: the volume that the law's work should remove beside the volume that was removed.
struct Ledger {
  double work = 0.0;               ///< sum of the law's work over increments and nodes, times the cycle jump
  double removed_secondary = 0.0;  ///< removed by shape steps as strips, plus what still waits in the gap
  double removed_primary = 0.0;

  /// |removed - sum of coefficient x work| / sum; 0 while nothing was worn.
  double relative_error(const Law& law) const;
};

}  // namespace reye::wear
