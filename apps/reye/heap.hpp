#pragma once

namespace reye::apps {

/// Tells the allocator to keep what is freed and to use large pages: a run frees and takes the same large arrays again
/// and again, and what goes back to the system comes anew page by page (an eighth of a short run). Nothing where it is
/// not glibc's.
void keep_heap();

}  // namespace reye::apps
