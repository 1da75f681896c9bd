#pragma once
#include <numbers>

#include "support/solid_problem.hpp"

/// Ball and flat, or two equal balls, as blocks whose meeting faces are paraboloids: Hertz's own problem.
namespace reye::support {

/// Places along a side: even to `fine`, then growing to `length`.
inline std::vector<double> graded_places(double size, double fine, double length, double growth = 1.35) {
  std::vector<double> at{0.0};
  double step = size;
  while (at.back() < length) {
    if (at.back() >= fine - 1e-9 * size) step *= growth;
    at.push_back(at.back() + step);
  }
  const double scale = (length - fine) / (at.back() - fine);
  for (double& x : at)
    if (x > fine) x = fine + scale * (x - fine);
  return at;
}

/// The place of a parameter in [0, 1], linear between even parameters of the places.
inline double place_at(const std::vector<double>& at, double parameter) {
  const double k = parameter * static_cast<double>(at.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(k), at.size() - 2);
  return at[i] + (at[i + 1] - at[i]) * (k - static_cast<double>(i));
}

struct HertzCase {
  mesh::SolidKind kind = mesh::SolidKind::hex8;
  double elements = 6.0;  ///< per radius of the contact
  double nu = 0.3, mu = 0.0;
  bool half = false;       ///< a half model (symmetric in y alone), else a quarter
  bool whole = false;      ///< neither
  bool two_balls = false;  ///< both faces curved, with the same relative curvature
  double E_MPa = 2.1e5, a_mm = 0.5, R_mm = 25.0, size_over_a = 8.0;
  double fine = 1.3, fine_depth = 0.5, growth = 1.35;  ///< even elements so far over a, then growing by this factor
  double layer = 1.0;                                  ///< thickness of the first elements over their width
  double deep_growth = 0.0;                            ///< growth in depth where it is another one, else 0

  double plane_modulus() const { return 0.5 * E_MPa / (1.0 - nu * nu); }                      ///< E* of the pair
  double force() const { return 4.0 * plane_modulus() * a_mm * a_mm * a_mm / (3.0 * R_mm); }  ///< of the whole ball
  double p0() const { return 1.5 * force() / (std::numbers::pi * a_mm * a_mm); }
  double share() const { return whole ? 1.0 : half ? 0.5 : 0.25; }
};

/// The body above (sign 1) or below (-1) z = 0, its face "contact" curved with 1 / (2 R) times `curved`.
inline mesh::SolidMesh hertz_body(const HertzCase& c, double sign, double curved) {
  const double length = c.size_over_a * c.a_mm;
  const auto at = graded_places(c.a_mm / c.elements, c.fine * c.a_mm, length, c.growth);
  const auto deep = graded_places(c.layer * c.a_mm / c.elements, c.fine_depth * c.a_mm, length,
                                  c.deep_growth > 0.0 ? c.deep_growth : c.growth);
  const int n = static_cast<int>(at.size()) - 1, m = static_cast<int>(deep.size()) - 1;
  const auto map = [=](const Vec3& t) {
    const auto mirrored = [&](double s) {
      return s < 0.5 ? -place_at(at, 1.0 - 2.0 * s) : place_at(at, 2.0 * s - 1.0);
    };
    const double x = c.half || c.whole ? mirrored(t.x()) : place_at(at, t.x());
    const double y = c.whole ? mirrored(t.y()) : place_at(at, t.y());
    const double depth = place_at(deep, sign > 0.0 ? t.z() : 1.0 - t.z());
    const double lift = curved * (x * x + y * y) / (2.0 * c.R_mm) * (1.0 - depth / length);
    return Vec3(x, y, sign * (depth + lift));
  };
  auto mesh = block(c.kind, {c.half || c.whole ? 2 * n : n, c.whole ? 2 * n : n, m}, Vec3::Ones(), map);
  mesh.faces["contact"] = mesh.faces.at(sign > 0.0 ? "z0" : "z1");
  mesh.faces["far"] = mesh.faces.at(sign > 0.0 ? "z1" : "z0");
  return mesh;
}

/// Press with the history "press"; with friction the top slides with the force `Q` of history "slide" along x.
inline sim::SolidProblem hertz_problem(const HertzCase& c, double Q = 0.0) {
  auto flat = solid("flat", hertz_body(c, -1.0, c.two_balls ? 0.5 : 0.0), c.E_MPa, c.nu);
  auto ball = solid("ball", hertz_body(c, 1.0, c.two_balls ? 0.5 : 1.0), c.E_MPa, c.nu);
  for (auto* body : {&flat, &ball}) {
    if (!c.half && !c.whole) body->supports.push_back(symmetry(body->name + "_x", "x0"));
    if (!c.whole) body->supports.push_back(symmetry(body->name + "_y", "y0"));
  }
  flat.supports.push_back(by_node("bottom", "far", {fixed_motion(), fixed_motion(), fixed_motion()}));
  body::SolidSupport top;
  top.name = "top";
  top.face = "far";
  top.rigid = true;
  top.along = {c.half ? loaded(c.share() * Q, "slide") : body::Motion{}, {}, loaded(-c.share() * c.force(), "press")};
  for (auto& motion : top.about) motion = fixed_motion();
  if (!c.half) top.along[0] = fixed_motion();
  top.along[1] = fixed_motion();
  ball.supports.push_back(top);
  auto problem = problem_of({flat, ball}, {1, "contact"}, {0, "contact"}, c.mu, 0.5 * c.a_mm);
  const double reach = 1.4 * c.a_mm;
  cad::SolidFineZone zone;
  zone.contact = "pad";
  zone.radius_mm = reach;
  problem.scene.geometry.fine_zones = {zone};
  problem.scene.histories["press"] = {{0.0, 0.0}, {1.0, 1.0}};
  problem.scene.steps = {step_of(1, {"press"})};
  problem.scene.steps.front().name = "press";
  return problem;
}

/// The straight line value = at_0 + slope r^2 by least squares over the nodes within a distance of the axis z.
struct LineInSquare {
  double at_0 = 0.0, slope = 0.0;
};
template <class Value>
LineInSquare line_in_square(const sim::SkinRecord& surface, double within, Value value) {
  double n = 0, sr = 0, srr = 0, sv = 0, srv = 0;
  for (std::size_t j = 0; j < surface.x_mm.size(); ++j) {
    const double r2 = surface.x_mm[j].head<2>().squaredNorm(), v = value(j);
    if (r2 > within * within) continue;
    n += 1;
    sr += r2;
    srr += r2 * r2;
    sv += v;
    srv += r2 * v;
  }
  const double slope = (n * srv - sr * sv) / (n * srr - sr * sr);
  return {(sv - slope * sr) / n, slope};
}

/// p0 and a of p^2 = p0^2 (1 - r^2 / a^2), fitted over the nodes within 0.9 of the assumed radius.
struct HertzFit {
  double p0 = 0.0, a = 0.0;
};
inline HertzFit fit_hertz(const sim::SkinRecord& surface, double a) {
  const auto [start, slope] =
      line_in_square(surface, 0.9 * a, [&](std::size_t j) { return std::pow(surface.pressure_MPa[j], 2); });
  return {std::sqrt(start), std::sqrt(-start / slope)};
}

}  // namespace reye::support
