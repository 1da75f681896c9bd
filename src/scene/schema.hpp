#pragma once
#include <string>

#include "scene/spec.hpp"

namespace reye::scene {

/// What `check` asks of each key of a plane scene or of one of solids, as a JSON Schema (draft 7), so that editors of
/// TOML complete and explain keys and mark what is refused. An error stands at the key that `check` names; an entry of
/// a list of plain values counts as its list. Left to `check` are what the draft cannot say: finite numbers, formulas
/// that can be read, pairs that increase.
std::string schema(const Spec& plane, const Spec& solids);

}  // namespace reye::scene
