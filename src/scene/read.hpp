#pragma once
#include <span>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "scene/keys.hpp"
#include "scene/scene.hpp"

namespace reye::scene {

/// The scene in the file at `path`. All its errors are collected and thrown as one base::InputError, one line per
/// issue, in the order of the file: `scene.toml:9: material.steel.nu = 0.5: must lie in (-1, 0.5)`, with `path` as the
/// caller gave it. Edges that no [boundary] names are not resolved here, they may be physical curves of the geometry.
Scene read(const std::string& path);

/// The scene in a text that is, or will be, the content of the file at `path`.
Scene read_text(const std::string& text, const std::string& path);

/// The bytes of the scene file; base::InputError when there is none.
std::string text_of(const std::string& path);

/// The issues of a lower room in the same form; the line is that of the longest part of the key
/// that the file has (line 1 when it has none).
base::InputError located(const Scene& scene, const std::vector<base::Issue>& issues);

/// The table of keys of plane scenes as markdown, for geo/REFERENCE.md.
std::string reference();

/// Another table in the same form.
std::string reference(std::span<const Key> table);

}  // namespace reye::scene
