#pragma once
#include "support/solid_hertz.hpp"

/// Worn solids with closed forms: a wavy surface, flat rings, a cap, strokes of several shapes.
namespace reye::support {

/// Archard's law of the contact's two sides [1/MPa].
inline wear::Law archard(double secondary, double primary = 0.0) {
  wear::Law law;
  law.kind = wear::LawKind::archard;
  law.secondary = secondary;
  law.primary = primary;
  return law;
}

inline std::array<body::Motion, 3> held() { return {fixed_motion(), fixed_motion(), fixed_motion()}; }

/// A rigid face that a force of history "press" pushes along z and that does not move else.
inline body::SolidSupport pressed_rigidly(const std::string& face, double force_N) {
  body::SolidSupport top;
  top.name = "top";
  top.face = face;
  top.rigid = true;
  top.along = {fixed_motion(), fixed_motion(), loaded(-force_N, "press")};
  top.about = held();
  return top;
}

/// Sliding in one step of even increments after the press.
inline void slide_once(sim::SolidProblem& problem, contact::ImposedSliding sliding, int increments) {
  problem.contacts[0].options.sliding = {std::move(sliding)};
  problem.scene.histories["press"] = {{0.0, 0.0}, {1.0, 1.0}};
  problem.scene.steps = {step_of(1, {"press"}), step_of(increments)};
  problem.scene.steps[0].name = "press";
  problem.scene.steps[1].wear = true;
  problem.scene.frames.paraview = false;
}

/// A block whose top is z = A cos(pi x / L) cos(pi y / W) pressed flat by a rigid plate that slides on it: in full
/// contact the wave of the pressure is E* k A / 2 and decays as exp(-alpha E* k s / 2), k^2 = (pi / L)^2 + (pi / W)^2.
struct WavyBlock {
  int elements = 8;  ///< over half a wave along x
  double A_mm = 1e-4, L_mm = 1.0, W_mm = 1.5, E_MPa = 2.0e5, nu = 0.3, mean_MPa = 100.0, alpha = 1e-8, way_mm = 200.0;
  int increments = 50;

  double wave_number() const { return std::numbers::pi * std::hypot(1.0 / L_mm, 1.0 / W_mm); }
  double plane_modulus() const { return E_MPa / (1.0 - nu * nu); }
  double wave_MPa() const { return 0.5 * plane_modulus() * wave_number() * A_mm; }
  double rate() const { return 0.5 * alpha * plane_modulus() * wave_number(); }  ///< of the decay [1/mm]
  /// What backward Euler makes of the decay.
  double decay() const { return std::pow(1.0 + rate() * way_mm / increments, -increments); }

  sim::SolidProblem problem() const {
    const double depth = 1.6 * L_mm;
    const auto places = graded_places(L_mm / elements, 0.3 * L_mm, depth, 1.25);
    const int n = elements, m = static_cast<int>(std::lround(n * W_mm / L_mm)), k = static_cast<int>(places.size()) - 1;
    const double pi = std::numbers::pi;
    auto below = solid("block",
                       block(mesh::SolidKind::hex8, {n, m, k}, Vec3::Ones(),
                             [&](const Vec3& t) {
                               const double x = L_mm * t.x(), y = W_mm * t.y(), z = -place_at(places, 1.0 - t.z());
                               const double wave = A_mm * std::cos(pi * x / L_mm) * std::cos(pi * y / W_mm);
                               return Vec3(x, y, z + wave * (1.0 + z / depth));
                             }),
                       E_MPa, nu);
    for (const char* side : {"x0", "x1", "y0", "y1", "z0"})
      below.supports.push_back(symmetry(std::string("block_") + side, side));
    auto plate = solid("plate",
                       block(mesh::SolidKind::hex8, {n + 1, m + 1, 1}, Vec3::Ones(),
                             [&](const Vec3& t) { return Vec3(L_mm * t.x(), W_mm * t.y(), A_mm + 0.2 * t.z()); }),
                       E_MPa, nu);
    plate.rigid = true;
    plate.supports = {pressed_rigidly("z1", mean_MPa * L_mm * W_mm)};
    auto all = problem_of({below, plate}, {0, "z1"}, {1, "z0"}, 0.0, 0.2);
    all.contacts[0].options.wear = archard(alpha);
    slide_once(all, {.direction = Vec3::UnitX(), .parts = {{way_mm, ""}}}, increments);
    return all;
  }

