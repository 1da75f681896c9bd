#include "cad/meshing/step_writing.hpp"

#include <charconv>
#include <string_view>

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
  constexpr std::string_view product = "'Open CASCADE STEP translator ";  // then a version, a space and the number
  std::string named;
  std::size_t from = 0;
  for (auto at = text.find(product); at != std::string::npos; at = text.find(product, from)) {
    const auto space = text.find(' ', at + product.size()), end = text.find('\'', at + 1);
    if (end == std::string::npos) throw base::MeshError("gmsh: a product of a STEP file without a name");
    const auto point = text.find('.', space);
    std::size_t face = 0;  // counted from 1
    if (point < end) std::from_chars(text.data() + point + 1, text.data() + end, face);
    const std::size_t k = face > 0 ? face - 1 : 0;
    const bool whole = face == 0 && faces.size() > 1;
    named.append(text, from, at - from);
    named += whole || k >= faces.size() ? "'worn shape'" : in_apostrophes(faces[k].name);
    from = end + 1;
  }
  return named.append(text, from);
}

}  // namespace

std::string step_text(const std::vector<PlaneFace>& faces, const std::string& note) {
  std::string text = with_names(kernel().write_step(faces), faces);
  replace_between(text, "FILE_DESCRIPTION(", ");", "(" + in_apostrophes(note) + "),'2;1'");
  replace_between(text, "FILE_NAME(", ");", "'worn shape','',(''),(''),'reye','reye',''");
  return text;
}

}  // namespace reye::cad
