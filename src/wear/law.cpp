#include "wear/law.hpp"

#include <cmath>

namespace reye::wear {

double Ledger::relative_error() const {
  if (asked <= 0.0) return 0.0;
  return std::abs(removed_secondary + removed_primary - asked) / asked;
}

}  // namespace reye::wear
