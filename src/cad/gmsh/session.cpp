#include "cad/gmsh/session.hpp"

#include <fcntl.h>
#include <gmsh.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>

namespace reye::cad {

namespace {

/// gmsh initialised from the first session to the end of the program: each new start costs time and leaves memory
/// behind, and a run may make a thousand meshes.
struct Library {
  Library() { gmsh::initialize(0, nullptr, false); }
  ~Library() {
    try {
      gmsh::finalize();
    } catch (...) {  // nothing to save and nobody to notify
    }
  }
};

}  // namespace

Session::Session() {
  guarded([] {
    static const Library library;
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
  });
}

Session::~Session() {
  try {
    gmsh::clear();
  } catch (...) {  // nothing to save and nobody to notify
  }
}

Silence::Silence() {
  std::cout.flush();
  std::fflush(stdout);
  kept_ = dup(STDOUT_FILENO);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  dup2(nowhere, STDOUT_FILENO);
  close(nowhere);
}

Silence::~Silence() {
  if (kept_ < 0) return;
  std::cout.flush();
  std::fflush(stdout);
  dup2(kept_, STDOUT_FILENO);
  close(kept_);
}

}  // namespace reye::cad
