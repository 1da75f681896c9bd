#include "cad/meshing/step_writing.hpp"

#include "base/errors.hpp"
#include "cad/meshing/kernel.hpp"

namespace reye::cad {

namespace {

/// A text as STEP writes it, between apostrophes: other characters than those of ASCII become question marks.
std::string in_apostrophes(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') quoted += c;
    quoted += c >= 0x20 && c < 0x7f ? c : '?';
  }
  return quoted + '\'';
}

/// Replaces what stands from `begin` to the next `end`, which stays.
void replace_between(std::string& text, const std::string& begin, const std::string& end, const std::string& by) {
  const auto from = text.find(begin);
  const auto to = text.find(end, from);
  if (from == std::string::npos || to == std::string::npos) throw base::MeshError("gmsh: no header of a STEP file");
  text.replace(from + begin.size(), to - from - begin.size(), by);
}

}  // namespace

std::string step_text(const std::vector<PlaneFace>& faces, const std::string& note) {
  std::string text = kernel().write_step(faces);
  replace_between(text, "FILE_DESCRIPTION(", ";", "(" + in_apostrophes(note) + "),'2;1')");
  replace_between(text, "FILE_NAME(", ";", "'worn shape','',(''),(''),'reye','reye','')");
  return text;
}

}  // namespace reye::cad
