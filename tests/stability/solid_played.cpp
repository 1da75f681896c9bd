#include "stability/solid_played.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>
#include <random>

#include "base/errors.hpp"

namespace reye::test {

namespace {

using base::Vec3;
using mesh::SolidKind;

/// Moves every node but those at the outline of the faces "z0", "z1" by a random part of an element; nodes on a face of
/// the block stay on it.
void shake(mesh::SolidMesh& mesh, const Vec3& element, const Vec3& lo, const Vec3& hi, double noise) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> number(-noise, noise);
  for (Vec3& x : mesh.X)
    for (int k = 0; k < 3; ++k) {
      const double way = number(random) * element[k], least = 1e-9 * (hi[k] - lo[k]);
      if (x[k] - lo[k] > least && hi[k] - x[k] > least) x[k] += way;
    }
}

mesh::SolidMesh member_block(const SolidMember& m, bool is_upper) {
  const Vec3 lo = is_upper ? m.lo : Vec3(-0.6, -0.6, -0.5), hi = is_upper ? m.hi : Vec3(0.6, 0.6, 0.0);
  const auto& parts = is_upper ? m.upper_parts : m.lower_parts;
  const SolidKind kind = is_upper ? m.upper : m.lower;
  auto mesh = support::block(kind, parts, Vec3::Ones(), support::box(lo, hi));
  const Vec3 element =
      (hi - lo).cwiseQuotient(Vec3(parts[0], parts[1], parts[2])) * (kind == SolidKind::tet10 ? 0.3 : 1.0);
  if (m.noise > 0.0) shake(mesh, element, lo, hi, m.noise);
  const Vec3 middle = 0.5 * (lo + hi);
  for (Vec3& x : mesh.X) {
    if (is_upper && m.crown_mm > 0.0)
      x.z() += (x - middle).head<2>().squaredNorm() / (2.0 * m.crown_mm) * (hi.z() - x.z()) / (hi.z() - lo.z());
    if (is_upper) x.z() += m.gap_mm;
    x /= m.length;
  }
  return mesh;
}

scene::History turning(double (*value)(double)) {
  scene::History history;
  for (int k = 0; k <= 16; ++k) history.push_back({k / 16.0, value(2.0 * std::numbers::pi * k / 16.0)});
  return history;
}

void set_histories(const SolidMember& m, scene::SolidScene& scene) {
  scene.histories["press"] = {{0.0, 0.0}, {1.0, 1.0}};
  scene.histories["x"] = {{0.0, 0.0}, {0.25, 1.0}, {0.75, -1.0}, {1.0, 0.0}};
  scene.histories["y"] = {{0.0, 0.0}, {1.0, 0.0}};
  scene.histories["lift"] = {{0.0, 0.0}, {1.0, 0.0}};
  if (m.path == SolidPath::round) {
    scene.histories["x"] = turning([](double a) { return std::cos(a) - 1.0; });
    scene.histories["y"] = turning([](double a) { return std::sin(a); });
  }
  if (m.path == SolidPath::lift) scene.histories["lift"] = {{0.0, 0.0}, {0.5, -1.5}, {1.0, 0.0}};
  scene.steps = {support::step_of(2, {"press"}), support::step_of(m.increments, {"x", "y", "lift"}, 1)};
}

sim::SolidProblem problem_of(const SolidMember& m) {
  const double stress = m.length * m.length / m.force;  // MPa in the member's units
  auto lower = support::solid("lower", member_block(m, false), m.E_lower * stress, m.nu);
  auto upper = support::solid("upper", member_block(m, true), m.E_upper * stress, m.nu);
  upper.rigid = m.rigid_upper;
  lower.supports = {
      support::by_node("bottom", "z0", {support::fixed_motion(), support::fixed_motion(), support::fixed_motion()})};
  body::SolidSupport top;
  top.name = "top";
  top.face = "z1";
  top.rigid = true;
  top.along = {support::moved(m.slide_mm / m.length, "x"), support::moved(m.slide_mm / m.length, "y"),
               support::moved(-m.press_mm / m.length, "press")};
  top.along[2].parts.push_back({-m.press_mm / m.length, "lift"});
  for (auto& motion : top.about) motion = support::fixed_motion();
  if (m.force_N != 0.0) {
    top.along[2] = support::loaded(m.force_N / m.force, "press");
    top.about[0] = top.about[1] = body::Motion{};
  }
  upper.supports = {top};
  const double search = 0.2 / m.length;
  auto problem = m.lower_is_secondary ? support::problem_of({lower, upper}, {0, "z1"}, {1, "z0"}, m.mu, search)
                                      : support::problem_of({lower, upper}, {1, "z0"}, {0, "z1"}, m.mu, search);
  if (m.linear) problem.contacts.front().options.dual = mortar::SkinDual::linear;
  set_histories(m, problem.scene);
  problem.scene.remesh.every_blocks = m.remesh_every;
  if (m.wear_per_MPa > 0.0) {
    auto& law = problem.contacts.front().options.wear;
    law.kind = wear::LawKind::archard;
    law.secondary = m.wear_per_MPa;
    law.primary = m.rigid_upper && m.lower_is_secondary ? 0.0 : 0.5 * m.wear_per_MPa;
    auto& step = problem.scene.steps.back();
    step.wear = true;
    step.cycles = 3000.0;
    step.jump = 1000.0;
  }
  return problem;
}

void take_rows(const SolidMember& m, const support::PlayedSolids& played, SolidOutcome& out) {
  out.increments = static_cast<int>(played.rows.size());
  for (const auto& row : played.rows) {
    out.newton += row.newton;
    out.newton_most = std::max(out.newton_most, row.newton);
    out.peak = std::max(out.peak, row.contacts[0].pressure_max_MPa * m.force / (m.length * m.length));
    out.force = std::max(out.force, row.contacts[0].tangential_force_N * m.force);
  }
  for (const auto& frame : played.frames) {
    const auto& p = frame.surfaces.front().pressure_MPa;
    if (const double most = *std::max_element(p.begin(), p.end()); most > 0.0)
      out.least_pressure = std::min(out.least_pressure, *std::min_element(p.begin(), p.end()) / most);
  }
  if (!played.rows.empty()) out.energy = played.rows.back().contacts[0].energy_mJ * m.force * m.length;
}

}  // namespace

SolidOutcome play(const SolidMember& m) {
  SolidOutcome out;
  const std::clock_t start = std::clock();
  try {
    auto problem = problem_of(m);
    problem.scene.frames.every_increment = true;
    problem.scene.frames.paraview = false;
    const auto played = support::play(problem);
    out.status = played.summary.status == sim::RunStatus::done ? "done" : "failed";
    out.reason = played.summary.reason;
    out.cutbacks = static_cast<int>(played.summary.counts.cutbacks);
    out.balance = played.summary.balance;
    out.remeshes = static_cast<int>(played.summary.counts.remeshes);
    take_rows(m, played, out);
    if (!played.summary.contacts.empty()) {
      const auto& contact = played.summary.contacts.front();
      out.ledger = contact.ledger_relative_error.value_or(0.0);
      out.depth_mm = contact.secondary.max_depth_mm;
    }
  } catch (const base::InputError& error) {
    out.status = "refused";
    out.reason = error.what();
  } catch (const base::MeshError& error) {
    out.status = "refused";
    out.reason = error.what();
  }
  out.cpu_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return out;
}

}  // namespace reye::test
