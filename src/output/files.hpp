#pragma once
#include <string>

/// Files written so that a killed run leaves either the old or the new one. All throw std::runtime_error
/// with path and reason (no space, no permission ...).
namespace reye::output {

/// Replaces the file as a whole: temporary file in the same folder, fsync, rename.
void atomic_write(const std::string& path, const std::string& text);

/// Adds to the end of the file, which is made when missing. Not atomic: a kill can leave half a text.
void append_text(const std::string& path, const std::string& text);

/// The whole file as bytes.
std::string read_text(const std::string& path);

}  // namespace reye::output
