#pragma once
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "material/finite.hpp"

/// What the tests of materials share: the laws by name, small tensor algebra, the rate of a linearisation.
namespace reye::material::test {

inline constexpr double E = 200e3, nu = 0.3;
inline const double mu = E / (2 * (1 + nu)), lambda = E * nu / ((1 + nu) * (1 - 2 * nu));

struct Named {
  std::string name;
  Material material;
};
inline void PrintTo(const Named& law, std::ostream* out) { *out << law.name; }
inline std::string name_of(const testing::TestParamInfo<Named>& info) { return info.param.name; }

inline std::vector<Named> neo_hookean_laws() {
  return {{"neo_hookean_log_squared", NeoHookean{E, nu, Volumetric::log_squared}},
          {"neo_hookean_quadratic", NeoHookean{E, nu, Volumetric::quadratic}},
          {"neo_hookean_mixed", NeoHookean{E, nu, Volumetric::mixed}},
          {"neo_hookean_power", NeoHookean{E, nu, Volumetric::power}}};
}
inline std::vector<Named> hyperelastic_laws() {
  auto laws = neo_hookean_laws();
  laws.push_back({"st_venant_kirchhoff", StVenantKirchhoff{E, nu}});
  laws.push_back({"hencky", Hencky{E, nu}});
  return laws;
}
inline std::vector<Named> plastic_laws() {
  const TableHardening table{{{0.0, 300.0}, {0.02, 310.0}, {0.1, 450.0}, {0.6, 600.0}}};  // a plateau, then a rise
  return {{"linear", HenckyJ2{E, nu, LinearHardening{300, 1000}}},
          {"voce", HenckyJ2{E, nu, VoceHardening{300, 500, 16, 130}}},
          {"swift", HenckyJ2{E, nu, SwiftHardening{700, 2e-3, 0.2}}},
          {"table", HenckyJ2{E, nu, table}}};
}
inline std::vector<Named> finite_laws() {
  auto laws = hyperelastic_laws();
  for (auto& law : plastic_laws()) laws.push_back({"j2_" + law.name, law.material});
  return laws;
}

using Tensor = Eigen::Matrix3d;

inline Tensor tensor(const Gradient<double>& F) {
  Tensor A;
  A << F[0], F[1], 0, F[2], F[3], 0, 0, 0, F[4];
  return A;
}
inline Tensor tensor(const Symmetric<double>& A) { return tensor(Gradient<double>{A[0], A[2], A[2], A[1], A[3]}); }
inline Gradient<double> gradient(const Tensor& A) { return {A(0, 0), A(0, 1), A(1, 0), A(1, 1), A(2, 2)}; }
inline Symmetric<double> symmetric(const Tensor& A) { return {A(0, 0), A(1, 1), 0.5 * (A(0, 1) + A(1, 0)), A(2, 2)}; }
/// In the plane, by an angle [rad].
inline Tensor rotation(double angle) {
  return tensor(Gradient<double>{std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle), 1.0});
}

inline double equivalent(const Voigt<double>& stress) {
  const Tensor s = tensor(stress) - tensor(stress).trace() / 3 * Tensor::Identity();
  return std::sqrt(1.5) * s.norm();
}

inline constexpr std::array analyses{base::Analysis::plane_strain, base::Analysis::axisymmetric,
                                     base::Analysis::plane_stress};

/// Plastic loading in two steps that share no axes: a state with history, its F and a next F.
struct Loaded {
  PlasticState state;
  Gradient<double> F, next;
};
inline Loaded loaded(const Material& material, base::Analysis analysis) {
  Loaded result{.state = {}, .F = {1.02, 0.03, -0.02, 0.99, 1.01}, .next = {1.05, 0.11, -0.04, 0.93, 1.04}};
  kirchhoff(material, analysis, result.F, PlasticState{}, &result.state);
  return result;
}

/// Rate at which f(x + h d) - f(x) - h f'(x) d falls, h from 1e-4 to 1e-5; f is templated over its scalar.
template <std::size_t n, class F>
double linearisation_rate(const F& f, const std::array<double, n>& x, const std::array<double, n>& d) {
  std::array<base::Dual<1>, n> dual;
  for (std::size_t i = 0; i < n; ++i) dual[i].v = x[i], dual[i].d[0] = d[i];
  const auto at_x = f(dual);
  const auto remainder = [&](double h) {
    auto y = x;
    for (std::size_t i = 0; i < n; ++i) y[i] += h * d[i];
    const auto at_y = f(y);
    double square = 0.0;
    for (std::size_t i = 0; i < at_y.size(); ++i) square += std::pow(at_y[i] - at_x[i].v - h * at_x[i].d[0], 2);
    return std::sqrt(square);
  };
  return std::log10(remainder(1e-4) / remainder(1e-5));
}

}  // namespace reye::material::test
