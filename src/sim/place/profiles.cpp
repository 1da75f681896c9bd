#include "sim/place/profiles.hpp"

#include <algorithm>
#include <cmath>

#include "base/formatted.hpp"
#include "mesh/arc.hpp"
#include "sim/problem/warnings.hpp"

namespace reye::sim {

namespace {

constexpr double missed = 0.2;  ///< of the heights of a profile

/// Height by straight lines between its points, zero outside of them.
double height(const cad::Profile& profile, double s) {
  const auto& arc = profile.arc_mm;
  const auto after = std::upper_bound(arc.begin(), arc.end(), s);
  if (after == arc.begin() || after == arc.end()) return 0.0;
  const auto i = static_cast<std::size_t>(after - arc.begin());
  const double t = (s - arc[i - 1]) / (arc[i] - arc[i - 1]);
  return profile.height_mm[i - 1] + t * (profile.height_mm[i] - profile.height_mm[i - 1]);
}

/// The largest distance of its points from the facets between nodes at these arc lengths, and the longest facet among
/// them.
std::array<double, 2> off_the_facets(const cad::Profile& profile, const std::vector<double>& nodes) {
  double off = 0.0, longest = 0.0;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const double a = nodes[i - 1], b = nodes[i];
    for (std::size_t k = 0; k < profile.arc_mm.size(); ++k) {
      const double s = profile.arc_mm[k];
      if (s <= a || s >= b) continue;
      const double line = height(profile, a) + (s - a) / (b - a) * (height(profile, b) - height(profile, a));
      off = std::max(off, std::abs(profile.height_mm[k] - line));
      longest = std::max(longest, b - a);
    }
  }
  return {off, longest};
}

double largest_height(const cad::Profile& profile) {
  const auto [low, high] = std::minmax_element(profile.height_mm.begin(), profile.height_mm.end());
  return std::max(*high, 0.0) - std::min(*low, 0.0);
}

/// Warns where the facets of a boundary miss much of the heights of its profile.
void warn_of_profile(const mesh::Mesh& mesh, const std::string& boundary, const cad::Profile& profile,
                     std::vector<Warning>& warnings) {
  const double heights = largest_height(profile);
  for (const auto& chain : mesh::arc_chains(mesh, boundary)) {
    const auto [off, longest] = off_the_facets(profile, chain.arc);
    if (off <= missed * heights) continue;
    const std::string text = base::formatted(
        "Its profile %s has heights of %.4g mm, of which elements of %.4g mm miss up to %.4g mm: it is finer than the "
        "mesh. Make elements there shorter, or smooth the profile.",
        profile.file.c_str(), heights, longest, off);
    warn(warnings, {"profile", "boundary " + boundary, text, off / heights});
  }
}

}  // namespace

void warn_of_profiles(Problem& problem) {
  for (const auto& boundary : problem.scene.geometry.boundaries)
    for (int b = 0; boundary.profile && b < problem.body_count(); ++b) {
      const auto& mesh = problem.shapes[b]->mesh;
      if (problem.inputs[b].name == boundary.body && mesh.boundaries.contains(boundary.name))
        warn_of_profile(mesh, boundary.name, *boundary.profile, problem.warnings);
    }
}

}  // namespace reye::sim
