#include "body/solid/solid_turning.hpp"

#include <cmath>

#include "body/solid/solid_matrices.hpp"
#include "mesh/solid/solid_measure.hpp"

namespace reye::body {

namespace {

bool is_unknown(const Motion& motion) { return motion.drive == Drive::free || motion.drive == Drive::loaded; }

/// A load in its frame: the part that turns with the body, and what keeps its direction at 1 along each axis.
struct SplitLoad {
  std::vector<SolidLoad> loads;
  std::vector<SolidTurning::FrameValue> values;
};

SplitLoad split_load(const SolidInput& input, const SolidLoad& load, int driven) {
  SplitLoad split;
  if (load.pressure_MPa != 0.0) {
    split.loads.push_back(load);
    split.loads.back().traction_MPa = split.loads.back().force_N = Vec3::Zero();
    split.values.push_back({driven, -1, Vec3::Zero()});
  }
  const bool on_face = !load.face.empty();
  Vec3 vector = load.force_N_per_mm3;
  if (on_face)
    vector = load.traction_MPa + load.force_N / mesh::area(input.mesh->X, mesh::facets_of(*input.mesh, load.face));
  for (int c = 0; c < 3 && !vector.isZero(0.0); ++c) {
    SolidLoad along = load;
    along.pressure_MPa = 0.0;
    along.force_N = Vec3::Zero();
    (on_face ? along.traction_MPa : along.force_N_per_mm3) = Vec3::Unit(c);
    split.loads.push_back(std::move(along));
    split.values.push_back({driven, c, vector});
  }
  return split;
}

}  // namespace

SolidInput in_frame(const SolidInput& input, const SolidPivot& pivot) {
  SolidInput framed = input;
  for (int s = 0; s < static_cast<int>(framed.supports.size()); ++s) {
    auto& support = framed.supports[s];
    for (auto* motions : {&support.along, &support.about})
      for (auto& motion : *motions)
        if (s == pivot.support || motion.drive == Drive::moved) motion = {.drive = Drive::fixed};
    if (support.normal.drive == Drive::moved) support.normal = {.drive = Drive::fixed};
  }
  framed.loads.clear();
  for (const auto& load : input.loads)
    for (auto& part : split_load(input, load, 0).loads) framed.loads.push_back(std::move(part));
  return framed;
}

SolidTurning make_turning(const SolidInput& input, const SolidPivot& pivot, const std::vector<int>& retained) {
  SolidTurning turning;
  turning.pivot = pivot;
  turning.driven = driven_of(input);
  for (int m = 0; m < normal_motion; ++m) {
    turning.value[m] = pivot.support < 0 ? -1 : driven_motion(turning.driven, pivot.support, m);
    if (is_unknown(pivot.motions[m])) turning.free.push_back(m);
  }
  const Points3 points = contact_points(input);
  for (const int node : retained) turning.points.push_back(points[node]);
  std::vector<Mode> wrenches;
  for (int k = 0; k < static_cast<int>(turning.driven.size()); ++k) {
    if (turning.driven[k].load < 0) continue;
    const SplitLoad split = split_load(input, input.loads[turning.driven[k].load], k);
    for (const auto& load : split.loads) wrenches.push_back(resultant_of(input, load, pivot.centre));
    turning.in_frame.insert(turning.in_frame.end(), split.values.begin(), split.values.end());
  }
  turning.resultants.resize(6, static_cast<Eigen::Index>(wrenches.size()));
  for (std::size_t k = 0; k < wrenches.size(); ++k) turning.resultants.col(static_cast<Eigen::Index>(k)) = wrenches[k];
  return turning;
}

std::vector<std::string> unheld_motions(const SolidTurning& turning) {
  std::vector<std::string> names;
  for (int k = 0; k < turning.count(); ++k) {
    if (turning.stiffness(k) > 0.0) continue;
    Mode mode = Mode::Zero();
    mode.segment<3>(turning.rotation(k) ? 3 : 0) = turning.axis(k);
    names.push_back(mode_name(mode));
  }
  return names;
}

namespace {

Vec3 turn_of(const SolidTurning& turning, const Vector& step) {
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < turning.count(); ++k)
    if (turning.rotation(k)) sum += step[k] * turning.axis(k);
  return sum;
}

/// Imposed values along (first 0) or about (3) the axes.
Vec3 driven_vector(const SolidTurning& turning, int first, const Vector& s) {
  Vec3 sum = Vec3::Zero();
  for (int c = 0; c < 3; ++c)
    if (const int v = turning.value[first + c]; v >= 0 && turning.pivot.motions[first + c].drive == Drive::moved)
      sum += s[v] * turning.pivot.axes.col(c);
  return sum;
}

}  // namespace

