#pragma once
#include <string>

#include "output/solid/solid_run_data.hpp"

/// The sections of the report of solids that are tables; each returns HTML, or nothing when the run has no such data.
namespace reye::output {

/// Key results of every contact, probes, balance, resultants of supports at the end.
std::string solid_result_tables(const SolidRunData& data);

/// What went in: bodies and materials, contacts, supports, loads, steps.
std::string solid_input_tables(const SolidRunData& data);

/// One row per body remeshed, with what it cost.
std::string solid_remesh_table(const SolidRunData& data);

/// Counts, size, time and memory, why steps were cut.
std::string solid_run_tables(const SolidRunData& data);

}  // namespace reye::output
