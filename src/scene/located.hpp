#pragma once
#include <map>
#include <string>
#include <vector>

#include "scene/check.hpp"
#include "scene/document.hpp"

/// A scene file as a document, and issues with its lines.
namespace reye::scene {

/// Line of each key as "material.steel.nu"; array tables as "step[0].cycles".
using Lines = std::map<std::string, int>;

/// The tree of a text; base::InputError with its line where the text is not TOML.
Node document_of(const std::string& text, const std::string& path);

Lines lines_of(const Node& document);

/// The issues in the order of the file, one text each: `scene.toml:9: material.steel.nu = 0.5: must ...`. The line is
/// that of the longest part of the key that the file has.
std::vector<std::string> in_words(Issues& issues, const Lines& lines, const std::string& path);

base::InputError located(Issues issues, const Lines& lines, const std::string& path);

/// A scene's name: that of its file without .toml, or of the folder for scene.toml.
std::string name_of(const std::string& path);

}  // namespace reye::scene
