#pragma once
#include "sim/problem.hpp"

namespace reye::sim {

/// Whether the current shape of a body may become its X: it is finitely strained, does not wear (removed volumes are
/// unstressed), and nothing of it is counted on X but edges held or moved along fixed axes and pressures on whole
/// edges.
bool can_renew(const Problem& problem, int body);

}  // namespace reye::sim
