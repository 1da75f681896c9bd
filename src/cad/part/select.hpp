#pragma once
#include <map>
#include <optional>
#include <vector>

#include "base/errors.hpp"
#include "cad/part/options.hpp"
#include "cad/part/part.hpp"

namespace reye::cad {

/// Edges of a part by name: for each loop, which of its edges belong.
using EdgeChoice = std::vector<std::vector<bool>>;

/// The part each body is made of, in the order of the bodies; -1 (and an issue) where none or several match.
std::vector<int> select_parts(const std::vector<Part>& parts, const std::vector<BodyOptions>& bodies,
                              std::vector<base::Issue>& issues);

/// The edges a boundary option picks from its body's part, none (and an issue) if nothing matches.
std::optional<EdgeChoice> select_edges(const Part& part, const BoundaryOptions& boundary,
                                       std::vector<base::Issue>& issues);

/// The boundaries a part brings by physical curves.
std::map<std::string, EdgeChoice> named_edges(const Part& part);

}  // namespace reye::cad
