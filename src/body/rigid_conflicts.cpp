#include <array>

#include "base/formatted.hpp"
#include "body/conflicts.hpp"
#include "body/edges.hpp"
#include "body/imposed.hpp"

namespace reye::body {

namespace {

/// Whether both supports of one motion impose equal values, and neither is a force.
bool agree(const Motion& a, const Motion& b) {
  Imposed of_a, of_b;
  add(of_a, a, 1.0);
  add(of_b, b, 1.0);
  return a.drive != Drive::loaded && b.drive != Drive::loaded && same(of_a, of_b);
}

}  // namespace

std::vector<SupportConflict> rigid_support_conflicts(const mesh::Mesh& mesh, const BodyInput& input) {
  const bool axisymmetric = input.analysis == base::Analysis::axisymmetric;
  std::vector<SupportConflict> found;
  std::array<const Support*, 3> first{};
  for (int s = 0; s < static_cast<int>(input.supports.size()); ++s)
    for (int m = 0; m < 3; ++m) {
      const Support& support = input.supports[s];
      const Motion& motion = motion_of(support, m);
      if (motion.drive == Drive::free) continue;
      if (axisymmetric && m != 1 && drives(motion)) {
        found.push_back({s, motion_names[m],
                         m == 0 ? "a rigid ring cannot move radially; only a deformable one can"
                                : "a rigid ring cannot turn out of its plane"});
      } else if (!first[m]) {
        first[m] = &support;
      } else if (!agree(motion, motion_of(*first[m], m))) {
        found.push_back({s, motion_names[m],
                         "support " + base::quoted(first[m]->name) +
                             " drives the same motion of this rigid body another "
                             "way; a rigid body has one of each"});
      }
    }
  if (!first[2] || !drives(first[2]->rotation)) return found;
  for (int s = 0; s < static_cast<int>(input.supports.size()); ++s)
    if (const Support& support = input.supports[s];
        !is_rigid(support) && holds_rotation(mesh, support, place_support(mesh, support)))
      found.push_back({s, "",
                       "holds the edge node by node, and with it the rotation that support " +
                           base::quoted(first[2]->name) + " drives; hold a point, or name the rotation here"});
  return found;
}

}  // namespace reye::body
