#pragma once
#include <string>

namespace reye::apps {

/// Where a run writes, and how it begins there.
struct RunPlace {
  std::string dir;       ///< output folder; empty: nothing is written, the tables are kept in memory
  bool restart = false;  ///< resumes from the last checkpoint; needs a folder
  bool force = false;    ///< takes over a folder that holds another scene's run
};

}  // namespace reye::apps
