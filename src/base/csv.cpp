#include "base/csv.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

#include "base/errors.hpp"

namespace reye::base {

namespace {

[[noreturn]] void refuse(const std::string& rule) { throw InputError({{"", "", rule}}); }

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// The number that fills the text; nothing if it is not a number.
std::optional<double> number(const std::string& text) {
  const std::string word = trimmed(text);
  const char* begin = word.data() + (word.starts_with('+') ? 1 : 0);
  double value = 0.0;
  const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  std::size_t from = 0;
  for (std::size_t comma; (comma = row.find(',', from)) != std::string::npos; from = comma + 1)
    cells.push_back(trimmed(row.substr(from, comma - from)));
  cells.push_back(trimmed(row.substr(from)));
  return cells;
}

std::string must_be(std::size_t columns) {
  if (columns == 1) return "must be a number";
  const std::string count = columns == 2 ? "two" : std::to_string(columns);
  return "must be " + count + " numbers with " + (columns == 2 ? "a comma" : "commas") + " between them";
}

}  // namespace

int NumberTable::column(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

NumberTable parse_numbers(const std::string& csv, const std::string& header) {
  constexpr const char* byte_order_mark = "\xEF\xBB\xBF";
  std::istringstream text(csv.starts_with(byte_order_mark) ? csv.substr(3) : csv);
  std::string row;
  std::getline(text, row);
  if (!header.empty() && trimmed(row) != header) refuse("its first line must be " + header);
  if (row.find(';') != std::string::npos)
    refuse("line 1: its columns are separated by ';'; write commas between columns, and decimal points");
  NumberTable table;
  table.names = cells_of(row);
  for (int line = 2; std::getline(text, row); ++line) {
    if (trimmed(row).empty()) continue;
    const auto refuse_row = [line](const std::string& rule) { refuse("line " + std::to_string(line) + ": " + rule); };
    const auto cells = cells_of(row);
    NumberTable::Row numbers{line, {}};
    for (const auto& cell : cells) {
      const auto value = number(cell);
      if (!value || cells.size() != table.names.size()) refuse_row(must_be(table.names.size()));
      if (!std::isfinite(*value)) refuse_row("must be finite");
      numbers.values.push_back(*value);
    }
    table.rows.push_back(std::move(numbers));
  }
  return table;
}

}  // namespace reye::base
