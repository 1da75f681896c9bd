#pragma once
#include <string>
#include <utility>
#include <vector>

/// One table over the members of a sweep.
namespace reye::output {

/// How the run in a folder ended, as its summary says.
struct RunEnd {
  std::string status = "missing";  ///< "done", "failed", "interrupted", "missing" without a summary, "damaged" with one
                                   ///< that cannot be read
  std::string reason;
  std::string sha256;
  /// The numbers of the summary by their place in it ("contacts.pad.peak_pressure_MPa"), in its order, unknown ones
  /// empty; times come last.
  std::vector<std::pair<std::string, std::string>> figures;
};

RunEnd read_end(const std::string& dir);

struct SweepRow {
  std::string member;
  std::vector<std::string> values;  ///< of the keys varied, as written in TOML
  RunEnd end;
};

/// sweep.csv: `member`, the keys varied, `status`, `reason`, then every figure that a member has.
std::string sweep_table(const std::vector<std::string>& keys, const std::vector<SweepRow>& rows);

/// A sentence for each limit: its shortest and longest life over all members, each with its own band where it has one,
/// and how many members do not reach it.
std::vector<std::string> life_bands(const std::vector<SweepRow>& rows);

}  // namespace reye::output
