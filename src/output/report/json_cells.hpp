#pragma once
#include <nlohmann/json.hpp>
#include <string>

/// Values of a summary for readers.
namespace reye::output {

/// A value of an object; a dash where it is null or missing.
std::string json_cell(const nlohmann::ordered_json& object, const std::string& key, int digits = 5,
                      double factor = 1.0);

/// A member of an object; null where there is none.
const nlohmann::ordered_json& json_part(const nlohmann::ordered_json& object, const std::string& key);

/// A heading with its content; nothing without any.
std::string page_section(const std::string& title, const std::string& body);

/// Sentences as a list.
std::string sentence_list(const nlohmann::ordered_json& sentences);

/// Seconds by name as bars with their shares, the longest first; nothing where they are none.
std::string time_bars(const nlohmann::ordered_json& seconds);

}  // namespace reye::output
