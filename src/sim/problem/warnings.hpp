#pragma once
#include <vector>

#include "sim/problem/observer.hpp"
#include "sim/problem/records.hpp"
#include "sim/problem/state.hpp"

/// What a reader must know before trusting the results of a run that is otherwise done.
namespace reye::sim {

/// Adds a warning; of one kind about one thing only the most severe stays. True: it is new.
bool warn(std::vector<Warning>& list, Warning warning);

/// Adds a warning to those of a state. The log reports a warning when it is new.
void warn(State& state, const Observer& observer, Warning warning);

/// "resolution, contact pad: ..." for a line of text.
std::string in_words(const Warning& warning);

}  // namespace reye::sim
