#pragma once
#include <array>
#include <string>

#include "base/linalg.hpp"

/// Numbers as a user would write them, for the texts of issues.
namespace reye::cad {

/// Shortest of six digits: 0.3, 12, 1e-05.
std::string text(double x);
/// "[0, 3]"
std::string text(const base::Vec2& p);
/// "[-6, -6, 6, 0]"
std::string text(const std::array<double, 4>& box);

}  // namespace reye::cad
