#include <Eigen/Geometry>

#include "mesh/measure.hpp"
#include "verification/contact_scene.hpp"
#include "verification/turned.hpp"

using namespace reye;
using namespace reye::verification;

namespace {

using base::Vec2;

/// Two pressed blocks (references C5) at finite strain, with friction, turned as a whole.
std::string turned_blocks(double degrees, double friction) {
  const std::string angle = "\nangle_deg = " + std::to_string(degrees);
  std::string text = scene_text("two_blocks_dual", {{"E_MPa = 1.0e6", "law = \"hencky\"\nE_MPa = 1.0e6"},
                                                    {"kinematics = \"small\"", "kinematics = \"finite\""},
                                                    {"edge = \"left_left\"", "edge = \"left_left\"" + angle},
                                                    {"edge = \"right_right\"", "edge = \"right_right\"" + angle}});
  const auto from = text.find("geometry = [\""), to = text.find(']', from);
  text.replace(from, to - from, "geometry = [\"" + turned_mesh("two_blocks_dual/two_blocks.msh", degrees) + "\"");
  return replaced(text, {{"[support.push]", "friction = " + std::to_string(friction) + "\n\n[support.push]"}});
}

/// One step of equal increments: the upper of two blocks is pressed down, drawn back and forth a little, and then both
/// holders turn about the origin. Every motion is a history in mm or rad, exact at the end of each increment.
struct Turning {
  std::vector<Vec2> upper;    ///< of the upper block's top after each increment
  std::vector<double> angle;  ///< of both [rad]

  static constexpr int increments = 14;
  const Vec2 top{2.5, 3.0}, bottom{2.0, 0.0};  ///< middles of the two edges

  explicit Turning(double end) {
    for (int k = 0; k <= increments; ++k) {
      const double press = std::min(k, 4) / 4.0,
                   draw = k <= 4 ? 0.0 : std::min(k - 4, 3) - 0.7 * std::clamp(k - 7, 0, 1);
      angle.push_back(end * std::max(k - 8, 0) / (increments - 8));
      upper.push_back(base::Vec2(0.02 * draw, -0.15 * press));
    }
  }

  std::string history(const std::string& name, const std::function<double(int)>& at) const {
    std::string text = name + " = [";
    for (int k = 0; k <= increments; ++k)
      text += (k ? ", " : "") + pair_text({static_cast<double>(k) / increments, at(k)});
    return text + "]\n";
  }

  /// Where a point that has moved by u is after the turn, less where it was.
  Vec2 moved(const Vec2& X, const Vec2& u, int k) const { return Eigen::Rotation2Dd(angle[k]) * (X + u) - X; }

  std::string histories() const {
    const auto up = [&](int k) { return moved(top, upper[k], k); };
    const auto low = [&](int k) { return moved(bottom, {0.0, 0.0}, k); };
    return history("up_x", [&](int k) { return up(k).x(); }) + history("up_y", [&](int k) { return up(k).y(); }) +
           history("low_x", [&](int k) { return low(k).x(); }) + history("low_y", [&](int k) { return low(k).y(); }) +
           history("turn", [&](int k) { return angle[k]; });
  }
};

std::string turning_scene(double angle, const std::string& order) {
  const auto support = [](const std::string& edge, const std::string& name) {
    return "[support." + name + "]\nedge = \"" + edge + "\"\nx = { motion_mm = 1.0, history = \"" + name +
           "_x\" }\ny = { motion_mm = 1.0, history = \"" + name +
           "_y\" }\nrotation = { motion_rad = 1.0, history = \"turn\" }\n";
  };
  std::string text =
      scene_text("two_blocks_finite", {{"far_size_mm = 0.15", "far_size_mm = 0.3"},
                                       {"far_size_mm = 0.125", "far_size_mm = 0.25"},
                                       {"kinematics = \"finite\"", "kinematics = \"finite\"\n" + order}});
  text.resize(text.find("[support.bottom]"));
  return text + support("upper_top", "up") + support("lower_bottom", "low") + "[history]\n" +
         Turning(angle).histories() +
         "[[step]]\nname = \"all\"\nplay = [\"up_x\", \"up_y\", \"low_x\", \"low_y\", \"turn\"]\nincrements = " +
         std::to_string(Turning::increments) + "\n";
}

std::map<double, double> by_height(const sim::SurfaceRecord& s, const std::vector<double>& values) {
  std::map<double, double> result;
  for (std::size_t i = 0; i < s.node.size(); ++i) result[s.y_mm[i]] = values[i];
  return result;
}

double largest_jump(const std::vector<double>& v, std::size_t from, std::size_t to) {
  double largest = 0.0;
  for (std::size_t i = from; i < to; ++i)
    largest = std::max(largest, std::abs(v[i] - 0.5 * (v[i - 1] + v[i + 1])) / std::abs(v[i]));
  return largest;
}

}  // namespace

