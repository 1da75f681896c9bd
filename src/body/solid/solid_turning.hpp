#pragma once
#include <string>
#include <vector>

#include "body/solid/rigid_modes.hpp"
#include "body/solid/solid_pivot.hpp"
#include "body/solid/solid_pose.hpp"

/// How a solid turns: small strain in a frame, whose pose follows from what is driven and from unknown motions.
///                                                                                              [README (15) to (17)]
namespace reye::body {

/// A body that turns, beside its condensed matrices, which are those of `in_frame`. The unknown motions of its pivot
/// are numbers a along and about the pivot's axes; s are the driven values of the body as given.
struct SolidTurning {
  SolidPivot pivot;
  std::vector<Driven> driven;  ///< of the body as given
  std::array<int, 6> value{};  ///< the driven value of each motion of the pivot, or -1
  std::vector<int> free;       ///< motions of the pivot that are unknown, ascending
  Points3 points;              ///< retained points on X
  /// What a driven value of the frame is: the part of a load along an axis of the frame, or (component -1) a load that
  /// turns with the body.
  struct FrameValue {
    int driven = 0, component = -1;
    Vec3 vector = Vec3::Zero();  ///< in space
  };
  std::vector<FrameValue> in_frame;
  Matrix resultants;  ///< 6 x values of the frame, about the pivot: force and moment at value 1

  int count() const { return static_cast<int>(free.size()); }
  bool rotation(int k) const { return free[k] >= 3; }             ///< of an unknown motion
  Vec3 axis(int k) const { return pivot.axes.col(free[k] % 3); }  ///< of an unknown motion
  double stiffness(int k) const { return pivot.motions[free[k]].stiffness; }
};

/// The body in its frame: what guides it is fixed there; a load that keeps its direction in space becomes three loads
/// along the axes.
SolidInput in_frame(const SolidInput& input, const SolidPivot& pivot);

SolidTurning make_turning(const SolidInput& input, const SolidPivot& pivot, const std::vector<int>& retained);

/// Unknown motions against which no spring acts, in words.
std::vector<std::string> unheld_motions(const SolidTurning& turning);

/// The pose for unknown motions a and driven values s. `before`: the rotation by unknown motions before the increment,
/// in which they change by `step`. R = exp(step about the axes) before exp(driven about the axes).
SolidPose pose_of(const SolidTurning& turning, const base::Turn& before, const Vector& step, const Vector& a,
                  const Vector& s);
/// exp(step about the axes) before: what an increment leaves.
base::Turn turned(const SolidTurning& turning, const base::Turn& before, const Vector& step);

/// The change of the unknown motions for a steady motion (a screw) of the frame: `step` along and about the axes beside
/// what is driven from one pose to the other.
Vector along_screw(const SolidTurning& turning, const SolidPose& before, const SolidPose& driven, const Vector& step);

/// Motion of the frame per unit of each unknown motion.
std::vector<Twist> twists_of(const SolidTurning& turning, const SolidPose& pose, const Vector& step);

/// Driven values of the frame, and their change as the frame turns by a small vector.
Vector frame_values(const SolidTurning& turning, const SolidPose& pose, const Vector& s);
Vector frame_value_change(const SolidTurning& turning, const SolidPose& pose, const Vector& s, const Vec3& turn);

/// Forces in space on the retained points, as forces in the frame, and back.
Vector to_frame(const SolidPose& pose, const Vector& forces);
Vector to_space(const SolidPose& pose, const Vector& vectors);

/// Force of the loads in space, and moment about the pivot where it is now.
Mode load_wrench(const SolidTurning& turning, const SolidPose& pose, const Vector& s);

/// What is left of the balance of each unknown motion under forces in space on the retained points: their resultant and
/// that of the loads, formed on X as all of a linear body's equilibrium, the load on the motion less its spring.
Vector balance_of(const SolidTurning& turning, const SolidPose& pose, const Vector& forces, const Vector& a,
                  const Vector& s);
/// Its derivative by the unknown motions while the forces stay.
Matrix balance_rate(const SolidTurning& turning, const SolidPose& pose, const Vector& forces, const Vector& step,
                    const Vector& s);
/// Its derivative by forces in the frame, transposed: 3 points x unknown motions.
Matrix balance_directions(const SolidTurning& turning, const SolidPose& pose);

/// Sum of the sizes of loads and springs in `balance_of`, which its round-off follows.
double balance_scale(const SolidTurning& turning, const Vector& a, const Vector& s);

}  // namespace reye::body
