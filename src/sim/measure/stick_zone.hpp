#pragma once
#include <optional>
#include <string>

#include "sim/problem/records.hpp"
#include "sim/problem/watch.hpp"

/// What the width of a stick zone says of the end of a wear life. Under forces of one amplitude a stick zone keeps its
/// width while the annulus around it wears until it carries nothing (Ciavarella and Hills); its largest depth then is
/// that of the punch that is left, and falls fast with the width.
namespace reye::sim {

/// Largest depth of a worn Hertz contact in the end, over a^2 / 2R, a the half width or radius before wear. C: stick
/// over contact width.
using LimitDepth = double (*)(double C);

/// Of cylinders: arccosh(X / C) - X sqrt(X^2 - C^2) at X^2 = (1 + C^2) / 2.
double limit_depth_of_cylinders(double C);

/// Of balls: the maximum over X = r / a >= C of D - X^2 - 2 / pi ((D - X^2) asin(C / X) + C sqrt(X^2 - C^2)),
/// D = 4 / (3 C) + 2 C^2 / 3 the approach of the balls.
double limit_depth_of_balls(double C);

/// Warns where a stick zone is narrower than its widest, which it replaces where it is wider, by more than
/// `most_lost` elements: it would keep its width but for the mesh. `about`: the contact.
std::optional<Warning> receding_stick(const std::string& about, const StickZone& now, StickZone& widest,
                                      double most_lost, double cycle, LimitDepth depth);

/// Warns where the largest depth of the end is open by more than a fifth, since an edge is known to one element.
std::optional<Warning> unresolved_stick(const std::string& about, const StickZone& widest, LimitDepth depth);

}  // namespace reye::sim
