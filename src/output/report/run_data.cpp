#include "output/report/run_data.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <stdexcept>

#include "base/errors.hpp"
#include "output/folder/csv.hpp"
#include "output/folder/files.hpp"
#include "output/folder/text.hpp"
#include "output/folder/vtk_frames.hpp"

namespace reye::output {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

/// Indices of texts in the order they were met.
class Words {
 public:
  double index(const std::string& word) {
    const auto [entry, fresh] = index_.try_emplace(word, static_cast<double>(words_.size()));
    if (fresh) words_.push_back(word);
    return entry->second;
  }
  std::vector<std::string> take() { return std::move(words_); }

 private:
  std::map<std::string, double> index_;
  std::vector<std::string> words_;
};

std::vector<FrameRows> frames_of(const Table& table) {
  const auto &frame = table.column("frame"), &cycle = table.column("cycle");
  std::vector<FrameRows> frames;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    if (i == 0 || frame[i] != frame[i - 1]) frames.push_back({cycle.at(i), i, i});
    frames.back().end = i + 1;
  }
  return frames;
}

[[noreturn]] void damaged(const std::string& file, const std::string& what) {
  throw base::InputError({{"dir", "", file + " is damaged: " + what}});
}

/// Bound of the numbers of a run; larger ones would overflow in a picture and count as damage.
constexpr double most = 1e100;

}  // namespace

Table read_table(const std::string& file, const std::string& header, bool ended) {
  const std::string text = read_text(file);
  if (!text.starts_with(header.substr(0, header.size() - 1)))
    damaged(file, "it does not begin with the names of its columns");
  if (ended && !text.ends_with('\n')) damaged(file, "its last row is cut");
  Table table;
  try {
    table = parse_csv(text);
  } catch (const std::runtime_error& error) {
    damaged(file, error.what());
  }
  for (const auto& column : table.values)
    for (const double value : column)
      if (std::isfinite(value) && std::abs(value) > most) damaged(file, number(value) + " is not a result of a run");
  return table;
}

void check_end(const Table& table, const std::string& file, const Json& summary) {
  const auto cycles = summary.find("cycles");
  if (cycles == summary.end() || !cycles->is_number()) return;
  const auto& cycle = table.column("cycle");
  const double end = cycles->get<double>(), last = cycle.empty() ? 0.0 : cycle.back();
  if (!(std::abs(last - end) <= 1e-6 * std::max(1.0, end)))
    damaged(file, "it ends at cycle " + number(last) + ", the run at cycle " + number(end));
}

Identity identity_in(const std::string& dir) {
  if (const auto identity = read_identity(dir)) return *identity;
  const auto marker = fs::path(dir) / ".reye.json";
  if (fs::exists(fs::symlink_status(marker))) damaged(marker.string(), "it does not say whose run this is");
  throw base::InputError({{"dir", dir, "holds no run of reye"}});
}

Json read_summary(const std::string& file) {
  if (!fs::exists(file)) return {};
  const Json summary = Json::parse(read_text(file), nullptr, false);
  const auto status = summary.is_object() ? summary.find("status") : summary.end();
  if (!summary.is_object() || status == summary.end() || !status->is_string())
    damaged(file, "it does not say how the run ended");
  return summary;
}

namespace {

std::optional<SurfaceTable> read_surface(const std::string& dir, const std::string& contact, sim::Side side,
                                         bool done) {
  const auto file = (fs::path(dir) / surface_file(contact, side)).string();
  if (!fs::exists(file)) {
    if (done) damaged(file, "it is missing, though the run is done");
    return {};
  }
  SurfaceTable surface{side, read_table(file, surface_header(), done), {}};
  surface.frames = frames_of(surface.table);
  for (std::size_t k = 1; k < surface.frames.size(); ++k)
    if (!(surface.frames[k].cycle >= surface.frames[k - 1].cycle)) damaged(file, "its cycles decrease");
  if (surface.frames.empty() && !done) return {};
  if (surface.frames.empty()) damaged(file, "it holds no rows, though the run is done");
  return surface;
}

}  // namespace

