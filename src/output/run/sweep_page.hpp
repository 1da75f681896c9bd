#pragma once
#include <string>
#include <vector>

#include "output/run/sweep_table.hpp"

namespace reye::output {

/// sweep.html: for each key varied, the lives and the largest depths against it, and of solids pressure, area, forces
/// and energy of their contacts, a line for each choice of the other keys; then a row per member with a link to its
/// page. A key whose values are no numbers counts them, and says which is which.
std::string sweep_page(const std::string& title, const std::vector<std::string>& keys,
                       const std::vector<SweepRow>& rows);

}  // namespace reye::output
