#pragma once
#include <string_view>

#include "base/errors.hpp"
#include "cad/part/raw.hpp"

/// The importer's answer for one file, as bytes through a pipe.
namespace reye::cad {

/// The parts, or the error of the file.
struct Answer {
  std::vector<RawPart> parts;
  std::vector<base::Issue> issues;
};

std::string to_bytes(const Answer& answer);

/// The answer in these untrusted bytes, checked: counts within their size, finite coordinates below 1e9 mm, known
/// kinds, curves of two points or more with as many directions, cells and names of nodes that the mesh has. Throws
/// std::runtime_error naming the check that fails.
Answer answer_of(std::string_view bytes);

}  // namespace reye::cad
