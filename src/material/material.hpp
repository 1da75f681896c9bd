#pragma once
#include <array>
#include <variant>
#include <vector>

namespace reye::material {

/// Isotropic linear elasticity: sigma = lambda tr(eps) I + 2 mu eps. Small strain only.
struct LinearElastic {
  double E_MPa = 0.0;
  double nu = 0.0;  ///< in (-1, 0.5)
};

/// S = lambda tr(E) I + 2 mu E on the Green-Lagrange strain E. Softens without bound in strong compression.
struct StVenantKirchhoff {
  double E_MPa = 0.0;
  double nu = 0.0;
};

/// Volumetric part of the compressible neo-Hookean energies psi = mu/2 (I1 - 3 - 2 ln J) + U(J):
///   log_squared  U = lambda/2 (ln J)^2
///   quadratic    U = lambda/2 (J - 1)^2
///   mixed        U = lambda/4 (J^2 - 1 - 2 ln J)
///   power        psi = c (I1 - 3) + c/beta (J^(-2 beta) - 1), c = mu/2, beta = nu/(1 - 2 nu), in place of both parts
enum class Volumetric { log_squared, quadratic, mixed, power };

struct NeoHookean {
  double E_MPa = 0.0;
  double nu = 0.0;
  Volumetric volumetric = Volumetric::log_squared;
};

/// tau = lambda tr(eps) I + 2 mu eps on the logarithmic strain eps = 1/2 ln b; or sigma, which has no energy.
struct Hencky {
  double E_MPa = 0.0;
  double nu = 0.0;
  bool cauchy = false;  ///< the law gives sigma
};

/// Yield stress over accumulated plastic strain p [MPa].
struct LinearHardening {
  double yield_MPa = 0.0;
  double modulus_MPa = 0.0;  ///< sigma_y = yield + modulus p
};
struct VoceHardening {
  double yield_MPa = 0.0, saturation_MPa = 0.0, rate = 0.0, modulus_MPa = 0.0;
  ///< sigma_y = yield + modulus p + (saturation - yield)(1 - exp(-rate p))
};
struct SwiftHardening {
  double strength_MPa = 0.0, offset = 0.0, exponent = 0.0;  ///< sigma_y = strength (offset + p)^exponent
};
/// Piecewise linear; constant beyond the last point.
struct TableHardening {
  std::vector<std::array<double, 2>> points;  ///< [p, sigma_y], p increasing from 0
};
using Hardening = std::variant<LinearHardening, VoceHardening, SwiftHardening, TableHardening>;

/// J2 plasticity with isotropic hardening: Hencky elasticity and multiplicative split at finite strain, Hooke's law
/// and additive split at small strain.
struct HenckyJ2 {
  double E_MPa = 0.0;
  double nu = 0.0;
  Hardening hardening;
};

using Material = std::variant<LinearElastic, StVenantKirchhoff, NeoHookean, Hencky, HenckyJ2>;

/// The history of a plastic material point, at either kinematics: the plastic strain as tensor components
/// (11, 22, 12, 33), at finite strain of E_p = 1/2 ln C_p on X. Plastic flow leaves its trace zero; a trace comes only
/// from a transfer to another mesh (elastic_part.hpp).
struct PlasticState {
  std::array<double, 4> strain{};
  double accumulated = 0.0;  ///< p >= 0
};

}  // namespace reye::material
