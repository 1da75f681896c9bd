#pragma once
#include <string>
#include <string_view>

namespace reye::base {

/// A name as it may stand in a message: control characters and bytes that are not UTF-8 as escapes (\n, \t, \x1b,
/// \xff), so that no name breaks a line, controls a terminal or breaks a page. Printable characters stay as they are.
std::string printable(std::string_view text);

/// The bytes of the UTF-8 character that begins at `at`; 0 where none does.
std::size_t utf8_length(std::string_view text, std::size_t at);

}  // namespace reye::base
