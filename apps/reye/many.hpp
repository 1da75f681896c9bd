#pragma once
#include "runs/sweep.hpp"

namespace reye::apps {

/// `reye sweep`: 0 when every member is done, 1 when one is not, 130 when interrupted; bad input is thrown as
/// base::InputError.
int sweep(const SweepRequest& request, bool quiet);

}  // namespace reye::apps
