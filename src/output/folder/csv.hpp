#pragma once
#include <string>
#include <string_view>
#include <vector>

/// Cells of a CSV table (RFC 4180), one record to a line.
namespace reye::output {

/// A text as a cell: quoted where it must be, control characters turned into blanks. One that a spreadsheet would take
/// for a formula, because it begins with = + - @ and is not a number, gets an apostrophe before it.
std::string csv_field(std::string_view text);

/// The cells of a line, as they were before csv_field.
std::vector<std::string> csv_cells(std::string_view line);

/// The whole cell as a number; throws std::runtime_error when it is not one.
double csv_number(std::string_view cell);

}  // namespace reye::output
