#include "solver/solid/point_rows.hpp"

namespace reye::solver {

void add_rows(const ClosedPoint& at, const contact::SkinFrame& frame, const contact::SkinNode& node,
              contact::SkinStatus status, std::vector<ReducedRow>& rows) {
  const auto& [c, j, stiffness, mu] = at;
  const bool slips = status == contact::SkinStatus::slip;
  const auto slip = slips ? contact::slip_step(node, frame, mu, stiffness) : contact::SlipStep{};
  const bool pressed = node.traction.dot(frame.normal) > 0.0;
  rows.push_back({c, j, frame.normal, stiffness * frame.normal, 0.0, -stiffness * node.gap});
  if (slips && (pressed || mu > 0.0)) rows.back().along += mu * slip.d;
  if (slips && frame.free == 2)
    rows.push_back({c, j, slip.e, -slip.share * stiffness * slip.e, 1.0 - slip.share, node.traction.dot(slip.e), true});
  if (!slips && mu > 0.0)
    for (int k = 0; k < frame.free; ++k)
      rows.push_back({c, j, frame.tangent[k], stiffness * frame.tangent[k], 0.0,
                      stiffness * frame.tangent[k].dot(node.slip), true});
}

}  // namespace reye::solver