base::Turn turned(const SolidTurning& turning, const base::Turn& before, const Vector& step) {
  return (base::turn_by(turn_of(turning, step)) * before).normalized();
}

SolidPose pose_of(const SolidTurning& turning, const base::Turn& before, const Vector& step, const Vector& a,
                  const Vector& s) {
  SolidPose pose;
  pose.R = (turned(turning, before, step) * base::turn_by(driven_vector(turning, 3, s))).toRotationMatrix();
  pose.centre = turning.pivot.centre;
  pose.shift = driven_vector(turning, 0, s);
  for (int k = 0; k < turning.count(); ++k)
    if (!turning.rotation(k)) pose.shift += a[k] * turning.axis(k);
  return pose;
}

Vector along_screw(const SolidTurning& turning, const SolidPose& before, const SolidPose& driven, const Vector& step) {
  const Twist own = relative_twist(before, driven, {}, {}).about(before.pivot());
  Vec3 way = own.way;
  for (int k = 0; k < turning.count(); ++k)
    if (!turning.rotation(k)) way += step[k] * turning.axis(k);
  const Vec3 chord = base::turn_rate(own.turn + turn_of(turning, step)) * way;
  Vector change = step;
  for (int k = 0; k < turning.count(); ++k)
    if (!turning.rotation(k)) change[k] = turning.axis(k).dot(chord);
  return change;
}

std::vector<Twist> twists_of(const SolidTurning& turning, const SolidPose& pose, const Vector& step) {
  const Mat3 T = base::turn_rate(turn_of(turning, step));
  std::vector<Twist> twists(static_cast<std::size_t>(turning.count()));
  for (int k = 0; k < turning.count(); ++k) {
    twists[k].origin = pose.pivot();
    (turning.rotation(k) ? twists[k].turn : twists[k].way) =
        turning.rotation(k) ? Vec3(T * turning.axis(k)) : turning.axis(k);
  }
  return twists;
}

Vector frame_values(const SolidTurning& turning, const SolidPose& pose, const Vector& s) {
  Vector values(static_cast<Eigen::Index>(turning.in_frame.size()));
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    const auto& [driven, component, vector] = turning.in_frame[k];
    values[k] = s[driven] * (component < 0 ? 1.0 : pose.R.col(component).dot(vector));
  }
  return values;
}

Vector frame_value_change(const SolidTurning& turning, const SolidPose& pose, const Vector& s, const Vec3& turn) {
  Vector change = Vector::Zero(static_cast<Eigen::Index>(turning.in_frame.size()));
  for (Eigen::Index k = 0; k < change.size(); ++k) {
    const auto& [driven, component, vector] = turning.in_frame[k];
    if (component >= 0) change[k] = s[driven] * turn.cross(Vec3(pose.R.col(component))).dot(vector);
  }
  return change;
}

Vector to_frame(const SolidPose& pose, const Vector& forces) {
  Vector turned(forces.size());
  for (Eigen::Index k = 0; k < forces.size(); k += 3) turned.segment<3>(k) = pose.R.transpose() * forces.segment<3>(k);
  return turned;
}

