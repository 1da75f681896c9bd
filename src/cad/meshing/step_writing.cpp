#include "cad/meshing/step_writing.hpp"

#include <regex>

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

/// Names the products, which OpenCASCADE numbers: 1 for the whole file, 1.1, 1.2 ... for its faces where it has
/// several.
std::string with_names(const std::string& text, const std::vector<PlaneFace>& faces) {
  static const std::regex product("'Open CASCADE STEP translator [0-9.]+ [0-9]+(\\.([0-9]+))?'");
  std::string named;
  auto from = text.cbegin();
  for (std::sregex_iterator at(text.begin(), text.end(), product), end; at != end; ++at) {
    const std::string number = (*at)[2].str();
    const std::size_t k = number.empty() ? 0 : std::stoul(number) - 1;
    const bool whole = number.empty() && faces.size() > 1;
    named.append(from, (*at)[0].first);
    named += whole || k >= faces.size() ? "'worn shape'" : in_apostrophes(faces[k].name);
    from = (*at)[0].second;
  }
  return named.append(from, text.cend());
}

}  // namespace

std::string step_text(const std::vector<PlaneFace>& faces, const std::string& note) {
  std::string text = with_names(kernel().write_step(faces), faces);
  replace_between(text, "FILE_DESCRIPTION(", ");", "(" + in_apostrophes(note) + "),'2;1'");
  replace_between(text, "FILE_NAME(", ");", "'worn shape','',(''),(''),'reye','reye',''");
  return text;
}

}  // namespace reye::cad
