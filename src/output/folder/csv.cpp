#include "output/folder/csv.hpp"

#include <charconv>
#include <optional>
#include <stdexcept>

#include "base/printable.hpp"

namespace reye::output {

namespace {

constexpr std::string_view begins_formula = "=+-@";

std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc{} || result.ptr != end) return {};
  return value;
}

/// Whether a spreadsheet would read the text as a formula, even after blanks; existing apostrophes count, so that they
/// are restored.
bool looks_like_formula(std::string_view text) {
  const auto first = text.find_first_not_of(" '");
  return first != std::string_view::npos && begins_formula.find(text[first]) != std::string_view::npos &&
         !number_in(text);
}

}  // namespace

std::string csv_field(std::string_view text) {
  std::string plain;
  for (const char c : text) plain += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
  if (looks_like_formula(plain)) plain.insert(plain.begin(), '\'');
  if (plain.find_first_of("\",;") == std::string::npos) return plain;
  std::string field = "\"";
  for (const char c : plain) field += c == '"' ? std::string("\"\"") : std::string(1, c);
  return field + '"';
}

std::vector<std::string> csv_cells(std::string_view line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"')
      cells.back() += line[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      cells.emplace_back();
    else
      cells.back() += c;
  }
  for (auto& cell : cells)
    if (cell.starts_with('\'') && looks_like_formula(std::string_view(cell).substr(1))) cell.erase(0, 1);
  return cells;
}

double csv_number(std::string_view cell) {
  const auto value = number_in(cell);
  if (!value) throw std::runtime_error("'" + base::printable(cell) + "' is not a number");
  return *value;
}

}  // namespace reye::output
