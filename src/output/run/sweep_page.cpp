#include "output/run/sweep_page.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "output/folder/csv.hpp"
#include "output/folder/text.hpp"
#include "output/report/html.hpp"
#include "output/report/profiles.hpp"

namespace reye::output {

namespace {

/// A number of the members that is drawn against keys.
struct Drawn {
  std::string name, title, label;  ///< place in the summary, and words for readers
  double factor = 1.0;
};

std::optional<double> number_of(const SweepRow& row, const std::string& name) {
  for (const auto& [known, value] : row.end.figures)
    if (known == name && !value.empty()) return csv_number(value);
  return {};
}

/// The words between two parts of a name; empty where it is another.
std::string between(std::string_view name, std::string_view before, std::string_view after) {
  const bool so = name.starts_with(before) && name.ends_with(after) && name.size() > before.size() + after.size();
  return so ? std::string(name.substr(before.size(), name.size() - before.size() - after.size())) : std::string();
}

double largest_of(const std::vector<SweepRow>& rows, const std::string& name) {
  double most = 0.0;
  for (const auto& row : rows) most = std::max(most, number_of(row, name).value_or(0.0));
  return most;
}

/// Numbers of a contact of solids, by the ends of their names, with words for readers.
struct OfSolids {
  std::string_view ending, title, label;
};

constexpr OfSolids of_solids[] = {{".peak_pressure_MPa", "Largest pressure", "pressure, MPa"},
                                  {".contact_area_mm2", "Area in contact", "area, mm²"},
                                  {".equivalent_radius_mm", "Radius of a circle of the area", "radius, mm"},
                                  {".normal_force_N", "Normal force", "force, N"},
                                  {".tangential_force_N", "Tangential force", "force, N"},
                                  {".dissipated_energy_mJ", "Energy dissipated", "energy, mJ"}};

std::optional<Drawn> drawn_life(const std::string& name) {
  const auto limit = between(name, "life_cycles.", "");
  return limit.empty() ? std::nullopt : std::optional(Drawn{name, "Life, limit " + limit, "cycles"});
}

std::optional<Drawn> drawn_depth(const std::vector<SweepRow>& rows, const std::string& name) {
  const auto side = between(name, "contacts.", ".max_depth_mm");
  if (side.empty()) return {};
  const Unit unit = length_unit(largest_of(rows, name));
  return Drawn{name, "Largest depth, " + side, "depth, " + unit.name, unit.factor};
}

/// Of a contact of solids, which has an area.
std::optional<Drawn> drawn_of_solids(const SweepRow& row, const std::string& name) {
  for (const auto& [ending, title, label] : of_solids)
    if (const auto contact = between(name, "contacts.", ending);
        !contact.empty() && number_of(row, "contacts." + contact + ".contact_area_mm2"))
      return Drawn{name, std::string(title) + ", " + contact, std::string(label)};
  return {};
}

/// The lives that a member reaches, the depths that are not zero and the numbers of contacts of solids, each in the
/// order of the summary.
std::vector<Drawn> drawn_of(const std::vector<SweepRow>& rows) {
  std::vector<Drawn> lives, depths, others;
  std::set<std::string> known;
  for (const auto& row : rows)
    for (const auto& [name, value] : row.end.figures) {
      if (known.contains(name) || largest_of(rows, name) <= 0.0) continue;
      const auto add = [&known](std::vector<Drawn>& list, std::optional<Drawn> drawn) {
        if (!drawn) return;
        known.insert(drawn->name);
        list.push_back(std::move(*drawn));
      };
      add(lives, drawn_life(name));
      add(depths, drawn_depth(rows, name));
      add(others, drawn_of_solids(row, name));
    }
  lives.insert(lives.end(), depths.begin(), depths.end());
  lives.insert(lives.end(), others.begin(), others.end());
  return lives;
}

/// The values of a key as positions on an axis.
struct Axis {
  std::string label;
  std::map<std::string, double> at;  ///< of the values as they are written
};

/// Whether values are spread over so many powers of ten that their logarithms show more.
bool wide(const std::map<std::string, double>& at) {
  constexpr double ratio = 50.0;
  double low = INFINITY, high = -INFINITY;
  for (const auto& [text, value] : at) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return low > 0.0 && high > ratio * low;
}

Axis axis_of(const std::string& key, const std::vector<std::string>& values) {
  Axis axis{key, {}};
  std::string numbered;
  for (const auto& value : values) {
    if (axis.at.contains(value)) continue;
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    const auto place = axis.at.size() + 1;
    numbered += (numbered.empty() ? "" : ", ") + std::to_string(place) + " = " + value;
    axis.at[value] = *end == '\0' && std::isfinite(number) ? number : NAN;
  }
  const bool numbers = std::none_of(axis.at.begin(), axis.at.end(), [](const auto& v) { return std::isnan(v.second); });
  if (!numbers) {
    axis.label = key + ": " + numbered;
    axis.at.clear();
    for (const auto& value : values) axis.at.try_emplace(value, static_cast<double>(axis.at.size() + 1));
  } else if (wide(axis.at)) {
    axis.label = "log₁₀ of " + key;
    for (auto& [text, value] : axis.at) value = std::log10(value);
  }
  return axis;
}

/// "friction = 0.6, jump = 100" of all keys but one; keys by their last words.
std::string others_of(const std::vector<std::string>& keys, const SweepRow& row, std::size_t but) {
  std::string words;
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (k != but) words += (words.empty() ? "" : ", ") + keys[k].substr(keys[k].rfind('.') + 1) + " = " + row.values[k];
  return words;
}

/// One figure of a number against a key.
Figure against(const std::vector<std::string>& keys, const std::vector<SweepRow>& rows, std::size_t key,
               const Drawn& drawn) {
  constexpr std::size_t most_labels = 8;
  std::vector<std::string> values;
  for (const auto& row : rows) values.push_back(row.values[key]);
  const Axis axis = axis_of(keys[key], values);
  std::map<std::string, std::map<double, double>> lines;
  for (const auto& row : rows)
    if (const auto value = number_of(row, drawn.name))
      lines[others_of(keys, row, key)][axis.at.at(row.values[key])] = drawn.factor * *value;
  Figure figure{.id = "sweep-" + file_part(keys[key]) + '-' + file_part(drawn.name),
                .title = drawn.title,
                .x_label = axis.label,
                .y_label = drawn.label,
                .y_from_zero = true};
  for (const auto& [others, points] : lines) {
    Line line{.colour = line_colour(figure.lines.size()), .dots = true};
    if (lines.size() > 1 && lines.size() <= most_labels) line.label = others;
    for (const auto& [x, y] : points) {
      line.x.push_back(x);
      line.y.push_back(y);
    }
    figure.lines.push_back(std::move(line));
  }
  return figure;
}

std::string member_table(const std::vector<std::string>& keys, const std::vector<SweepRow>& rows,
                         const std::vector<Drawn>& drawn) {
  Row head{"member"};
  for (const auto& key : keys) head.push_back(key);
  head.push_back("status");
  for (const auto& what : drawn) head.push_back(what.title + ", " + what.label.substr(what.label.rfind(' ') + 1));
  std::vector<Row> cells;
  std::vector<std::string> links;
  for (const auto& row : rows) {
    Row line{row.member};
    line.insert(line.end(), row.values.begin(), row.values.end());
    line.push_back(row.end.reason.empty() ? row.end.status : row.end.status + ": " + row.end.reason);
    for (const auto& what : drawn) {
      const auto value = number_of(row, what.name);
      line.push_back(value ? rounded(what.factor * *value, 5) : "–");
    }
    cells.push_back(std::move(line));
    links.push_back(row.member + "/report.html");
  }
  return html_table(head, cells, {keys.size() + 1}, links);
}

}  // namespace

std::string sweep_page(const std::string& title, const std::vector<std::string>& keys,
                       const std::vector<SweepRow>& rows) {
  const auto drawn = drawn_of(rows);
  std::string body = "<h1>" + escaped(title) + "</h1>\n<p class=\"quiet\">A sweep of " + std::to_string(rows.size()) +
                     " members · reye " + version + "</p>\n<ul>\n";
  for (const auto& sentence : life_bands(rows)) body += "<li>" + escaped(sentence) + "</li>\n";
  body += "</ul>\n";
  for (std::size_t key = 0; key < keys.size(); ++key) {
    std::vector<Figure> figures;
    for (const auto& what : drawn) figures.push_back(against(keys, rows, key, what));
    body += figure_grid("Against " + keys[key], figures);
  }
  return html_page(title, body + "<h2>Members</h2>\n" + member_table(keys, rows, drawn));
}

}  // namespace reye::output
