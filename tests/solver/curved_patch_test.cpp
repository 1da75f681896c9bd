#include <gtest/gtest.h>

#include <limits>

#include "elastic.hpp"
#include "support/assembly.hpp"

namespace {

using namespace reye;
using base::Kinematics;
using mesh::CellKind;
using support::rubber;

constexpr double inner_pressure = 60.0;  ///< [MPa]

/// A quarter of a ring 1 < r < 2 in a ring 2 < r < 3, both under pressure from inside.
struct Rings {
  CellKind inner = CellKind::quad4, outer = CellKind::quad4;
  contact::DualOrder dual = contact::DualOrder::quadratic;
  Kinematics kinematics = Kinematics::small;
  bool inner_secondary = true;
};

/// Lame: the pressure at r = 2 in a ring 1 < r < 3.
double lame_pressure() { return inner_pressure / (9.0 - 1.0) * (9.0 / 4.0 - 1.0); }

/// Pressure of the ring at finite strain: r(R) from P_r' = (P_h - P_r) / R by Runge-Kutta, shooting with the inner
/// wall's stretch.
class FiniteRing {
 public:
  double pressure() const {
    double low = 1.0, high = 1.5;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      (end(middle, 3.0)[1] < 0.0 ? low : high) = middle;  // too small a stretch leaves pressure at the outer wall
    }
    const auto [r, P] = end(low, 2.0);
    return -P / (r / 2.0);
  }

 private:
  const double mu_ = material::shear_modulus(rubber), lambda_ = material::lame_lambda(rubber);

  /// P_i = (mu (l_i^2 - 1) + lambda ln J) / l_i.
  double nominal(double own, double other) const {
    return (mu_ * (own * own - 1.0) + lambda_ * std::log(own * other)) / own;
  }

  /// Stretch along the radius with the given nominal stress, by Newton.
  double radial(double P, double hoop) const {
    double l = 1.0;
    for (int k = 0; k < 20; ++k) {
      const double slope = mu_ * (1.0 + 1.0 / (l * l)) + lambda_ * (1.0 - std::log(l * hoop)) / (l * l);
      l -= (nominal(l, hoop) - P) / slope;
    }
    return l;
  }

  using State = std::array<double, 2>;  ///< r, P_r

  State slope(double R, const State& s) const {
    const double hoop = s[0] / R, l = radial(s[1], hoop);
    return {l, (nominal(hoop, l) - s[1]) / R};
  }