// Finite strain: a scene turned by 30 degrees under load has the same pressures, and its forces turn with it.
TEST(FiniteStrain, SceneTurnedUnderLoad) {
  const auto upright = played(turned_blocks(0.0, 0.3)), turned_by_30 = played(turned_blocks(30.0, 0.3));
  const auto &p = upright.surface(sim::Side::secondary).pressure_MPa,
             &q = turned_by_30.surface(sim::Side::secondary).pressure_MPa;
  const double largest = *std::max_element(p.begin(), p.end());
  ASSERT_EQ(p.size(), q.size());
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_NEAR(p[i], q[i], 1e-10 * largest);
  const auto &f = upright.records.back().support_forces, &g = turned_by_30.records.back().support_forces;
  for (std::size_t k = 0; k < f.size(); ++k) EXPECT_LT((turned(f[k], 30.0) - g[k]).norm(), 1e-10 * f[k].norm());
}

// A loaded scene that turns under load by a right angle: pressure, shear and slip stay what they are, partly in stick
// and partly in slip, and the forces turn with it.
TEST(FiniteStrain, LoadedSceneTurns) {
  for (const std::string order : {"", "order = 2"}) {
    const double angle = 90.0;
    const auto rest = played(turning_scene(0.0, order)),
               turning = played(turning_scene(angle * std::numbers::pi / 180.0, order));
    const auto &p = rest.surface(sim::Side::secondary), &q = turning.surface(sim::Side::secondary);
    const double largest = *std::max_element(p.pressure_MPa.begin(), p.pressure_MPa.end());
    EXPECT_GT(std::count(p.status.begin(), p.status.end(), 1), 2);
    EXPECT_GT(*std::max_element(p.slip_mm.begin(), p.slip_mm.end()), 1e-3);
    for (std::size_t i = 0; i < p.node.size(); ++i) {
      EXPECT_NEAR(p.pressure_MPa[i], q.pressure_MPa[i], 1e-10 * largest) << "node " << i;
      EXPECT_NEAR(p.shear_MPa[i], q.shear_MPa[i], 1e-10 * largest) << "node " << i;
      EXPECT_NEAR(p.slip_mm[i], q.slip_mm[i], 1e-10) << "node " << i;
    }
    const auto &f = rest.records.back().support_forces, &g = turning.records.back().support_forces;
    for (std::size_t k = 0; k < f.size(); ++k) EXPECT_LT((turned(f[k], angle) - g[k]).norm(), 1e-10 * f[k].norm());
  }
}

// Two pressed blocks whose Cauchy stress is linear in log strain (references C5) carry the published multipliers, per
// current length, within 0.2 %; so does their shear where they stick, the left one alone being soft.
TEST(FiniteStrain, DualMultipliers) {
  const Replacements cauchy{{"law = \"hencky\"", "law = \"hencky_cauchy\""}};
  const auto pressed = played(replaced(turned_blocks(0.0, 0.0), cauchy));
  const auto& s = pressed.surface(sim::Side::secondary);
  const double pressure[4] = {86628.75, 101873.31, 112298.40, 112799.85};
  int k = 0;
  for (const auto& [y, p] : by_height(s, s.pressure_MPa))
    if (k < 4) {
      EXPECT_NEAR(p / pressure[k++], 1.0, 0.002) << "y " << y;
    }

  const std::string soft = "[material.elastic]\nlaw = \"hencky\"\nE_MPa = ",
                    hard = "[material.hard]\nlaw = \"hencky\"\nE_MPa = 1.0e8\nnu = 0.3\n\n";
  const auto stuck = played(
      replaced(turned_blocks(0.0, 1.0), {{soft + "1.0e6", hard + soft + "1.0e4"},
                                         {"[body.right]\nmaterial = \"elastic\"", "[body.right]\nmaterial = \"hard\""},
                                         cauchy.front()}));
  const auto& q = stuck.surface(sim::Side::secondary);
  const double shear[4] = {794.326, 284.924, 69.965, 0.0};
  k = 0;
  for (const auto& [y, value] : by_height(q, q.shear_MPa))
    if (k < 4) {
      EXPECT_NEAR(value, shear[k++], 0.005 * shear[0]) << "y " << y;
    }
}

