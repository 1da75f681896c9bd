#pragma once
#include <optional>
#include <string>

/// A scene's text with single values changed; everything else stays as the user wrote it.
namespace reye::scene {

/// The text with `value` (as written in TOML) at `key` ("contact.pad.friction", "step[2].jump.tolerance").
/// A value in the text is replaced. A missing one is added to its innermost table in the text; a plain value in that
/// place becomes a table. Nothing when the place cannot hold it: the result is read back and compared. Throws
/// SyntaxError when the text is not TOML.
std::optional<std::string> with_value(const std::string& text, const std::string& key, const std::string& value);

/// The text with the paths of geometry and profiles made absolute, as counted from the scene at `path`: it has the same
/// meaning in any folder.
std::string with_absolute_paths(std::string text, const std::string& path);

/// A text in TOML's quotes.
std::string quoted(const std::string& text);

}  // namespace reye::scene
