#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "contact/solid/cone.hpp"

using namespace reye;
using base::Vec3;

namespace {

contact::SkinFrame random_frame(std::mt19937& random) {
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  contact::SkinFrame frame;
  frame.normal = Vec3(any(random), any(random), any(random)).normalized();
  frame.tangent[0] = frame.normal.unitOrthogonal();
  frame.tangent[1] = frame.normal.cross(frame.tangent[0]);
  return frame;
}

/// z_t - mu p d(y), whose zero is the condition of a slipping point.
Vec3 off_the_cone(const contact::SkinNode& node, const contact::SkinFrame& frame, double mu, double c) {
  const Vec3 y = contact::trial(node, frame, c);
  return contact::shear(node, frame) - mu * contact::pressure(node, frame) * y.normalized();
}

}  // namespace

TEST(SolidCone, StepOfASlippingPointIsTheDerivative) {
  // Newton's equations of a slipping point are the derivative of its condition, by central differences in pressure,
  // shear and slip.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  constexpr double mu = 0.4, c = 30.0, h = 1e-6;
  for (int trial = 0; trial < 50; ++trial) {
    const auto frame = random_frame(random);
    contact::SkinNode node;
    const double p = 2.0 + any(random);
    const Vec3 along = frame.across(Vec3(any(random), any(random), any(random)));
    node.slip = 0.2 * along;
    node.traction = p * frame.normal + 1.5 * frame.across(Vec3(any(random), any(random), any(random)));
    const auto step = contact::slip_step(node, frame, mu, c);
    const double dp = any(random), dz = any(random), du = any(random);
    const auto moved = [&](double t) {
      contact::SkinNode other = node;
      other.traction += t * (dp * frame.normal + mu * dp * step.d + dz * step.e);
      other.slip += t * du * step.e;
      return off_the_cone(other, frame, mu, c);
    };
    const Vec3 derivative = (moved(h) - moved(-h)) / (2.0 * h);
    const double length = contact::trial(node, frame, c).norm(), share = mu * p / length;
    EXPECT_NEAR(derivative.dot(step.d), 0.0, 1e-7);
    EXPECT_NEAR(derivative.dot(step.e), (1.0 - share) * dz - share * c * du, 1e-7);
    if (share < 1.0) {
      EXPECT_NEAR(step.share, share, 1e-14);
    }
  }
}

TEST(SolidCone, SticksInsideAndSlipsOutside) {
  // A point sticks where |z_t + c u_t| is at most mu p, slips beyond, and is open where p - c g is not positive.
  contact::SkinFrame frame;
  frame.normal = Vec3::UnitZ();
  frame.tangent = {Vec3::UnitX(), Vec3::UnitY()};
  contact::SkinNode node;
  node.traction = {0.3, -0.4, 2.0};
  EXPECT_EQ(contact::tangential_status(node, frame, 0.26, 1.0), contact::SkinStatus::stick);
  EXPECT_EQ(contact::tangential_status(node, frame, 0.24, 1.0), contact::SkinStatus::slip);
  node.slip = {0.03, -0.04, 0.0};
  EXPECT_EQ(contact::tangential_status(node, frame, 0.26, 1.0), contact::SkinStatus::slip);
  EXPECT_GT(contact::trial_pressure(node, frame, 10.0), 0.0);
  node.gap = 0.21;
  EXPECT_LE(contact::trial_pressure(node, frame, 10.0), 0.0);
}

TEST(SolidCone, ViolationIsZeroOnTheConditionsAlone) {
  // A point on its conditions violates nothing; a gap, a slip while it sticks, or shear off the cone count in MPa.
  contact::SkinFrame frame;
  frame.normal = Vec3::UnitZ();
  frame.tangent = {Vec3::UnitX(), Vec3::UnitY()};
  contact::SkinNode node;
  node.traction = {0.0, 0.5, 1.0};
  node.slip = {0.0, 0.1, 0.0};
  using enum contact::SkinStatus;
  EXPECT_NEAR(contact::violation(node, frame, slip, 0.5, 20.0), 0.0, 1e-15);
  EXPECT_NEAR(contact::violation(node, frame, slip, 0.4, 20.0), 0.1, 1e-15);
  EXPECT_NEAR(contact::violation(node, frame, stick, 0.5, 20.0), 2.0, 1e-15);
  node.gap = 0.3;
  EXPECT_NEAR(contact::violation(node, frame, slip, 0.5, 20.0), 6.0, 1e-14);
  EXPECT_NEAR(contact::violation(node, frame, open, 0.5, 20.0), std::hypot(0.5, 1.0), 1e-15);
}

TEST(SolidCone, OnAPlaneOfSymmetryOnlyOneTangentIsLeft) {
  // A frame with one free tangent leaves nothing across the plane of symmetry.
  contact::SkinFrame frame;
  frame.normal = Vec3::UnitZ();
  frame.tangent = {Vec3::UnitX(), Vec3::UnitY()};
  frame.free = 1;
  EXPECT_TRUE(frame.across({2.0, 3.0, 4.0}).isApprox(Vec3(2.0, 0.0, 0.0)));
  frame.free = 0;
  EXPECT_TRUE(frame.across({2.0, 3.0, 4.0}).isZero());
}
