#pragma once
#include "sim/problem/problem.hpp"
#include "sim/problem/system.hpp"

namespace reye::sim {

/// Decides between small and finite strain for the bodies that leave it to the run. A trial, with these bodies at small
/// strain and without wear, plays every step once: a body whose error passes the bound at the end of an increment is
/// finitely strained, and all are where the trial fails. The decision is written to the problem's scene, from which
/// `place` makes the same problem again.
void choose_kinematics(Problem& problem, Cache& cache);

}  // namespace reye::sim
