#include "scene/sweep.hpp"

#include <charconv>
#include <cmath>
#include <optional>

#include "scene/check.hpp"
#include "scene/key_rule.hpp"
#include "scene/read.hpp"
#include "scene/rewrite.hpp"

namespace reye::scene {

namespace {

constexpr const char* option = "--vary";
constexpr double most_members = 1e5;

/// The error of one `--vary`.
base::InputError wrong(const std::string& words, const std::string& rule) {
  return base::InputError({{option, words, rule}});
}

std::optional<double> number_of(const std::string& text) {
  double value = 0.0;
  const auto* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  const bool fits = result.ec == std::errc{} && result.ptr == end && std::isfinite(value);
  return fits ? std::optional(value) : std::nullopt;
}

/// Parts between commas outside of brackets and quotes.
std::vector<std::string> listed(const std::string& text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  char quote = 0;
  for (const char c : text) {
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else {
      depth += (c == '[' || c == '{') - (c == ']' || c == '}');
    }
    if (c == ',' && depth == 0 && quote == 0)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

std::string as_written(const std::string& value) {
  const bool flag = value == "true" || value == "false";
  const bool marked = std::string("[{\"'").find(value.front()) != std::string::npos;
  return flag || marked || number_of(value) ? value : quoted(value);
}

constexpr const char* range_rule =
    "must be key=a:b:n or key=log:a:b:n, numbers a and b (for log both > 0) and a whole number n >= 2, "
    "or key=v1,v2,...";

/// The numbers of a range; empty when it is not a range.
std::vector<std::string> numbers_of(std::vector<std::string> parts) {
  const bool logarithmic = parts.front() == "log";
  if (logarithmic) parts.erase(parts.begin());
  if (parts.size() != 3) return {};
  const auto a = number_of(parts[0]), b = number_of(parts[1]), count = number_of(parts[2]);
  if (!a || !b || !count || *count < 2.0 || *count > most_members || std::rint(*count) != *count) return {};
  if (logarithmic && (*a <= 0.0 || *b <= 0.0)) return {};
  std::vector<std::string> values;
  for (double i = 0.0; i < *count; i += 1.0) {
    const double part = i / (*count - 1.0);
    const double between = logarithmic ? *a * std::pow(*b / *a, part) : *a + (*b - *a) * part;
    values.push_back(shown(i == 0.0 ? *a : part == 1.0 ? *b : between));
  }
  return values;
}

/// An issue for each value that the text cannot take.
void check_places(const std::string& text, const Variation& variation, Issues& issues) {
  for (const auto& value : variation.values)
    if (!with_value(text, variation.key, value))
      issues.push_back({option, variation.key + '=' + value, "cannot be put there"});
}

/// Checks one variation of a text, and adds it to those found.
void check_variation(const std::string& words, const Node& root, const std::string& text, const Spec& keys,
                     std::vector<Variation>& found, Issues& issues) {
  auto variation = variation_of(words);
  auto rule = key_rule(variation.key, root, keys);
  for (const auto& other : found)
    if (other.key == variation.key) rule = "varies " + other.key + " a second time";
  if (rule.empty())
    check_places(text, variation, issues);
  else
    issues.push_back({option, words, rule});
  found.push_back(std::move(variation));
}

void check_members(const std::vector<Variation>& variations, Issues& issues) {
  double members = 1.0;
  for (const auto& variation : variations) members *= static_cast<double>(variation.values.size());
  if (members > most_members)
    issues.push_back({option, "", "a sweep may have at most " + shown(most_members) + " members"});
}

/// All variations, each with a key that the scene can take; all errors are thrown at once.
std::vector<Variation> checked(const std::vector<std::string>& variations, const std::string& text, const Spec& keys) {
  const auto root = parse(text);
  std::vector<Variation> good;
  Issues issues;
  for (const auto& words : variations) {
    try {
      check_variation(words, root, text, keys, good, issues);
    } catch (const base::InputError& error) {
      issues.insert(issues.end(), error.issues().begin(), error.issues().end());
    }
  }
  if (variations.empty()) issues.push_back({option, "", "missing; a sweep varies at least one key"});
  check_members(good, issues);
  if (!issues.empty()) throw base::InputError(std::move(issues));
  return good;
}

std::string member_text(const std::string& text, const std::string& path, const std::vector<Variation>& variations,
                        const std::vector<std::string>& values) {
  auto member = text;
  for (std::size_t v = 0; v < variations.size(); ++v) {
    auto changed = with_value(member, variations[v].key, values[v]);
    if (!changed) throw wrong(variations[v].key + '=' + values[v], "cannot be put there beside the other variations");
    member = std::move(*changed);
  }
  return with_absolute_paths(std::move(member), path);
}

/// Values of the member with this number; the last variation runs fastest.
std::vector<std::string> values_at(std::size_t number, const std::vector<Variation>& variations) {
  std::vector<std::string> values(variations.size());
  for (std::size_t v = variations.size(); v-- > 0; number /= variations[v].values.size())
    values[v] = variations[v].values[number % variations[v].values.size()];
  return values;
}

}  // namespace

Variation variation_of(const std::string& words) {
  const auto equals = words.find('=');
  if (equals == std::string::npos || equals == 0) throw wrong(words, "must be key=a:b:n or key=v1,v2,...");
  Variation variation{words.substr(0, equals), {}};
  const auto values = words.substr(equals + 1);
  const bool range = values.find(':') != std::string::npos && values.find_first_of("[{\"'") == std::string::npos;
  if (range) {
    variation.values = numbers_of(split(values, ':'));
    if (variation.values.empty()) throw wrong(words, range_rule);
    return variation;
  }
  for (const auto& value : listed(values)) {
    if (value.empty()) throw wrong(words, "a value is empty");
    variation.values.push_back(as_written(value));
  }
  return variation;
}

Sweep sweep_of(const std::string& text, const std::string& path, const std::vector<std::string>& words,
               const Spec& keys) {
  const auto variations = checked(words, text, keys);
  Sweep sweep;
  std::size_t count = 1;
  for (const auto& variation : variations) {
    sweep.keys.push_back(variation.key);
    count *= variation.values.size();
  }
  for (std::size_t i = 0; i < count; ++i) {
    auto values = values_at(i, variations);
    auto member = member_text(text, path, variations, values);
    sweep.members.push_back({std::move(values), std::move(member)});
  }
  return sweep;
}

Sweep sweep_of(const std::string& path, const std::vector<std::string>& words, const Spec& keys) {
  return sweep_of(text_of(path), path, words, keys);
}

Sweep sweep_of(const std::string& path, const std::vector<std::string>& words) {
  read_text(text_of(path), path);
  return sweep_of(path, words, spec());
}

}  // namespace reye::scene
