#pragma once

namespace reye::cad {

/// Lets only those system calls through that reading files and computing need (seccomp); all others fail with EPERM, as
/// does opening a file for writing. True when the kernel took the filter; the process must have given up new
/// privileges.
bool filter_system_calls();

}  // namespace reye::cad
