#pragma once
#include <string>
#include <vector>

/// Restrictions that let the importer only read, whatever a file makes gmsh, OpenCASCADE or VTK do.
namespace reye::cad {

/// Ends this process when the one that started it ends.
void end_with_parent();

/// Ignores the signals that end a whole group of processes: this one ends with its parent.
void ignore_ends_of_groups();

/// Limits this process to so many GB of memory, and lets no file grow.
void limit_memory(int gigabytes = 3);

/// Limits computing to so many seconds from now; then the system ends the process (SIGXCPU).
void limit_computing(int seconds);

/// Restricts this process and its children: they can run no program, open no file for writing, make, rename or remove
/// none, and reach no network (a filter of system calls: all that is not needed to read files is refused); where the
/// kernel has Landlock, it reads only below `folders` and where programs are installed. Irrevocable.
/// False where the kernel has no such filter, as in some containers.
bool forbid_all_but_reading(const std::vector<std::string>& folders);

}  // namespace reye::cad
