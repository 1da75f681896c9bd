#pragma once
#include "sim/problem/problem.hpp"

namespace reye::sim {

/// Whether the current shape of a body may become its X: it is finitely strained, does not wear (removed volumes are
/// unstressed), and only edges held or moved along fixed axes and pressures on whole edges refer to its X.
bool can_renew(const Problem& problem, int body);

}  // namespace reye::sim
