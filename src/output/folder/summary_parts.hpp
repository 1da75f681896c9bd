#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/problem/records.hpp"

/// Pieces of every summary.json.
namespace reye::output {

using Json = nlohmann::ordered_json;

/// The number; null where it is unknown or not finite.
Json value_json(double x);
Json value_json(const std::optional<double>& x);

/// The text; null where it is empty.
Json text_json(const std::string& s);

/// Lives by limit, their errors, and their bands; null where there are none.
Json lives_json(const std::map<std::string, std::optional<double>>& lives);
Json life_errors_json(const std::map<std::string, double>& errors);
Json bands_json(const std::map<std::string, sim::LifeBand>& bands);

Json counts_json(const sim::Counts& c);
Json warnings_json(const std::vector<sim::Warning>& warnings);

}  // namespace reye::output
