#include <charconv>
#include <cmath>
#include <sstream>

#include "base/errors.hpp"
#include "cad/build/profile.hpp"

namespace reye::cad {

namespace {

constexpr const char* header = "arc_length_mm,height_mm";

[[noreturn]] void refuse(const std::string& rule) { throw base::InputError({{"", "", rule}}); }

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// The number that fills the text, whatever the locale; nothing if it is not a number.
std::optional<double> number(const std::string& text) {
  const std::string word = trimmed(text);
  const char* begin = word.data() + (word.starts_with('+') ? 1 : 0);
  double value = 0.0;
  const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

void add_row(Profile& profile, const std::string& row, const std::string& place) {
  const auto comma = row.find(',');
  const auto arc = number(row.substr(0, comma));
  const auto height = comma == std::string::npos ? std::nullopt : number(row.substr(comma + 1));
  if (!arc || !height) refuse(place + "must be two numbers with a comma between them");
  if (!std::isfinite(*arc) || !std::isfinite(*height)) refuse(place + "must be finite");
  if (*arc < 0.0) refuse(place + "arc_length_mm must be >= 0");
  if (!profile.arc_mm.empty() && *arc <= profile.arc_mm.back()) refuse(place + "arc_length_mm must increase");
  profile.arc_mm.push_back(*arc);
  profile.height_mm.push_back(*height);
}

}  // namespace

Profile parse_profile(const std::string& csv) {
  constexpr const char* byte_order_mark = "\xEF\xBB\xBF";
  std::istringstream text(csv.starts_with(byte_order_mark) ? csv.substr(3) : csv);
  std::string row;
  std::getline(text, row);
  if (trimmed(row) != header) refuse("its first line must be " + std::string(header));
  Profile profile;
  for (int line = 2; std::getline(text, row); ++line)
    if (!trimmed(row).empty()) add_row(profile, row, "line " + std::to_string(line) + ": ");
  if (profile.arc_mm.size() < 2) refuse("needs at least two rows of numbers");
  return profile;
}

}  // namespace reye::cad
