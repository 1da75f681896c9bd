#include "output/run/sweep_table.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "base/printable.hpp"
#include "output/folder/csv.hpp"
#include "output/folder/files.hpp"
#include "output/folder/text.hpp"

namespace reye::output {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

/// Parts of the summary that hold numbers; times, which differ from run to run, come last.
constexpr const char* parts[] = {"cycles",          "contacts", "bonds",  "probes", "life_cycles", "life_band",
                                 "estimated_error", "counts",   "wall_s", "cpu_s",  "peak_rss_MB"};

void add_figures(const Json& value, const std::string& name, RunEnd& end) {
  if (value.is_object())
    for (const auto& [below, child] : value.items()) add_figures(child, name + '.' + below, end);
  else if (value.is_array())
    for (std::size_t k = 0; k < value.size(); ++k) add_figures(value[k], name + '[' + std::to_string(k) + ']', end);
  else if (value.is_number() || value.is_null())
    end.figures.emplace_back(name, value.is_null() ? "" : value.dump());
}

std::string text_of(const Json& summary, const char* key) {
  if (!summary.is_object()) return {};
  const auto found = summary.find(key);
  return found != summary.end() && found->is_string() ? found->get<std::string>() : "";
}

/// A text without its quotes.
std::string plain(const std::string& value) {
  return value.size() >= 2 && value.front() == '"' && value.back() == '"' ? value.substr(1, value.size() - 2) : value;
}

/// Names of all numbers; one that only some members have comes after the one it follows there.
std::vector<std::string> columns_of(const std::vector<SweepRow>& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows) {
    auto next = names.begin();
    for (const auto& [name, value] : row.end.figures) {
      const auto found = std::find(names.begin(), names.end(), name);
      next = (found == names.end() ? names.insert(next, name) : found) + 1;
    }
  }
  return names;
}

/// A number of a row; empty where it has none.
std::optional<double> figure(const SweepRow& row, const std::string& name) {
  for (const auto& [known, value] : row.end.figures)
    if (known == name && !value.empty()) return csv_number(value);
  return {};
}

}  // namespace

RunEnd read_end(const std::string& dir) {
  const auto file = fs::path(dir) / "summary.json";
  std::error_code unreadable;
  if (!fs::exists(file, unreadable)) return {};
  RunEnd damaged{"damaged", base::printable(file.string()) + " cannot be read", {}, {}};
  try {
    const Json summary = Json::parse(read_text(file.string()), nullptr, false);
    RunEnd end{text_of(summary, "status"), text_of(summary, "reason"), text_of(summary, "scene_sha256"), {}};
    if (end.status.empty()) return damaged;
    if (const auto warnings = summary.find("warnings"); warnings != summary.end() && warnings->is_array())
      end.figures.emplace_back("warnings", std::to_string(warnings->size()));
    for (const auto* part : parts)
      if (const auto found = summary.find(part); found != summary.end() && !found->is_null())
        add_figures(*found, part, end);
    return end;
  } catch (const std::exception&) {
    return damaged;
  }
}

std::string sweep_table(const std::vector<std::string>& keys, const std::vector<SweepRow>& rows) {
  const auto columns = columns_of(rows);
  std::string text = "member";
  for (const auto& key : keys) text += ',' + csv_field(key);
  text += ",status,reason";
  for (const auto& column : columns) text += ',' + csv_field(column);
  text += '\n';
  for (const auto& row : rows) {
    text += row.member;
    for (const auto& value : row.values) text += ',' + csv_field(plain(value));
    text += ',' + csv_field(row.end.status) + ',' + csv_field(row.end.reason);
    for (const auto& column : columns) {
      const auto found = std::find_if(row.end.figures.begin(), row.end.figures.end(),
                                      [&](const auto& figure) { return figure.first == column; });
      text += ',' + (found == row.end.figures.end() ? std::string() : found->second);
    }
    text += '\n';
  }
  return text;
}

std::vector<std::string> life_bands(const std::vector<SweepRow>& rows) {
  constexpr std::string_view lives = "life_cycles.";
  std::vector<std::string> sentences;
  for (const auto& column : columns_of(rows)) {
    if (!column.starts_with(lives)) continue;
    const auto limit = column.substr(lives.size());
    double shortest = std::numeric_limits<double>::infinity(), longest = 0.0;
    std::size_t reached = 0;
    for (const auto& row : rows) {
      const auto life = figure(row, column);
      if (!life) continue;
      ++reached;
      shortest = std::min(shortest, figure(row, "life_band." + limit + ".shortest_cycles").value_or(*life));
      longest = std::max(longest, figure(row, "life_band." + limit + ".longest_cycles").value_or(*life));
    }
    const auto missed = rows.size() - reached;
    auto sentence = "limit " + limit + ": ";
    if (reached > 0) sentence += "life " + rounded(shortest, 6) + " to " + rounded(longest, 6) + " cycles";
    if (missed > 0)
      sentence += std::string(reached > 0 ? "; " : "") + "not reached by " + std::to_string(missed) + " of " +
                  std::to_string(rows.size()) + " members";
    sentences.push_back(sentence);
  }
  return sentences;
}

}  // namespace reye::output