const std::vector<double>& Table::column(std::string_view name) const {
  static const std::vector<double> none;
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i] == name) return values[i];
  return none;
}

bool is_text_column(std::string_view name) {
  return name == "step" || name == "status" || name == "body" || name == "reason";
}

Table parse_csv(const std::string& text) {
  Table table;
  Words words;
  std::size_t start = 0, number = 0;
  for (auto end = text.find('\n'); end != std::string::npos; start = end + 1, end = text.find('\n', start)) {
    const auto cells = csv_cells(std::string_view(text).substr(start, end - start));
    if (number++ == 0) {
      table.columns = cells;
      table.values.resize(cells.size());
      continue;
    }
    if (cells.size() != table.columns.size())
      throw std::runtime_error("line " + std::to_string(number) + " has " + std::to_string(cells.size()) +
                               " cells, not " + std::to_string(table.columns.size()));
    for (std::size_t c = 0; c < cells.size(); ++c)
      table.values[c].push_back(is_text_column(table.columns[c]) ? words.index(cells[c]) : csv_number(cells[c]));
  }
  table.words = words.take();
  return table;
}

RunData read_run(const std::string& dir) {
  RunData run;
  run.identity = identity_in(dir);
  const auto file = [&](const char* name) { return (fs::path(dir) / name).string(); };
  try {
    run.summary = read_summary(file("summary.json"));
    const bool ended = run.summary.is_object(), done = ended && run.summary["status"] == "done";
    if (fs::exists(file("history.csv")))
      run.history = read_table(file("history.csv"), history_header({}, run.identity.analysis), ended);
    else if (ended)
      damaged(file("history.csv"), "it is missing, though the run has ended");
    if (done) check_end(run.history, file("history.csv"), run.summary);
    if (fs::exists(file("remesh.csv")))
      run.remeshes = read_table(file("remesh.csv"), remesh_header(run.identity.analysis), ended);
    for (const auto& [name, mu] : run.identity.friction) {
      ContactData contact{name, mu, {}};
      for (const auto side : {sim::Side::secondary, sim::Side::primary})
        if (auto surface = read_surface(dir, name, side, done)) {
          if (done) check_end(surface->table, file(surface_file(name, side).c_str()), run.summary);
          contact.sides.push_back(std::move(*surface));
        }
      run.contacts.push_back(std::move(contact));
    }
  } catch (const base::InputError&) {
    throw;
  } catch (const std::runtime_error& error) {  // a file that cannot be read at all
    throw base::InputError({{"dir", "", error.what()}});
  }
  return run;
}

std::string frame_path(const std::string& dir, const char* stem, const char* ext, std::size_t k) {
  return (fs::path(dir) / frame_file(stem, ext, k)).string();
}

std::size_t frame_count(const RunData& run, const std::string& dir) {
  std::size_t count = run.contacts.empty() ? 0 : SIZE_MAX;
  for (const auto& contact : run.contacts) {
    if (contact.sides.empty()) return 0;
    for (const auto& surface : contact.sides) count = std::min(count, surface.frames.size());
  }
  if (!fs::is_regular_file(frame_path(dir, "surface", "vtp", 0))) return 0;
  while (count > 0 && !fs::is_regular_file(frame_path(dir, "surface", "vtp", count - 1))) --count;
  return count;
}

double worn_amount(const SurfaceTable& surface, const FrameRows& rows, base::Analysis analysis) {
  const auto& s = surface.table.column("arc_length_mm");
  const auto& x = surface.table.column("x_mm");
  const auto& depth = surface.table.column("wear_depth_mm");
  double sum = 0.0;
  for (std::size_t i = rows.begin + 1; i < rows.end; ++i) {
    const double left = depth[i - 1] * base::out_of_plane(analysis, x[i - 1]);
    const double right = depth[i] * base::out_of_plane(analysis, x[i]);
    sum += 0.5 * (left + right) * (s[i] - s[i - 1]);
  }
  return sum;
}

}  // namespace reye::output
