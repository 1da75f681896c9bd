#pragma once
#include <string>
#include <vector>

#include "body/solid/solid_place.hpp"

/// Small rigid motions of a solid, u(X) = t + theta x (X - c): six numbers (t, theta), translations [mm] first.
namespace reye::body {

using Mode = Eigen::Matrix<double, 6, 1>;
using Modes = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// The six modes at a place, 3 x 6.
Eigen::Matrix<double, 3, 6> modes_at(const Vec3& X, const Vec3& c);

/// How much a mode moves a place along a direction, or turns about an axis: a linear form of (t, theta).
struct ModeRow {
  int support = -1, motion = 0;
  Mode row = Mode::Zero();
};

/// The form of motion m (0 to 5) of a rigid support.
ModeRow row_of(const SolidSupport& support, int s, int m, const Vec3& support_centre, const Vec3& c);

/// All forms that supports keep at given values: fixed and imposed motions, with `springs` also those that a spring
/// acts on; in the order of supports.
std::vector<ModeRow> held_rows(const SolidInput& input, const std::vector<SolidPlace>& places, const Vec3& c,
                               bool springs);

/// Independent modes on which all rows vanish; unit translations and rotations where possible. `size`: length of the
/// body, which makes rotations comparable.
Modes free_modes(const std::vector<ModeRow>& rows, double size);

/// "x", "along (0.6, 0.8, 0)", "rotation about z" ...
std::string mode_name(const Mode& mode);

}  // namespace reye::body
