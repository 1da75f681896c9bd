#include "wear/law.hpp"

#include <cmath>

namespace reye::wear {

double Ledger::relative_error(const Law& law) const {
  const double should = (law.secondary + law.primary) * work;
  if (should <= 0.0) return 0.0;
  return std::abs(removed_secondary + removed_primary - should) / should;
}

}  // namespace reye::wear
