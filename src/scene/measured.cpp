#include "scene/measured.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "base/printable.hpp"
#include "scene/geometry_files.hpp"

namespace reye::scene {

namespace {

constexpr std::size_t most_points = 5'000'000, most_corners = 200'000;

/// Why a file cannot serve.
class Unfit : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

base::NumberTable table_of(const std::string& scene_path, const std::string& name, const std::string& header = {}) {
  const std::string file = beside(scene_path, name);
  constexpr std::uintmax_t most_bytes = 512 << 20;
  std::error_code error;
  if (std::filesystem::file_size(file, error) > most_bytes && !error) throw Unfit("is larger than 512 MB");
  if (auto rule = unreadable_rule(file); !rule.empty()) throw Unfit(rule);
  std::string bytes;
  if (!read_bytes(file, bytes)) throw Unfit("cannot be read");
  try {
    return base::parse_numbers(bytes, header);
  } catch (const base::InputError& error) {
    throw Unfit(error.issues().front().rule);
  }
}

/// A name of the file for a message, whatever bytes it has.
std::string shown_name(const std::string& name) {
  constexpr std::size_t most = 40;
  return base::printable(name.substr(0, most));
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 20;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i)
    text += (text.empty() ? "" : ", ") + shown_name(names[i]);
  return text + (names.size() > most ? ", ..." : "");
}

/// Times or progresses, and values, as the file has them.
History series_of(const base::NumberTable& table, const std::string& wanted) {
  const auto& names = table.names;
  if (names.front() != "time_s" && names.front() != "progress")
    throw Unfit("its first column must be time_s or progress, and is \"" + shown_name(names.front()) + '"');
  if (names.size() < 2) throw Unfit("needs a second column, of factors");
  const int column = wanted.empty() ? 1 : table.column(wanted);
  if (column < 1) throw Unfit("has no column \"" + wanted + "\" of factors, but " + listed(names));
  if (table.rows.size() < 2) throw Unfit("needs at least two rows of numbers");
  if (table.rows.size() > most_points) throw Unfit("has more than five million rows");
  History series;
  for (const auto& [line, values] : table.rows) {
    if (!series.empty() && values[0] <= series.back()[0])
      throw Unfit("line " + std::to_string(line) + ": " + names.front() + " must increase");
    series.push_back({values[0], values[static_cast<std::size_t>(column)]});
  }
  if (names.front() == "progress" && (series.front()[0] != 0.0 || series.back()[0] != 1.0))
    throw Unfit("progress must begin at 0 and end at 1");
  return series;
}

/// The way back to the first value, as long as a mean interval: the next period begins there.
void close(History& series) {
  if (series.back()[1] == series.front()[1]) return;
  const double interval = (series.back()[0] - series.front()[0]) / static_cast<double>(series.size() - 1);
  series.push_back({series.back()[0] + interval, series.front()[1]});
}

void make_progress(History& series) {
  const double start = series.front()[0], length = series.back()[0] - start;
  for (auto& point : series) point[0] = (point[0] - start) / length;
  series.back()[0] = 1.0;
}

/// Where a series turns by more than a band, and its last point: peaks are kept as they are.
std::vector<std::size_t> turns_of(const History& all, double band) {
  std::vector<std::size_t> turns;
  std::size_t low = 0, high = 0;
  int way = 0;  // of the series: 1 up, -1 down, 0 not known yet
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (all[i][1] > all[high][1]) high = i;
    if (all[i][1] < all[low][1]) low = i;
    if (way >= 0 && all[i][1] < all[high][1] - band) {
      if (high > 0) turns.push_back(high);
      way = -1;
      low = high = i;
    } else if (way <= 0 && all[i][1] > all[low][1] + band) {
      if (low > 0) turns.push_back(low);
      way = 1;
      low = high = i;
    }
  }
  turns.push_back(all.size() - 1);
  return turns;
}

/// The farthest point, not beyond `end`, to which a line from a point passes the bands of all between.
std::size_t farthest(const History& all, std::size_t from, std::size_t end, double band) {
  const auto& anchor = all[from];
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
  std::size_t last = from + 1;
  for (std::size_t i = from + 1; i <= end && least <= most; ++i) {
    const double length = all[i][0] - anchor[0], rise = all[i][1] - anchor[1];
    if (rise >= least * length && rise <= most * length) last = i;
    least = std::max(least, (rise - band) / length);
    most = std::min(most, (rise + band) / length);
  }
  return last;
}

double range_of(const History& series) {
  const auto [least, most] =
      std::minmax_element(series.begin(), series.end(), [](const auto& a, const auto& b) { return a[1] < b[1]; });
  return (*most)[1] - (*least)[1];
}

Measured read_measured(const Entry& entry, const std::string& scene_path) {
  Measured measured;
  measured.file = entry.text("file");
  const auto table = table_of(scene_path, measured.file);
  auto all = series_of(table, entry.text("column"));
  if (entry.flag("close")) close(all);
  measured.duration_s = table.names.front() == "time_s" ? all.back()[0] - all.front()[0] : 0.0;
  make_progress(all);
  measured.points = all.size();
  measured.tolerance = entry.number("tolerance");
  measured.corners = thinned(all, measured.tolerance * range_of(all));
  if (measured.corners.size() > most_corners)
    throw Unfit(
        base::formatted("%zu of its %zu points are left at tolerance = %g, and 200000 are the most; write a "
                        "larger tolerance",
                        measured.corners.size(), all.size(), measured.tolerance));
  if (const double way = way_of(all); way > 0.0)
    measured.way_lost = std::max(0.0, 1.0 - way_of(measured.corners) / way);
  return measured;
}

}  // namespace

History thinned(const History& all, double band) {
  if (all.size() < 3) return all;
  History kept{all.front()};
  std::size_t from = 0;
  for (const std::size_t end : turns_of(all, band))
    while (from < end) {
      from = farthest(all, from, end, band);
      kept.push_back(all[from]);
    }
  return kept;
}

double way_of(const History& history) {
  double way = 0.0;
  for (std::size_t i = 1; i < history.size(); ++i) way += std::abs(history[i][1] - history[i - 1][1]);
  return way;
}

std::optional<Measured> measured_history(const Entry& entry, const std::string& scene_path, Issues& issues) {
  if (entry.text("file").empty()) return std::nullopt;  // has an issue of its own
  try {
    return read_measured(entry, scene_path);
  } catch (const Unfit& why) {
    issues.push_back({entry.key("file"), entry.written("file"), why.what()});
    return std::nullopt;
  }
}

std::vector<std::array<double, 2>> levels_of(const Entry& spectrum, const std::string& scene_path, Issues& issues) {
  std::vector<std::array<double, 2>> levels;
  try {
    for (const auto& [line, values] : table_of(scene_path, spectrum.text("levels"), "level,cycles").rows) {
      const std::string place = "line " + std::to_string(line) + ": ";
      if (values[0] <= 0.0) throw Unfit(place + "level must be > 0");
      if (values[1] <= 0.0) throw Unfit(place + "cycles must be > 0");
      levels.push_back({values[0], values[1]});
    }
    if (levels.empty()) throw Unfit("needs at least one row of numbers");
  } catch (const Unfit& why) {
    issues.push_back({spectrum.key("levels"), spectrum.written("levels"), why.what()});
    levels.clear();
  }
  return levels;
}

}  // namespace reye::scene
