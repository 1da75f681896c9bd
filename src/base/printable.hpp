#pragma once
#include <string>
#include <string_view>

namespace reye::base {

/// A name as it may stand in a message: control characters and bytes that are no UTF-8 as escapes (\n, \t, \x1b, \xff),
/// so that no name breaks a line, steers a terminal or spoils a page. What is printable stays as it is.
std::string printable(std::string_view text);

/// The bytes of the UTF-8 character that begins at `at`; 0 where none does.
std::size_t utf8_length(std::string_view text, std::size_t at);

}  // namespace reye::base