  /// Amplitude of a value over the secondary nodes, by least squares with their areas.
  double amplitude(const sim::SkinRecord& surface, const std::vector<double>& value) const {
    const double pi = std::numbers::pi;
    double top = 0.0, bottom = 0.0, mean = 0.0, area = 0.0;
    for (std::size_t j = 0; j < value.size(); ++j) {
      mean += surface.area_mm2[j] * value[j];
      area += surface.area_mm2[j];
    }
    for (std::size_t j = 0; j < value.size(); ++j) {
      const double wave = std::cos(pi * surface.x_mm[j].x() / L_mm) * std::cos(pi * surface.x_mm[j].y() / W_mm);
      top += surface.area_mm2[j] * wave * (value[j] - mean / area);
      bottom += surface.area_mm2[j] * wave * wave;
    }
    return top / bottom;
  }
};

/// Quarters of two equal flat rings, nu = 0, the upper one held rigidly and pressed; the lower one wears as it turns
/// about z. At first w = alpha p theta r; at last p r is even.
struct TurningRings {
  double inner_mm = 1.0, outer_mm = 2.0, height_mm = 1.0, E_MPa = 1e5, mean_MPa = 10.0, alpha = 1e-5;
  int radial = 8, around = 10;

  double area() const { return 0.25 * std::numbers::pi * (outer_mm * outer_mm - inner_mm * inner_mm); }
  double force() const { return mean_MPa * area(); }
  /// V after a first turn theta, of the quarter.
  double first_volume(double theta) const {
    const auto cube = [](double r) { return r * r * r; };
    return alpha * force() * theta * 2.0 / 3.0 * (cube(outer_mm) - cube(inner_mm)) /
           (outer_mm * outer_mm - inner_mm * inner_mm);
  }
  /// The pressure at last.
  double last_MPa(double r) const { return 2.0 * force() / (std::numbers::pi * (outer_mm - inner_mm) * r); }

  sim::SolidProblem problem(double theta, int increments) const {
    const auto ring = [&](int n, int m, double from) {
      return block(mesh::SolidKind::hex8, {n, m, 2}, Vec3::Ones(), [=, this](const Vec3& t) {
        const double r = inner_mm + (outer_mm - inner_mm) * t.x(), angle = 0.5 * std::numbers::pi * t.y();
        return Vec3(r * std::cos(angle), r * std::sin(angle), from + height_mm * t.z());
      });
    };
    auto below = solid("below", ring(radial, around, 0.0), E_MPa, 0.0);
    auto above = solid("above", ring(radial, around, height_mm), E_MPa, 0.0);
    below.supports = {by_node("bottom", "z0", held())};
    above.supports = {pressed_rigidly("z1", force())};
    auto all = problem_of({below, above}, {0, "z1"}, {1, "z0"}, 0.0, 0.3);
    all.contacts[0].options.wear = archard(alpha);
    slide_once(all, {.axis = Vec3::UnitZ(), .parts = {{theta, ""}}}, increments);
    return all;
  }
};

/// A quarter of a ball worn flat on a flat that does not wear, by steps of cycles: V = alpha P s = pi a^4 / 4 R,
/// d = a^2 / 2 R, but for what both bend under the even pressure, half a per cent of the depth.
struct WornCap {
  double elements = 12.0;  ///< across half the scar at the end
  double growth = 5.0;     ///< of the radius of the contact
  double alpha = 1e-7;
  int cycles = 40;

  HertzCase hertz() const {
    HertzCase c;
    c.a_mm = 0.4 / growth;
    c.elements = elements / growth;
    c.fine = 1.2 * growth;
    c.fine_depth = 0.4 * growth;
    c.size_over_a = 7.0 * growth;
    c.growth = 1.5;
    return c;
  }
  double radius() const { return growth * hertz().a_mm; }
  double volume() const { return std::numbers::pi * std::pow(radius(), 4) / (4.0 * hertz().R_mm); }
  double depth() const { return radius() * radius() / (2.0 * hertz().R_mm); }

