#pragma once
#include <string>
#include <string_view>

namespace reye::output {

/// The program's version, as written to summary and checkpoint.
inline constexpr const char* version = "0.1.0";

/// Shortest text that reads back to the same double.
std::string number(double value);

/// "10³", "10⁻⁴"
std::string power_of_ten(int exponent);

/// For readers: a few significant digits; powers of ten outside 1e-3 .. 1e6.
std::string rounded(double value, int digits = 4);

/// A name as part of a file name: everything but letters, digits, '.', '-' and '_' becomes '_'.
std::string file_part(std::string_view name);

/// Text inside XML or HTML; characters that XML forbids are dropped, bytes that are not UTF-8 replaced by U+FFFD.
std::string escaped(std::string_view text);

}  // namespace reye::output