// Ironing onset (references C6): at t = 0.1 the lowest node alone carries 47.731 and the shear is friction times that.
TEST(FiniteStrain, IroningOnset) {
  const auto run =
      played(scene_text("ironing", {{"[[0.0, 0.0], [0.125, 1.0], [1.0, 1.0]]", "[[0.0, 0.0], [1.0, 0.1]]"},
                                    {"draw  = [[0.0, 0.0], [1.0, 1.0]]", "draw  = [[0.0, 0.0], [1.0, 0.0125]]"},
                                    {"increments = 80 ", "increments = 1 "}}));
  const auto& s = run.surface(sim::Side::secondary);
  int loaded = 0;
  for (double p : s.pressure_MPa) loaded += p > 0.0;
  EXPECT_EQ(loaded, 1);
  const auto peak = std::max_element(s.pressure_MPa.begin(), s.pressure_MPa.end()) - s.pressure_MPa.begin();
  EXPECT_NEAR(s.pressure_MPa[peak], 47.731, 0.002 * 47.731);
  EXPECT_NEAR(std::abs(s.shear_MPa[peak]), 0.5 * s.pressure_MPa[peak], 1e-9 * s.pressure_MPa[peak]);
}

// Ironing over 8 mm: every increment at its planned size, and reactions without jumps where nodes pass facet ends.
TEST(FiniteStrain, IroningLongStroke) {
  const auto run = played(scene_text("ironing"));
  EXPECT_EQ(run.summary.counts.cutbacks, 0);
  ASSERT_EQ(run.records.size(), 80U);
  std::vector<double> x, y;
  for (const auto& r : run.records) {
    x.push_back(r.support_forces[0].x());
    y.push_back(r.support_forces[0].y());
  }
  EXPECT_LT(largest_jump(x, 15, 75), 0.02);
  EXPECT_LT(largest_jump(y, 15, 75), 0.02);
}

// A rolling ring moves along by what its tread measures there: its hub turns by 1.5, and nothing holds it along the
// road.
TEST(FiniteStrain, RollingRing) {
  const auto run = played(scene_text("rolling_ring"));
  EXPECT_EQ(run.summary.counts.cutbacks, 0);
  const auto& ring = run.frame.bodies[0];
  double hub = 0.0;
  int nodes = 0;
  for (std::size_t i = 0; i < ring.mesh->X.size(); ++i)
    if (std::abs((ring.mesh->X[i] - Vec2(0.0, 5.0)).norm() - 3.0) < 1e-6) {
      hub += ring.u[i].x();
      ++nodes;
    }
  ASSERT_GT(nodes, 10);
  // Nearly incompressible rubber squeezed against its hub runs longer than it is: such rollers roll on a radius that is
  // some per cent above the free one.
  EXPECT_GT(hub / nodes, 1.5 * 5.0);
  EXPECT_LT(hub / nodes, 1.5 * 5.2);
  for (const auto& r : run.records) EXPECT_NEAR(r.support_forces[0].x(), 0.0, 1e-9 * std::abs(r.support_forces[0].y()));
}

// Bodies of three kinds in a stack, the middle one held by its contacts alone: the ledger closes, forces balance.
TEST(FiniteStrain, ThreeBodies) {
  const auto run = played(scene_text("three_bodies"));
  const auto& r = run.records.back();
  EXPECT_LT((r.support_forces[0] + r.support_forces[1]).norm(), 1e-8 * r.support_forces[0].norm());
  EXPECT_GT(run.summary.contacts[0].secondary.worn_area, 0.0);
  EXPECT_LT(*run.summary.contacts[0].ledger_relative_error, 1e-9);
}

// Rubber-like strains: the removed volume is unstressed volume, and the ledger closes through shape steps and a remesh.
TEST(FiniteStrain, RubberPinLedger) {
  const auto run = played(scene_text("rubber_pin_wear", {{"cycles = 200", "cycles = 40"}}));
  EXPECT_GT(run.summary.contacts[0].secondary.max_depth_mm, 0.01);
  EXPECT_LT(*run.summary.contacts[0].ledger_relative_error, 1e-9);
}

// A ring pressed flat plastically: no more than one increment in twenty is cut, Newton stays bounded, the crown parts
// from the die, and pressing needs ever more force.
TEST(FiniteStrain, PressedRing) {
  const auto run = played(scene_text("pressed_ring_plastic"));
  EXPECT_LE(run.summary.counts.cutbacks, 2);
  for (const auto& r : run.records)
    EXPECT_LE(r.newton, 50) << "progress " << r.progress;  // steps on kept matrices and tangents count, too
  const auto& s = run.surface(sim::Side::secondary);
  const auto peak = std::max_element(s.pressure_MPa.begin(), s.pressure_MPa.end()) - s.pressure_MPa.begin();
  EXPECT_GT(s.x_mm[peak], 1.0);
  EXPECT_GT(std::abs(run.records.back().support_forces[2].y()), 1.3 * std::abs(run.records[5].support_forces[2].y()));
}
