#include "cad/import/content.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <string_view>

namespace reye::cad {

namespace {

constexpr std::array<std::string_view, 14> sections = {"MeshFormat",
                                                       "PhysicalNames",
                                                       "Entities",
                                                       "PartitionedEntities",
                                                       "Nodes",
                                                       "Elements",
                                                       "Periodic",
                                                       "GhostElements",
                                                       "Parametrizations",
                                                       "NodeData",
                                                       "ElementData",
                                                       "ElementNodeData",
                                                       "InterpolationScheme",
                                                       "Comments"};

std::string_view without_blanks(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // as some editors write it
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view{} : text.substr(first);
}

void check_shapes(const std::string& path, std::string_view text) {
  const std::string_view begin = without_blanks(text);
  const std::string ext = extension(path);
  if ((ext == ".step" || ext == ".stp") && !begin.starts_with("ISO-10303-21"))
    refuse(path, "is not a STEP file: it must begin with ISO-10303-21");
  if (ext == ".brep" && !begin.starts_with("DBRep_DrawableShape") && !begin.starts_with("CASCADE Topology"))
    refuse(path, "is not a BREP file: it must begin with DBRep_DrawableShape or CASCADE Topology");
  const auto sorts = std::string_view("SCB");  // of an IGES line: start, compressed, binary
  if ((ext == ".iges" || ext == ".igs") && (text.size() < 80 || sorts.find(text[72]) == std::string_view::npos))
    refuse(path, "is not an IGES file: column 73 of its first line must be an S");
}

void check_mesh(const std::string& path, std::string_view text) {
  if (!text.starts_with("$MeshFormat"))
    refuse(path, "is not a mesh of gmsh: it must begin with $MeshFormat (version 2 or 4)");
  const std::size_t format = text.find('\n');
  const bool binary =
      format != std::string_view::npos && text.substr(format + 1, 8).find(" 1 ") != std::string_view::npos;
  if (binary) return;  // a $ may be any byte of a number
  int line = 1;
  for (std::size_t begin = 0; begin < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view word = text.substr(begin, end - begin);
    begin = end + 1;
    if (!word.starts_with('$')) continue;
    word.remove_prefix(word.starts_with("$End") ? 4 : 1);
    while (!word.empty() && (word.back() == '\r' || word.back() == ' ')) word.remove_suffix(1);
    if (std::find(sections.begin(), sections.end(), word) == sections.end())
      refuse(path,
             "line " + std::to_string(line) + ": $" + std::string(word.substr(0, 40)) + " is not a section of a mesh");
  }
}

}  // namespace

void check_content(const std::string& path, Format format) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (format == Format::shapes) check_shapes(path, text);
  if (format == Format::mesh) check_mesh(path, text);
  if (format == Format::vtu && !without_blanks(text).starts_with('<'))
    refuse(path, "is not a .vtu: it must begin as XML does");
}

}  // namespace reye::cad
