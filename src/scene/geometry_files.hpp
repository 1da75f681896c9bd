#pragma once
#include <string>
#include <vector>

#include "scene/check.hpp"
#include "scene/entry.hpp"

namespace reye::scene {

/// The geometry files of the scene at `path`, absolute; unsupported, missing, empty and unreadable ones are issues.
std::vector<std::string> geometry_files(const Entry& root, const std::string& path, Issues& issues);

/// Absolute path of a file whose path counts from the scene at `scene_path`.
std::string beside(const std::string& scene_path, const std::string& name);

/// Why a file cannot be read or is empty; an empty text when it is fine.
std::string unreadable_rule(const std::string& file);

/// The bytes of a file; false when it cannot be read.
bool read_bytes(const std::string& path, std::string& bytes);

/// SHA-256 of a file's bytes.
std::string file_sha256(const std::string& path);

/// SHA-256 over the scene's text and its files (geometry, then profiles) in their order, each with its length,
/// so that bytes cannot move from one file to the next undetected.
std::string digest(const std::string& scene_text, const std::vector<std::string>& files);

}  // namespace reye::scene
