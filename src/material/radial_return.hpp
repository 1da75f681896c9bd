#pragma once
#include "material/hardening.hpp"
#include "material/local_newton.hpp"
#include "material/parameters.hpp"
#include "material/tensor.hpp"

/// Return mapping of J2 plasticity on a trial elastic strain, small or logarithmic.
namespace reye::material {

/// Stress, and the part of the trial strain that became plastic.
template <class T>
struct Returned {
  Symmetric<T> stress;
  Symmetric<double> plastic{};  ///< added to the plastic strain, taken from the elastic one
  double increment = 0.0;       ///< Delta p
};

/// Share theta = Delta p / e of the trial deviator that becomes plastic; e = sqrt(2/3) |dev| is its equivalent strain.
/// Delta p solves Delta p + sigma_y(p + Delta p) / (3 mu) = e.      (9)
template <class T>
T plastic_share(const HenckyJ2& m, const T& e, double p) {
  const double inverse = 1.0 / (3.0 * shear_modulus(m));
  const auto excess = [&](const auto& a, const auto& increment) {
    return increment + yield_stress(m.hardening, increment + p) * inverse - a[0];
  };
  const double guess = base::value(e) - yield_stress(m.hardening, p) * inverse;
  const Search search{.start = guess, .low = 0.0, .high = base::value(e)};
  return solved(excess, std::array<T, 1>{e}, search, "plastic increment for the equivalent trial strain") / e;
}

/// sigma = kappa tr(eps) I + 2 mu (1 - theta) dev(eps) for the trial elastic strain eps, tensor components
/// (11, 22, 12, 33), at accumulated plastic strain p; theta = 0 while 3 mu e <= sigma_y(p).      (8)
template <class T>
Returned<T> radial_return(const HenckyJ2& m, const Symmetric<T>& eps, double p) {
  using std::sqrt;
  const double mu = shear_modulus(m), yield = yield_stress(m.hardening, p);
  const T trace = eps[0] + eps[1] + eps[3], mean = trace * (1.0 / 3.0);
  const Symmetric<T> dev{eps[0] - mean, eps[1] - mean, eps[2], eps[3] - mean};
  const T square = (dev[0] * dev[0] + dev[1] * dev[1] + 2.0 * (dev[2] * dev[2]) + dev[3] * dev[3]) * (2.0 / 3.0);
  const T pressure = trace * bulk_modulus(m);
  // A state on the yield surface, up to round-off, is elastic.
  const bool plastic = 3.0 * mu * std::sqrt(base::value(square)) > yield * (1.0 + 1e-12);
  if (!plastic) return {.stress = combined(dev, T(2.0 * mu), pressure)};

  const T e = sqrt(square), share = plastic_share(m, e, p);
  Returned<T> result{.stress = combined(dev, T((1.0 - share) * (2.0 * mu)), pressure)};
  result.increment = base::value(share) * base::value(e);
  for (int i = 0; i < 4; ++i) result.plastic[i] = base::value(share) * base::value(dev[i]);
  return result;
}

}  // namespace reye::material