Vector to_space(const SolidPose& pose, const Vector& vectors) {
  Vector turned(vectors.size());
  for (Eigen::Index k = 0; k < vectors.size(); k += 3) turned.segment<3>(k) = pose.R * vectors.segment<3>(k);
  return turned;
}

Mode load_wrench(const SolidTurning& turning, const SolidPose& pose, const Vector& s) {
  return to_space(pose, turning.resultants * frame_values(turning, pose, s));
}

Vector balance_of(const SolidTurning& turning, const SolidPose& pose, const Vector& forces, const Vector& a,
                  const Vector& s) {
  Mode wrench = load_wrench(turning, pose, s);
  for (std::size_t i = 0; i < turning.points.size(); ++i) {
    const Vec3 f = forces.segment<3>(3 * static_cast<Eigen::Index>(i));
    wrench.head<3>() += f;
    wrench.tail<3>() += Vec3(pose.R * (turning.points[i] - pose.centre)).cross(f);
  }
  Vector left(turning.count());
  for (int k = 0; k < turning.count(); ++k) {
    const int v = turning.value[turning.free[k]];
    left[k] = turning.axis(k).dot(wrench.segment<3>(turning.rotation(k) ? 3 : 0)) - turning.stiffness(k) * a[k] +
              (v < 0 ? 0.0 : s[v]);
  }
  return left;
}

Matrix balance_rate(const SolidTurning& turning, const SolidPose& pose, const Vector& forces, const Vector& step,
                    const Vector& s) {
  const auto twists = twists_of(turning, pose, step);
  const Mode loads = load_wrench(turning, pose, s);
  Matrix rate = Matrix::Zero(turning.count(), turning.count());
  for (int k = 0; k < turning.count(); ++k) {
    const Vec3& w = twists[k].turn;
    Mode change = to_space(pose, turning.resultants * frame_value_change(turning, pose, s, w));
    for (int first : {0, 3}) change.segment<3>(first) += w.cross(Vec3(loads.segment<3>(first)));
    for (std::size_t i = 0; i < turning.points.size(); ++i)
      change.tail<3>() += w.cross(Vec3(pose.R * (turning.points[i] - pose.centre)))
                              .cross(Vec3(forces.segment<3>(3 * static_cast<Eigen::Index>(i))));
    for (int i = 0; i < turning.count(); ++i)
      rate(i, k) = turning.axis(i).dot(change.segment<3>(turning.rotation(i) ? 3 : 0));
    rate(k, k) -= turning.stiffness(k);
  }
  return rate;
}

Matrix balance_directions(const SolidTurning& turning, const SolidPose& pose) {
  Matrix directions(3 * static_cast<Eigen::Index>(turning.points.size()), turning.count());
  for (int k = 0; k < turning.count(); ++k) {
    const Vec3 e = pose.R.transpose() * turning.axis(k);
    for (std::size_t i = 0; i < turning.points.size(); ++i)
      directions.block<3, 1>(3 * static_cast<Eigen::Index>(i), k) =
          turning.rotation(k) ? e.cross(turning.points[i] - pose.centre) : e;
  }
  return directions;
}

double balance_scale(const SolidTurning& turning, const Vector& a, const Vector& s) {
  double sum = 0.0;
  for (int k = 0; k < turning.count(); ++k) {
    const int v = turning.value[turning.free[k]];
    sum += std::abs(turning.stiffness(k) * a[k]) + (v < 0 ? 0.0 : std::abs(s[v]));
  }
  for (std::size_t k = 0; k < turning.in_frame.size(); ++k) {
    const auto& [driven, component, vector] = turning.in_frame[k];
    const Vec3 force = turning.resultants.col(static_cast<Eigen::Index>(k)).head<3>();
    if (component <= 0) sum += std::abs(s[driven]) * force.norm() * (component < 0 ? 1.0 : vector.norm());
  }
  return sum;
}

}  // namespace reye::body
