#include "output/run/calibration_page.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "output/folder/text.hpp"
#include "output/report/html.hpp"
#include "output/report/profiles.hpp"

namespace reye::output {

namespace {

using base::Vec2;
using scene::ScarSide;

const char* side_word(ScarSide side) { return side == ScarSide::primary ? "primary" : "secondary"; }

std::string place_words(const scene::ScarPlace& of) {
  return of.contact + ", " + side_word(of.side) + ", cycle " + rounded(of.cycles, 6);
}

const char* axis_word(scene::ScarAxis axis) {
  constexpr const char* words[] = {"x, mm", "y, mm", "z, mm", "arc length, mm"};
  return words[static_cast<std::size_t>(axis)];
}

/// A scar with the instrument's offset and tilt taken off, in the places of the scene.
struct Levelled {
  std::vector<Vec2> at;
  std::vector<double> measured, computed;  ///< mm
};

Levelled levelled(const scene::MeasuredScar& scar, const fit::SeriesFit& fit) {
  Levelled result;
  for (std::size_t i = 0; i < scar.at.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double instrument = fit.offset + fit.tilt.dot(scar.at[i]);
    result.at.push_back(scar.at[i] + fit.shift);
    result.measured.push_back(scar.depth_mm[row] - instrument);
    result.computed.push_back(fit.fitted[row] - instrument);
  }
  return result;
}

/// The rows of a profile, or those of a map within a strip along `axis` through the deepest computed place.
std::vector<std::size_t> section(const Levelled& scar, bool map, int axis) {
  std::vector<std::size_t> rows(scar.at.size());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i;
  if (!map) return rows;
  const auto deepest =
      static_cast<std::size_t>(std::max_element(scar.computed.begin(), scar.computed.end()) - scar.computed.begin());
  Vec2 low = scar.at.front(), high = low;
  for (const auto& p : scar.at) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double strip = std::sqrt((high - low).prod() / static_cast<double>(scar.at.size()));
  std::erase_if(rows,
                [&](std::size_t i) { return std::abs(scar.at[i][1 - axis] - scar.at[deepest][1 - axis]) > strip; });
  std::sort(rows.begin(), rows.end(),
            [&](std::size_t a, std::size_t b) { return scar.at[a][axis] < scar.at[b][axis]; });
  return rows;
}

Figure figure_of(const scene::MeasuredScar& scar, const fit::SeriesFit& fit, std::size_t number, int axis) {
  const Levelled all = levelled(scar, fit);
  const bool map = scar.axes.size() > 1;
  const Unit unit = length_unit(largest(all.computed));
  Line measured{.label = "measured", .colour = line_colour(1), .width = 0.8},
      computed{.label = "computed", .colour = line_colour(0), .width = 2.2};
  for (const auto i : section(all, map, axis)) {
    measured.x.push_back(all.at[i][axis]);
    measured.y.push_back(unit.factor * all.measured[i]);
    computed.x.push_back(all.at[i][axis]);
    computed.y.push_back(unit.factor * all.computed[i]);
  }
  const auto id = "scar-" + std::to_string(number) + (map ? axis == 0 ? "-a" : "-b" : "");
  return {.id = id,
          .title = place_words(scar.of) + (map ? ", section through the deepest place" : ""),
          .x_label = axis_word(scar.axes[static_cast<std::size_t>(axis)]),
          .y_label = "depth, " + unit.name,
          .lines = {std::move(measured), std::move(computed)},
          .y_down = true};
}

std::string interval(double low, double high) { return rounded(low) + " to " + rounded(high); }

std::string value_table(const sim::Calibration& c) {
  std::vector<Row> rows;
  for (const auto& k : c.values) rows.push_back({k.key, rounded(k.scene), rounded(k.fitted), interval(k.low, k.high)});
  return html_table({"key", "in the scene", "fitted", "95 % interval"}, rows);
}

std::string scar_table(const sim::Calibration& c) {
  std::vector<Row> rows;
  for (std::size_t s = 0; s < c.measured.scars.size(); ++s) {
    const auto& scar = c.measured.scars[s];
    const auto& fit = c.estimate.series[s];
    const Levelled all = levelled(scar, fit);
    rows.push_back({scar.file, place_words(scar.of), rounded(1e3 * largest(all.computed)), rounded(1e3 * fit.residual),
                    rounded(1e3 * fit.scatter), fit.correlation_mm > 0.0 ? rounded(fit.correlation_mm) : "–",
                    rounded(1e3 * fit.offset), rounded(1e3 * fit.tilt.x()), rounded(fit.shift.x())});
  }
  return html_table({"file", "scar", "computed depth, µm", "residual, µm", "scatter, µm", "its correlation length, mm",
                     "offset, µm", "tilt, µm/mm", "moved by, mm"},
                    rows, {1});
}

std::string number_table(const sim::Calibration& c) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < c.measured.figures.size(); ++i) {
    const auto& figure = c.measured.figures[i];
    const double computed = c.estimate.series[c.measured.scars.size() + i].fitted[0];
    constexpr const char* words[] = {"largest depth, mm", "width, mm", "worn area or volume", "energy of a cycle"};
    rows.push_back({place_words(figure.of), words[static_cast<std::size_t>(figure.what)], rounded(figure.value),
                    rounded(computed), rounded(100.0 * (computed / figure.value - 1.0), 3)});
  }
  return html_table({"scar", "number", "measured", "computed", "difference, %"}, rows, {1});
}

