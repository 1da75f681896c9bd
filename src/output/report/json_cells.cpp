#include "output/report/json_cells.hpp"

#include <algorithm>
#include <cmath>

#include "output/folder/text.hpp"
#include "output/report/html.hpp"
#include "output/report/plot.hpp"

namespace reye::output {

using Json = nlohmann::ordered_json;

std::string json_cell(const Json& object, const std::string& key, int digits, double factor) {
  if (!object.is_object() || !object.contains(key) || !object[key].is_number()) return "–";
  return rounded(factor * object[key].get<double>(), digits);
}

const Json& json_part(const Json& object, const std::string& key) {
  static const Json none;
  return object.is_object() && object.contains(key) ? object[key] : none;
}

std::string page_section(const std::string& title, const std::string& body) {
  return body.empty() ? "" : "<div><h2>" + escaped(title) + "</h2>\n" + body + "</div>\n";
}

std::string sentence_list(const Json& sentences) {
  if (!sentences.is_array() || sentences.empty()) return {};
  std::string html = "<ul>\n";
  for (const auto& sentence : sentences)
    if (sentence.is_string()) html += "<li>" + escaped(sentence.get<std::string>()) + "</li>\n";
  return html + "</ul>\n";
}

std::string time_bars(const Json& rooms) {
  std::vector<Bar> bars;
  double total = 0.0;
  for (const auto& [room, seconds] : rooms.items())
    if (seconds.is_number()) bars.push_back({room, seconds.get<double>(), ""});
  for (const auto& bar : bars) total += bar.value;
  if (total <= 0.0) return {};
  std::stable_sort(bars.begin(), bars.end(), [](const Bar& a, const Bar& b) { return a.value > b.value; });
  for (auto& bar : bars)
    bar.text = rounded(bar.value, 3) + " s (" + rounded(std::round(1000.0 * bar.value / total) / 10.0, 3) + " %)";
  return "<figure>" + svg_bars(bars) + "</figure>\n";
}

}  // namespace reye::output
