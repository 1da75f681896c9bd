#pragma once

namespace reye::algebra {

/// How the interior is ordered: approximate minimum degree (plane problems), or nested dissection of the graph of nodes
/// (solids: half the time of a factor and less of its memory).
enum class Ordering { minimum_degree, nested_dissection };

}  // namespace reye::algebra
