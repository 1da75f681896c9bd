#pragma once
#include <string>

#include "base/issue.hpp"

namespace reye::base {

/// "key = value: rule" as one printable line; empty parts are left out.
std::string in_words(const Issue& issue);

}  // namespace reye::base
