#pragma once
#include <cstdint>
#include <optional>
#include <string>

/// Files written so that a killed run leaves either the old or the new one, and never through a symbolic link at the
/// end of a path. All throw std::runtime_error with path and reason (no space, no permission ...).
namespace reye::output {

/// Replaces the file as a whole: temporary file in the same folder, fsync, rename. A symbolic link in its place is
/// replaced.
void atomic_write(const std::string& path, const std::string& text);

/// Like atomic_write, without waiting for the disk: for figures and pages, which `reye report` makes again should a
/// power cut leave them empty. Waiting took a third of a report's time.
void replace_text(const std::string& path, const std::string& text);

/// Adds to the end of the file, which is made when missing. Not atomic: a kill can leave half a text, a power cut
/// anything since the last sync_file.
void append_text(const std::string& path, const std::string& text);

/// Cuts the file to its first `size` bytes.
void cut_file(const std::string& path, std::uintmax_t size);

/// Waits until the bytes of the file would survive a power cut.
void sync_file(const std::string& path);

/// Waits until the entries of the folder would survive a power cut; a file system that cannot sync folders is not an
/// error.
void sync_folder(const std::string& path);

/// Makes the folder where there is none; a symbolic link or a file in its place is refused.
void make_folder(const std::string& path);

/// The final name of a temporary file of atomic_write, which a kill leaves behind; nothing for other names.
std::optional<std::string> becoming(const std::string& name);

/// The whole file as bytes.
std::string read_text(const std::string& path);

}  // namespace reye::output
