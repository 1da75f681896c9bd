#pragma once
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "output/folder/folder.hpp"
#include "output/folder/tables.hpp"

/// Data of an output folder, as the report reads them.
namespace reye::output {

/// A CSV table by columns. The text columns (step, status, body, reason) hold indices into `words`.
struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> values;  ///< one vector per column
  std::vector<std::string> words;

  std::size_t rows() const { return values.empty() ? 0 : values[0].size(); }
  /// The column of this name; empty when the table has none.
  const std::vector<double>& column(std::string_view name) const;
  /// The text behind a cell of a text column.
  const std::string& word(double cell) const { return words.at(static_cast<std::size_t>(cell)); }
};

/// Whether the cells of a column of this name are texts.
bool is_text_column(std::string_view name);

/// Reads a table; a last line that a kill left half is dropped.
/// Throws when a row has another width or a cell is not a number.
Table parse_csv(const std::string& text);

/// Rows [begin, end) of a surface table that belong to one frame.
struct FrameRows {
  double cycle = 0.0;
  std::size_t begin = 0, end = 0;
};

struct SurfaceTable {
  sim::Side side = sim::Side::secondary;
  Table table;
  std::vector<FrameRows> frames;
};

struct ContactData {
  std::string name;
  std::optional<double> friction;
  std::vector<SurfaceTable> sides;  ///< secondary first; a side without table is missing
};

struct RunData {
  Identity identity;
  nlohmann::ordered_json summary;  ///< null when the run has not ended
  Table history;
  Table remeshes;  ///< empty when no body was remeshed
  std::vector<ContactData> contacts;
};

/// A table whose columns begin with those of `header`. One that ends in half a row belongs to a run that is still
/// writing, or was killed; with `ended` it is refused. Throws base::InputError with the file.
Table read_table(const std::string& file, const std::string& header, bool ended);

/// Refuses a table that ends at another cycle than its run, which is done: cut between two rows it looks whole.
/// Throws base::InputError with the file.
void check_end(const Table& table, const std::string& file, const nlohmann::ordered_json& summary);

/// The summary; null where there is no such file. Throws base::InputError where it does not say how the run ended.
nlohmann::ordered_json read_summary(const std::string& file);

/// Whose run a folder holds; throws base::InputError where it holds none.
Identity identity_in(const std::string& dir);

/// The files of a run as far as they exist; all of them must if it has ended. Throws base::InputError with the file
/// that is missing, cut or altered.
RunData read_run(const std::string& dir);

/// Number of frames whose file of surfaces and rows of all tables are there; none where the first file is not.
std::size_t frame_count(const RunData& run, const std::string& dir);

/// Path of a file of the k-th frame: (dir, "bodies", "vtu", k).
std::string frame_path(const std::string& dir, const char* stem, const char* ext, std::size_t k);

/// sum over nodes of depth times half the neighbouring lengths (times 2 pi x in axisymmetry).
double worn_amount(const SurfaceTable& surface, const FrameRows& rows, base::Analysis analysis);

}  // namespace reye::output
