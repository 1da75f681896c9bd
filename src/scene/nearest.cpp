#include "scene/nearest.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace reye::scene {

namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// Levenshtein distance, upper and lower case alike.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const auto change = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({change, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

/// `E` for `E_MPa`: the unit forgotten.
bool is_stem(const std::string& name, const std::string& known) {
  return known.size() > name.size() && known.starts_with(name) && known[name.size()] == '_';
}

std::string joined(const std::vector<std::string>& names, const std::string& quote) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + quote + name + quote;
  return text;
}

}  // namespace

std::string nearest(const std::string& name, const std::vector<std::string>& names) {
  std::string best;
  std::size_t least = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (const auto& known : names) {
    const auto far = is_stem(name, known) ? 1 : distance(name, known);
    if (far < least && far < std::max(name.size(), known.size())) {
      least = far;
      best = known;
    }
  }
  return best;
}

std::string unknown_rule(const std::string& name, const Spec& place) {
  std::vector<std::string> names;
  for (const auto& [known, child] : place.named)
    if (!child->key || child->key->type != Type::refused) names.push_back(known);
  const auto meant = nearest(name, names);
  if (!meant.empty()) return "unknown key; did you mean " + meant + "?";
  return "unknown key; known here: " + joined(names, "");
}

std::string unknown_name_rule(const std::string& what, const std::string& name, const std::vector<std::string>& names) {
  const auto start = "there is no " + what + " \"" + name + "\"";
  const auto meant = nearest(name, names);
  if (!meant.empty()) return start + "; did you mean \"" + meant + "\"?";
  return start + (names.empty() ? "" : "; known: " + joined(names, "\""));
}

}  // namespace reye::scene