  /// At R, from the inner wall on, where the pressure acts on the deformed wall.
  State end(double stretch, double R) const {
    constexpr int steps = 200;
    State s{stretch, -inner_pressure * stretch};
    const double h = (R - 1.0) / steps;
    const auto moved = [](const State& a, double t, const State& d) { return State{a[0] + t * d[0], a[1] + t * d[1]}; };
    for (int k = 0; k < steps; ++k) {
      const double at = 1.0 + k * h;
      const State k1 = slope(at, s), k2 = slope(at + 0.5 * h, moved(s, 0.5 * h, k1)),
                  k3 = slope(at + 0.5 * h, moved(s, 0.5 * h, k2)), k4 = slope(at + h, moved(s, h, k3));
      for (int i : {0, 1}) s[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
    }
    return s;
  }
};

double exact(Kinematics kinematics) {
  static const double finite = FiniteRing().pressure();
  return kinematics == Kinematics::small ? lame_pressure() : finite;
}

support::Assembly assembly(const Rings& s, int n) {
  support::Assembly a;
  a.meshes = {support::ring({.inner = 1.0, .outer = 2.0, .across = n, .around = 2 * n, .kind = s.inner}),
              support::ring({.inner = 2.0, .outer = 3.0, .across = n, .around = 3 * n, .kind = s.outer})};
  auto in = support::elastic(support::Elastic::E, support::Elastic::nu);
  in.kinematics = s.kinematics;
  if (s.kinematics == Kinematics::finite) in.material = rubber;
  in.supports = {support::guide("horizontal", "bottom", 'y'), support::guide("vertical", "top", 'x')};
  a.inputs = {in, in};
  a.inputs[0].boundary_loads = {{"inside", "left", inner_pressure, {0.0, 0.0}, {}, ""}};
  contact::ContactOptions o;
  o.dual = s.dual;
  support::touch_either(a, o, s.inner_secondary, {0, "right"}, {1, "left"});
  return a;
}

/// Root of the mean square error of the pressure over the interface, in parts of the exact pressure. At finite strain a
/// small load closes the contact first: about a deep overlap its gap is far from linear.
double pressure_error(const Rings& s, int n) {
  const auto a = assembly(s, n);
  const auto system = support::system_of(a);
  solver::Newton newton;
  auto state = support::fresh(system);
  for (const double factor : s.kinematics == Kinematics::small ? std::vector{1.0} : std::vector{0.02, 1.0}) {
    auto result = newton.solve(system, state, support::controls_of(a, system, factor));
    EXPECT_TRUE(result.report.converged) << result.report.reason;
    if (!result.report.converged) return std::numeric_limits<double>::infinity();
    state = std::move(result.state);
  }
  const auto& contact = state.contacts[0];
  double sum = 0.0, length = 0.0;
  for (int j = 0; j < system.contacts[0].secondary_count(); ++j) {
    if (system.contacts[0].cut[j]) continue;
    const double D = contact.reference[j].carried(), p = contact.lambda[j].dot(contact.normal[j]);
    sum += D * std::pow(p / exact(s.kinematics) - 1.0, 2);
    length += D;
  }
  return std::sqrt(sum / length);
}

/// The slope between two meshes must exceed `slope`, the error on the finer one stay below `largest`.
void expect_rate(const Rings& s, double slope, double largest) {
  const int n = s.kinematics == Kinematics::small ? 6 : 4;
  const double coarse = pressure_error(s, n), fine = pressure_error(s, 2 * n);
  const auto kind = [](CellKind k) { return std::to_string(static_cast<int>(k)); };
  SCOPED_TRACE(kind(s.inner) + " in " + kind(s.outer) + (s.inner_secondary ? ", inner" : ", outer") +
               " secondary, dual " + std::to_string(static_cast<int>(s.dual)) +
               (s.kinematics == Kinematics::small ? ", small" : ", finite"));
  EXPECT_GT(std::log2(coarse / fine), slope) << coarse << ' ' << fine;
  EXPECT_LT(fine, largest);
}

}  // namespace

// The pressure between rings of first order, whose facets are chords of the interface, must converge with h: a chord is
// off by h^2 / 8 r, which the stiffness E / h makes a pressure.
TEST(curved_patch, first_order) {
  for (const auto kind : {CellKind::quad4, CellKind::tri3})
    for (const auto kinematics : {Kinematics::small, Kinematics::finite})
      for (const bool inner_secondary : {true, false})
        expect_rate({.inner = kind, .outer = kind, .kinematics = kinematics, .inner_secondary = inner_secondary}, 0.9,
                    0.4);
}

// Between rings of second order it must be a few hundred times better. A dual basis sees the normal turn over a facet
// as a saw-tooth of shear on the primary side, of size p h / r: with the coarser ring secondary that bounds the slope
// to one in the end, from far below; with the finer one secondary slope two is left.
TEST(curved_patch, second_order) {
  for (const auto kind : {CellKind::quad8, CellKind::tri6})
    for (const auto kinematics : {Kinematics::small, Kinematics::finite})
      for (const auto dual : {contact::DualOrder::quadratic, contact::DualOrder::linear})
        for (const bool inner_secondary : {true, false})
          expect_rate({kind, kind, dual, kinematics, inner_secondary}, inner_secondary ? 1.0 : 1.7, 6e-4);
}
