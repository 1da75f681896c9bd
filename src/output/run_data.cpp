#include "output/run_data.hpp"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "output/files.hpp"

namespace reye::output {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

/// Splits one line of CSV (RFC 4180 quotes).
std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"') cells.back() += line[++i];
    else if (c == '"') quoted = !quoted;
    else if (c == ',' && !quoted) cells.emplace_back();
    else cells.back() += c;
  }
  return cells;
}

double number_of(const std::string& cell) {
  double value = 0.0;
  const char* end = cell.data() + cell.size();
  const auto result = std::from_chars(cell.data(), end, value);
  if (result.ec != std::errc{} || result.ptr != end) throw std::runtime_error("'" + cell + "' is no number");
  return value;
}

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

bool is_text(const std::string& column) {
  return column == "step" || column == "status" || column == "body" || column == "reason";
}

std::vector<FrameRows> frames_of(const Table& table) {
  const auto &frame = table.column("frame"), &cycle = table.column("cycle");
  std::vector<FrameRows> frames;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    if (i == 0 || frame[i] != frame[i - 1]) frames.push_back({cycle.at(i), i, i});
    frames.back().end = i + 1;
  }
  return frames;
}

std::optional<SurfaceTable> read_surface(const std::string& dir, const std::string& contact, sim::Side side) {
  const auto path = fs::path(dir) / surface_file(contact, side);
  if (!fs::is_regular_file(path)) return {};
  SurfaceTable surface{side, parse_csv(read_text(path.string())), {}};
  surface.frames = frames_of(surface.table);
  if (surface.frames.empty()) return {};
  return surface;
}

}  // namespace

const std::vector<double>& Table::column(std::string_view name) const {
  static const std::vector<double> none;
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i] == name) return values[i];
  return none;
}

Table parse_csv(const std::string& text) {
  Table table;
  Words words;
  std::size_t start = 0, number = 0;
  for (auto end = text.find('\n'); end != std::string::npos; start = end + 1, end = text.find('\n', start)) {
    const auto cells = cells_of(std::string_view(text).substr(start, end - start));
    if (number++ == 0) {
      table.columns = cells;
      table.values.resize(cells.size());
      continue;
    }
    if (cells.size() != table.columns.size())
      throw std::runtime_error("line " + std::to_string(number) + " has " + std::to_string(cells.size()) +
                               " cells, not " + std::to_string(table.columns.size()));
    for (std::size_t c = 0; c < cells.size(); ++c)
      table.values[c].push_back(is_text(table.columns[c]) ? words.index(cells[c]) : number_of(cells[c]));
  }
  table.words = words.take();
  return table;
}

RunData read_run(const std::string& dir) {
  RunData run;
  const auto identity = read_identity(dir);
  if (!identity) throw std::runtime_error(dir + " holds no run");
  run.identity = *identity;
  const auto file = [&](const char* name) { return (fs::path(dir) / name).string(); };
  if (fs::is_regular_file(file("summary.json"))) {
    run.summary = Json::parse(read_text(file("summary.json")), nullptr, false);
    if (!run.summary.is_object()) throw std::runtime_error(file("summary.json") + " is damaged");
  }
  if (fs::is_regular_file(file("history.csv"))) run.history = parse_csv(read_text(file("history.csv")));
  if (fs::is_regular_file(file("remesh.csv"))) run.remeshes = parse_csv(read_text(file("remesh.csv")));
  for (const auto& [name, mu] : identity->friction) {
    ContactData contact{name, mu, {}};
    for (const auto side : {sim::Side::secondary, sim::Side::primary})
      if (auto surface = read_surface(dir, name, side)) contact.sides.push_back(std::move(*surface));
    run.contacts.push_back(std::move(contact));
  }
  return run;
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
