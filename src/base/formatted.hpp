#pragma once
#include <string>

namespace reye::base {

/// What printf would print, at its full length; arguments are checked against `format` at compile time.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

/// What %.*f prints, several times faster: for the thousands of points of a figure.
std::string fixed(double value, int decimals);

/// A name between double quotes.
inline std::string quoted(const std::string& name) { return '"' + name + '"'; }

}  // namespace reye::base
