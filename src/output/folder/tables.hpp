#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "sim/problem/records.hpp"

/// The CSV tables of the output folder. Numbers read back to the same double.
namespace reye::output {

/// Ends of keys that name an amount per thickness or on the whole circumference.
struct Suffixes {
  std::string force;   ///< "N_per_mm" | "N"
  std::string energy;  ///< "mJ_per_mm" | "mJ"
  std::string worn;    ///< "worn_area_mm2" | "worn_volume_mm3"
};
Suffixes suffixes(base::Analysis analysis);

/// The columns of the history beyond its first eight.
struct HistoryColumns {
  struct Support {
    std::string name;
    bool moment = false;  ///< a rigid edge in a plane problem
  };
  std::vector<std::string> contacts;
  std::vector<Support> supports;
  std::vector<std::string> bonds{};
};

/// Header line of history.csv: six columns per contact, two of force and one of moment per support, four per bond.
std::string history_header(const HistoryColumns& columns, base::Analysis analysis);
std::string history_row(const sim::IncrementRecord& record);

std::string remesh_header(base::Analysis analysis);
/// One body remeshed; times stay in the log, so that two runs write the same bytes.
std::string remesh_row(const sim::RemeshRecord& record);

std::string surface_header();
/// The rows of a surface of a frame; `index`: the number of the frame, from 0.
std::string surface_rows(std::size_t index, const sim::Frame& frame, const sim::SurfaceRecord& surface);

/// surface_<contact>_<side>.csv
std::string surface_file(const std::string& contact, sim::Side side);
const char* side_name(sim::Side side);

/// Bytes of the header and the first `rows` rows. Throws std::runtime_error when the table holds fewer whole ones.
std::uintmax_t size_of_rows(const std::string& path, long rows);

/// Cuts the table to its header and the first `rows` rows, dropping also half a row that a kill left.
/// Throws std::runtime_error when it holds fewer.
void keep_rows(const std::string& path, long rows);

}  // namespace reye::output
