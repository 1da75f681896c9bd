#pragma once
#include <string>

#include "scene/document.hpp"

namespace reye::scene {

/// All of a scene that a run cannot change when it resumes, value by value in the order of the file: everything but
/// limits and the number of cycles of the last step, where no spectrum repeats that. `document`: the tree of `text`.
std::string fixed_part(const Node& document, const std::string& text);

/// The key of the cycles of the last step, where they are those of one step of the run.
std::string cycles_key_of(const Node& root);

/// Whether a node is a table or a list of tables; everything else is a value.
bool is_branch(const Node& node);

/// The value of a leaf as written in the text.
std::string value_of(const Node& leaf, const std::string& text);

}  // namespace reye::scene
