#pragma once
#include <string>
#include <vector>

/// What keeps the importer from doing anything but read: whatever a file makes gmsh, OpenCASCADE or VTK do.
namespace reye::cad {

/// This process ends when the one that started it does.
void end_with_parent();

/// From here on it may take 3 GB of memory, and let no file grow.
void limit_memory();

/// So many seconds of computing from now on; then the system ends the process (SIGXCPU).
void limit_computing(int seconds);

/// From here on this process and what it may start can run no program, open no file for writing, make, rename or remove
/// none, and reach no network (a filter of system calls: all that is not needed to read files is refused); where the
/// kernel has Landlock, it reads only below `folders` and where programs are installed. Irrevocable.
/// False where the kernel has no such filter, as in some containers.
bool forbid_all_but_reading(const std::vector<std::string>& folders);

}  // namespace reye::cad