  sim::SolidProblem problem() const {
    const auto c = hertz();
    auto all = hertz_problem(c);
    auto& options = all.contacts[0].options;
    options.wear = archard(alpha);
    options.sliding = {{.direction = Vec3::UnitX(), .parts = {{volume() / (alpha * c.force()) / cycles, ""}}}};
    all.contacts[0].search_mm = 0.2 * radius();
    all.scene.geometry.fine_zones[0].radius_mm = 1.15 * radius();
    all.scene.steps.push_back(step_of(1, {}, cycles));
    all.scene.steps[0].wear = false;
    all.scene.steps[1].wear = true;
    all.scene.frames.paraview = false;
    return all;
  }
};

/// A whole ball on a flat with friction, rubbed by an imposed sliding along a closed path: cycles of straight strokes,
/// or of circles. The energy law wears the flat.
struct RubbedBall {
  double elements = 5.0, mu = 0.4, alpha = 2e-8;
  double a_mm = 0.5;
  int cycles = 4;

  HertzCase hertz() const {
    HertzCase c;
    c.whole = true;
    c.a_mm = a_mm;
    c.elements = elements;
    c.mu = mu;
    c.fine = 1.3;
    c.fine_depth = 0.3;
    c.growth = 1.6;
    c.size_over_a = 6.0;
    return c;
  }

  /// `path`: places of the ball against the flat over a cycle, from and to the origin.
  sim::SolidProblem problem(const std::vector<Vec3>& path) const {
    auto all = hertz_problem(hertz());
    auto& options = all.contacts[0].options;
    options.wear.kind = wear::LawKind::energy;
    options.wear.secondary = alpha;
    scene::History x, y;
    for (std::size_t k = 0; k < path.size(); ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(path.size() - 1);
      x.push_back({t, path[k].x()});
      y.push_back({t, path[k].y()});
    }
    all.scene.histories["x"] = x;
    all.scene.histories["y"] = y;
    options.sliding = {{.direction = Vec3::UnitX(), .parts = {{1.0, "x"}}},
                       {.direction = Vec3::UnitY(), .parts = {{1.0, "y"}}}};
    all.scene.steps.push_back(step_of(static_cast<int>(path.size()) - 1, {"x", "y"}, cycles));
    all.scene.steps[0].wear = false;
    all.scene.steps[1].wear = true;
    all.scene.frames.paraview = false;
    return all;
  }

  static double length(const std::vector<Vec3>& path) {
    double sum = 0.0;
    for (std::size_t k = 1; k < path.size(); ++k) sum += (path[k] - path[k - 1]).norm();
    return sum;
  }
};

/// To and fro along a direction, `parts` increments each quarter.
inline std::vector<Vec3> straight_stroke(double amplitude, double angle, int parts) {
  const Vec3 along(std::cos(angle), std::sin(angle), 0.0);
  std::vector<Vec3> path;
  for (int k = 0; k <= 4 * parts; ++k) {
    const double t = static_cast<double>(k) / parts;
    path.push_back(amplitude * (t <= 1.0 ? t : t <= 3.0 ? 2.0 - t : t - 4.0) * along);
  }
  return path;
}

/// Once round a polygon of a circle through the origin.
inline std::vector<Vec3> circular_stroke(double radius, int parts) {
  std::vector<Vec3> path;
  for (int k = 0; k <= parts; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / parts;
    path.push_back(radius * Vec3(std::sin(angle), 1.0 - std::cos(angle), 0.0));
  }
  return path;
}

/// d and R of w = d - r^2 / 2R, fitted over the nodes within a share of the scar's radius.
struct CapFit {
  double depth_mm = 0.0, R_mm = 0.0;
  double radius() const { return std::sqrt(2.0 * R_mm * depth_mm); }
};
inline CapFit fit_cap(const sim::SkinRecord& surface, double within) {
  const auto [depth, slope] = line_in_square(surface, within, [&](std::size_t j) { return surface.wear_depth_mm[j]; });
  return {depth, -0.5 / slope};
}

}  // namespace reye::support
