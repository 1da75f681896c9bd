#pragma once

namespace reye::output {

/// The commit that this program was built from, with a + behind it where files had been changed; "unknown" outside of a
/// clone.
const char* commit();

}  // namespace reye::output
