#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "base/issue.hpp"

namespace reye::base {

/// All errors of the input, collected and shown together. `what()` holds one line per issue.
/// Rooms that know nothing of files throw it with bare issues; `scene` adds file and line.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Issue> issues);
  InputError(std::vector<Issue> issues, const std::string& text);
  const std::vector<Issue>& issues() const { return issues_; }

 private:
  std::vector<Issue> issues_;
};

/// gmsh or a mesh operation gave an unusable result.
class MeshError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A factorisation or solve that failed; the solver turns it into a failed step with this reason.
class SolveError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace reye::base
