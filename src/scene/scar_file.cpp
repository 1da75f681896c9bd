#include "scene/scar_file.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "scene/geometry_files.hpp"

namespace reye::scene {

namespace {

constexpr std::size_t most_rows = 1'000'000;
constexpr std::size_t least_rows = 8;

/// The numbers of a file; nothing, and an issue, where there are none that serve.
std::optional<base::NumberTable> rows_of(const std::string& path, const std::string& key, Issues& issues) {
  const auto refuse = [&](const std::string& rule) {
    issues.push_back({key, "", rule});
    return std::nullopt;
  };
  std::string bytes;
  if (auto rule = unreadable_rule(path); !rule.empty()) return refuse(rule);
  if (!read_bytes(path, bytes)) return refuse("cannot be read");
  try {
    auto table = base::parse_numbers(bytes);
    if (table.rows.size() < least_rows) return refuse("has fewer than 8 rows of numbers");
    if (table.rows.size() > most_rows) return refuse("has more than a million rows; average neighbours first");
    return table;
  } catch (const base::InputError& error) {
    return refuse(error.issues().front().rule);
  }
}

/// A column whose name is `stem` with a unit of length: its place, and mm per unit; -1 where there is none.
struct Column {
  int at = -1;
  double mm = 1.0;
};

Column column_of(const base::NumberTable& table, const std::string& stem) {
  if (const int at = table.column(stem + "_mm"); at >= 0) return {at, 1.0};
  return {table.column(stem + "_um"), 1e-3};
}

/// The rows of one CSV file as a scar. Rules that it breaks are added under `key`.
class ScarFile {
 public:
  ScarFile(bool map, std::string key, Issues& issues) : map_(map), key_(std::move(key)), issues_(issues) {}

  void read(const base::NumberTable& table, MeasuredScar& scar) {
    if (set_axes(table, scar)) fill(table, scar);
  }

 private:
  void refuse(const std::string& rule) { issues_.push_back({key_, "", rule}); }

  bool set_axes(const base::NumberTable& table, MeasuredScar& scar) {
    const std::pair<const char*, ScarAxis> names[] = {
        {"x_mm", ScarAxis::x}, {"y_mm", ScarAxis::y}, {"z_mm", ScarAxis::z}, {"arc_mm", ScarAxis::arc}};
    for (const auto& [name, axis] : names)
      if (const int at = table.column(name); at >= 0) {
        scar.axes.push_back(axis);
        places_.push_back(at);
      }
    const bool arc = std::find(scar.axes.begin(), scar.axes.end(), ScarAxis::arc) != scar.axes.end();
    const bool z = std::find(scar.axes.begin(), scar.axes.end(), ScarAxis::z) != scar.axes.end();
    const bool fits = map_ ? scar.axes.size() == 2 && !arc : scar.axes.size() == 1 && !z;
    if (!fits)
      refuse(map_ ? "needs two of the columns x_mm, y_mm and z_mm: the plane on which the scar is seen"
                  : "needs one of the columns x_mm, y_mm and arc_mm: the place along the surface");
    return fits;
  }

  void fill(const base::NumberTable& table, MeasuredScar& scar) {
    const Column depth = column_of(table, "depth"), height = column_of(table, "height"),
                 scatter = column_of(table, "scatter");
    if ((depth.at >= 0) == (height.at >= 0))
      return refuse("needs one column of depth_mm, depth_um, height_mm or height_um (depth counts into the body)");
    const Column& value = depth.at >= 0 ? depth : height;
    const double sign = depth.at >= 0 ? 1.0 : -1.0;
    std::vector<std::size_t> order(table.rows.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto cell = [&](std::size_t row, int column) {
      return table.rows[row].values[static_cast<std::size_t>(column)];
    };
    if (scar.axes.size() == 1)
      std::stable_sort(order.begin(), order.end(),
                       [&](std::size_t a, std::size_t b) { return cell(a, places_[0]) < cell(b, places_[0]); });
    const auto count = static_cast<Eigen::Index>(order.size());
    scar.depth_mm.resize(count);
    if (scatter.at >= 0) scar.scatter_mm.resize(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto row = order[static_cast<std::size_t>(i)];
      scar.at.emplace_back(cell(row, places_[0]), places_.size() > 1 ? cell(row, places_[1]) : 0.0);
      scar.depth_mm[i] = sign * value.mm * cell(row, value.at);
      if (scatter.at >= 0) scar.scatter_mm[i] = scatter.mm * cell(row, scatter.at);
    }
    check_rows(scar);
  }

  void check_rows(const MeasuredScar& scar) {
    if (scar.scatter_mm.size() > 0 && !(scar.scatter_mm.minCoeff() > 0.0))
      refuse("scatter must be above 0 in every row");
    if (scar.axes.size() == 1)
      for (std::size_t i = 1; i < scar.at.size(); ++i)
        if (scar.at[i].x() == scar.at[i - 1].x())
          return refuse("two rows have the same place; a profile has one depth at each");
    if (!(scar.depth_mm.maxCoeff() > scar.depth_mm.minCoeff())) refuse("its depths are all equal");
  }

  bool map_;
  std::string key_;
  Issues& issues_;
  std::vector<int> places_;
};

}  // namespace

void read_scar_file(const std::string& path, bool map, const std::string& key, MeasuredScar& scar, Issues& issues) {
  if (const auto table = rows_of(path, key, issues)) ScarFile(map, key, issues).read(*table, scar);
}

double energy_of_loop(const std::string& path, bool whole, const std::string& key, Issues& issues) {
  const auto table = rows_of(path, key, issues);
  if (!table) return 0.0;
  const std::string force = whole ? "force_N" : "force_N_per_mm";
  const int x = table->column("stroke_mm"), F = table->column(force);
  if (x < 0 || F < 0) {
    issues.push_back({key, "", "needs the columns stroke_mm and " + force});
    return 0.0;
  }
  const auto cell = [&](std::size_t row, int column) {
    return table->rows[row].values[static_cast<std::size_t>(column)];
  };
  double energy = 0.0;
  for (std::size_t i = 0; i < table->rows.size(); ++i) {
    const std::size_t next = (i + 1) % table->rows.size();
    energy += 0.5 * (cell(i, F) + cell(next, F)) * (cell(next, x) - cell(i, x));
  }
  if (energy == 0.0) issues.push_back({key, "", "encloses no energy: its force does not lag behind its stroke"});
  return std::abs(energy);
}

}  // namespace reye::scene
