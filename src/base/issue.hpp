#pragma once
#include <string>

namespace reye::base {

/// One error of the input: the key it belongs to ("material.steel.nu"), its value as written
/// (empty if the key itself is the fault), and the rule it breaks.
struct Issue {
  std::string key;
  std::string value;
  std::string rule;
};

}  // namespace reye::base
