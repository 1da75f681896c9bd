#pragma once
#include <string>

#include "base/errors.hpp"

namespace reye::cad {

/// The one gmsh session, from construction to destruction: silent, single-threaded (so that runs repeat),
/// without the user's configuration files. gmsh's state is global: two sessions must not overlap.
class Session {
 public:
  Session();
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
};

/// Discards what libraries print to standard output during its lifetime, as OCCT does during import.
class Silence {
 public:
  Silence();
  ~Silence();
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int kept_ = -1;
};

/// Runs f; gmsh throws bare strings, callers get a base::MeshError.
template <class F>
auto guarded(F f) {
  try {
    return f();
  } catch (const std::string& message) {
    throw base::MeshError("gmsh: " + message);
  }
}

}  // namespace reye::cad
