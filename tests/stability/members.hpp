#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stability/grid.hpp"

/// The stability grid: scenes at the rim of what can be asked, each with how it must end.
namespace reye::test {

/// What one unit of the scene's numbers is in mm and N.
struct Units {
  double length = 1.0, force = 1.0;
};

/// A scene key and its value as written in TOML; numbers with a unit as "@mm(0.1)", "@MPa(2e5)", "@N_per_mm(20)",
/// "@per_MPa(1e-6)", "@mm3_per_J(1e-5)" follow the member's units.
using Change = std::pair<std::string, std::string>;

struct Member {
  std::string group, name;
  Blocks blocks;
  std::string scene;
  std::vector<Change> changes;
  Units units;
  std::string refusal;  ///< what the reason must say of a member that cannot be done; empty: it must be done
  int budget = 800;     ///< solves it may take, those on chords included
  /// The member whose figures this one must repeat to `agreement`, relative; empty: none.
  std::string like;
  double agreement = 0.0;

  Member& set(const std::string& key, const std::string& value) {
    changes.emplace_back(key, value);
    return *this;
  }
  Member& same_as(const std::string& other, double relative) {
    like = other;
    agreement = relative;
    return *this;
  }
  Member& refused(const std::string& reason) {
    refusal = reason;
    return *this;
  }
};

/// All members; names are unique.
const std::vector<Member>& members();

/// Numbers with a unit in a text, written in the member's units.
std::string in_units(const std::string& text, const Units& units);

}  // namespace reye::test
