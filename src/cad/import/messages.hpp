#pragma once
#include <optional>
#include <string>

/// What the importer and the program that started it exchange; each message is preceded by its size.
namespace reye::cad {

/// Sends a message to descriptor 3. Ends the process where nobody reads it.
void say(const std::string& bytes);

/// The next request on standard input; nothing when there is none to come.
std::optional<std::string> next_request();

}  // namespace reye::cad
