#pragma once
#include <string>

namespace reye::base {

/// What printf would print, at its full length; arguments are checked against `format` at compile time.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

/// What %.*f prints, several times faster: for the thousands of points of a figure.
std::string fixed(double value, int decimals);

/// Appends a value, rounded to one decimal, several times faster still: for the edges of a drawn mesh. |value| < 1e15.
void append_tenths(double value, std::string& text);

/// A name between double quotes.
inline std::string quoted(const std::string& name) { return '"' + name + '"'; }

}  // namespace reye::base
