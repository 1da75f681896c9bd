#include "cad/solid/solid_text.hpp"

#include <cmath>

namespace reye::cad {

namespace {

/// Numbers of a list; what is a rounding error beside the others is zero.
std::string in_brackets(const double* x, int count) {
  double largest = 0.0;
  for (int i = 0; i < count; ++i) largest = std::max(largest, std::abs(x[i]));
  std::string all = "[";
  for (int i = 0; i < count; ++i) all += (i ? ", " : "") + text(std::abs(x[i]) < 1e-9 * largest ? 0.0 : x[i]);
  return all + "]";
}

}  // namespace

std::string text(const base::Vec3& p) { return in_brackets(p.data(), 3); }
std::string text(const SolidBox& box) { return in_brackets(box.data(), 6); }

std::string describe(const RawFace& face) {
  std::string names;
  for (const std::string& name : face.names) names += (names.empty() ? " '" : ", '") + name + "'";
  return to_string(face.type) + names + " in box " + text(face.box_mm);
}

std::string describe(const RawSolid& solid) {
  return (solid.label.empty() ? "a solid without name" : "'" + solid.label + "'") + " in box " + text(solid.box_mm);
}

}  // namespace reye::cad
