#pragma once
#include <functional>
#include <string>

#include "output/report/html.hpp"
#include "output/report/run_data.hpp"

/// The sections of the report that are tables; each returns HTML, or nothing when the run has no such data.
namespace reye::output {

/// Key results of every contact, lives, probes, estimated errors.
std::string result_tables(const RunData& run);

/// The cycles of each limit, with the band of the scatter of wear.
std::string life_table(const RunData& run);

/// The errors that the run estimates of itself.
std::string error_table(const RunData& run);

/// The removed volume beside coefficient x work.
std::string ledger_table(const RunData& run);

/// How rows of remesh.csv are shown: their cells, the second and the last of them words, and a note below.
struct RemeshColumns {
  Row head;
  std::function<Row(const Table&, std::size_t row)> cells;
  std::string note;
};

/// The rows of remesh.csv, folded away when they are many, the last ones when they are very many.
std::string remesh_section(const Table& remeshes, const RemeshColumns& columns);

/// One row per body remeshed, with the jumps it cost.
std::string remesh_table(const RunData& run);

/// Counts, time and memory, what was skipped, why steps were cut.
std::string run_tables(const RunData& run);

}  // namespace reye::output