std::string list_of(const std::vector<std::string>& sentences) {
  std::string html;
  for (const auto& sentence : sentences) html += "<li>" + escaped(sentence) + "</li>\n";
  return html.empty() ? html : "<ul>\n" + html + "</ul>\n";
}

nlohmann::ordered_json json_of(const scene::ScarPlace& of) {
  return {{"contact", of.contact}, {"side", side_word(of.side)}, {"cycles", of.cycles}};
}

}  // namespace

std::vector<Figure> calibration_figures(const sim::Calibration& calibration) {
  std::vector<Figure> figures;
  const auto& scars = calibration.measured.scars;
  for (std::size_t s = 0; s < scars.size(); ++s)
    for (int axis = 0; axis < static_cast<int>(scars[s].axes.size()); ++axis)
      figures.push_back(figure_of(scars[s], calibration.estimate.series[s], s, axis));
  return figures;
}

std::string calibration_page(const std::string& title, const sim::Calibration& c) {
  std::string body = "<h1>" + escaped(title) + "</h1>\n<p class=\"quiet\">Wear coefficients from measured scars · " +
                     std::to_string(c.runs) + (c.runs == 1 ? " run · reye " : " runs · reye ") + version + "</p>\n";
  if (!c.estimate.poor.empty())
    body += "<div class=\"warnings\"><h2>The fit is poor</h2>\n" + list_of({c.estimate.poor}) + "</div>\n";
  body += "<h2>Values</h2>\n" + value_table(c) + list_of(c.notes);
  body += figure_grid("Measured and computed", calibration_figures(c));
  if (const auto table = scar_table(c); !table.empty()) body += "<h2>Scars</h2>\n" + table;
  if (const auto table = number_table(c); !table.empty()) body += "<h2>Numbers</h2>\n" + table;
  return html_page(title, body);
}

std::string calibration_json(const std::string& title, const sim::Calibration& c) {
  nlohmann::ordered_json json{{"title", title}, {"version", version}};
  for (const auto& k : c.values)
    json["values"].push_back(
        {{"key", k.key}, {"scene", k.scene}, {"fitted", k.fitted}, {"low_95", k.low}, {"high_95", k.high}});
  if (c.scales) json["wear_factor"] = {c.low, c.high};
  json["poor"] = c.estimate.poor.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(c.estimate.poor);
  json["notes"] = c.notes;
  for (std::size_t s = 0; s < c.measured.scars.size(); ++s) {
    const auto& fit = c.estimate.series[s];
    auto scar = json_of(c.measured.scars[s].of);
    scar.update({{"file", c.measured.scars[s].file},
                 {"residual_mm", fit.residual},
                 {"scatter_mm", fit.scatter},
                 {"correlation_mm", fit.correlation_mm},
                 {"offset_mm", fit.offset},
                 {"tilt", {fit.tilt.x(), fit.tilt.y()}},
                 {"moved_mm", {fit.shift.x(), fit.shift.y()}}});
    json["scars"].push_back(std::move(scar));
  }
  for (std::size_t i = 0; i < c.measured.figures.size(); ++i) {
    auto figure = json_of(c.measured.figures[i].of);
    constexpr const char* words[] = {"depth_mm", "width_mm", "worn", "energy"};
    figure.update({{"what", words[static_cast<std::size_t>(c.measured.figures[i].what)]},
                   {"measured", c.measured.figures[i].value},
                   {"computed", c.estimate.series[c.measured.scars.size() + i].fitted[0]}});
    json["figures"].push_back(std::move(figure));
  }
  json["runs"] = c.runs;
  json["increments"] = c.increments;
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace reye::output
