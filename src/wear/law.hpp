#pragma once
#include <cmath>

#include "base/dual.hpp"
#include "wear/growth.hpp"

/// Wear laws: from pressure, shear and slip to removed volume, and the ledger that is kept of it.
namespace reye::wear {

/// none: no wear. energy: removed volume = alpha times frictional work. archard: = k times pressure times slip. rate: =
/// depth per sliding distance times slip.
enum class LawKind { none, energy, archard, rate };

/// A wear law of one contact with the coefficient of each side in consistent units:
/// energy alpha [mm^2/N] = 1e-3 * alpha [mm^3/J]; archard k [1/MPa] = [mm^2/N]; rate [mm/mm].
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
  /// Where these are set, a coefficient is its number above, the unit of the formula, times the formula.
  Formula secondary_formula{}, primary_formula{};

  /// Whether its rate at a point depends on what has happened there before, as where a coating is worn through.
  bool has_memory() const { return threshold > 0.0 || secondary_formula || primary_formula; }
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

/// The work of the slip before the coefficient, without exponents and threshold: frictional work (energy),
/// |pressure distance| (archard) [mJ per mm], or distance (rate) [mm^2 per mm]. A node that just closed, at zero
/// pressure, wears with the pressure that comes, whichever way it slides.
template <class T>
T plain_work(const Law& law, const Sliding<T>& s) {
  using std::abs;
  if (law.kind == LawKind::none) return T(0.0);
  if (law.kind == LawKind::rate) return s.distance;
  return law.kind == LawKind::energy ? s.friction : abs(s.pressure * s.distance);
}

/// Further data of a node that the laws need, fixed while the equations of one increment are solved.
struct Start {
  double jump = 1.0;        ///< cycles that the increment stands for
  double duration_s = 0.0;  ///< of the increment in each of them; read where the law has a speed exponent only
  double energy = 0.0;      ///< dissipated at the node before this increment, since the start [mJ per mm]
  double area = 0.0;        ///< full nodal length on X [mm]
  // Read by formulas alone:
  double path = 0.0;  ///< of slip at the node, since the start [mm]
  double cycle = 0.0;
  double depth_secondary = 0.0, depth_primary = 0.0;  ///< worn since the start [mm]
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

/// The work of the whole law at a node in one cycle: removed volume = coefficient x jump x work.    [README (4)]
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

/// Volumes that a node's sliding removes from both sides in one increment, all its cycles together [mm^3 per mm].
template <class T>
struct Worn {
  T secondary{}, primary{};
};

/// The speed of the slip; zero where the step has no duration.
template <class T>
T speed(const Sliding<T>& s, const Start& start) {
  return start.duration_s > 0.0 ? s.distance / (start.duration_s * s.covered) : T(0.0);
}

/// Removed volume = coefficient x jump x work; with a formula, area x the growth of the depth.      [README (4), (6)]
template <class T>
Worn<T> worn(const Law& law, const Sliding<T>& s, const Start& start) {
  const T w = work(law, s, start);
  const auto side = [&](double coefficient, const Formula& formula, double depth) {
    if (!formula) return coefficient * start.jump * w;
    const Place place{.path = start.path, .depth = depth, .cycle = start.cycle};
    return start.area * growth(formula, coefficient, place, s.pressure, speed(s, start), T(start.jump / start.area * w),
                               T(start.jump * s.distance / s.covered));
  };
  return {side(law.secondary, law.secondary_formula, start.depth_secondary),
          side(law.primary, law.primary_formula, start.depth_primary)};
}

/// The ledger of one contact: the volume that the law asks for beside the volume that was removed [mm^3 per mm].
struct Ledger {
  double asked = 0.0;              ///< sum over increments and nodes, both sides
  double removed_secondary = 0.0;  ///< removed by shape steps as strips, plus what still waits in the gap
  double removed_primary = 0.0;

  /// |removed - asked| / asked; 0 while nothing was worn.
  double relative_error() const;
};

}  // namespace reye::wear
