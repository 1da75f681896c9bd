#pragma once

namespace reye::apps {

/// Makes the allocator keep freed memory and use large pages: a run frees and takes the same large arrays again
/// and again, and memory returned to the system comes back page by page (an eighth of a short run). Does nothing with
/// an allocator other than glibc's.
void keep_heap();

}  // namespace reye::apps
