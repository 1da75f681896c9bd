#pragma once
#include <string>
#include <vector>

#include "sim/solid/solid_records.hpp"

/// The CSV tables of a run of solids. Numbers read back to the same double.
namespace reye::output {

/// The columns of the history beyond its first four: names in the order of the scene.
struct SolidColumns {
  std::vector<std::string> contacts, supports;
};

/// Header line of history.csv: nine columns per contact, six per support.
std::string solid_history_header(const SolidColumns& columns);

/// The row of an increment. Throws std::logic_error where it has other contacts or supports than the columns.
std::string solid_history_row(const sim::SolidIncrement& record, const SolidColumns& columns);

std::string solid_remesh_header();
/// One body remeshed; times stay in the log, so that two runs write the same bytes.
std::string solid_remesh_row(const sim::SolidRemeshRecord& record);

std::string skin_header();

/// A row per node of one side of a contact in a frame; `index`: the number of the frame, from 0; `bodies`: their names.
std::string skin_rows(std::size_t index, double cycle, const std::vector<std::string>& bodies,
                      const sim::SkinRecord& skin);

}  // namespace reye::output
