#include "cad/import/read_file.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "base/errors.hpp"
#include "cad/import/content.hpp"
#include "cad/import/read_vtu.hpp"
#include "cad/import/script.hpp"
#include "cad/meshing/kernel.hpp"

namespace reye::cad {

namespace {

constexpr const char* formats = ".step .stp .iges .igs .brep .geo .geo_unrolled .msh .vtu";

/// gmsh opens missing and empty files without an error, so they are checked first.
void check_readable(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) refuse(path, "there is no such file");
  if (!std::filesystem::is_regular_file(path, error)) refuse(path, "is not a file");
  if (!std::ifstream(path)) refuse(path, "the file cannot be read");
  if (std::filesystem::file_size(path, error) == 0) refuse(path, "the file is empty");
}

Format format_of(const std::string& path) {
  const std::string ext = extension(path);
  for (const char* shape : {".step", ".stp", ".iges", ".igs", ".brep"})
    if (ext == shape) return Format::shapes;
  if (ext == ".geo" || ext == ".geo_unrolled") return Format::script;
  if (ext == ".msh") return Format::mesh;
  if (ext == ".vtu") return Format::vtu;
  refuse(path, "the format must be one of " + std::string(formats));
}

/// gmsh's parser drops all but the first statement of a last line that does not end.
void check_last_line(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line))
    if (file.eof() && std::count(line.begin(), line.end(), ';') > 1)
      refuse(path, "the last line must end with a line break, or gmsh reads only its first statement");
}

}  // namespace

Format checked_format(const std::string& path, const Reading& how) {
  const Format format = format_of(path);
  check_readable(path);
  check_content(path, format);
  if (format == Format::script) {
    check_last_line(path);
    if (!how.trusted)
      if (auto issues = unsafe_commands(path, how.folder); !issues.empty()) throw base::InputError(std::move(issues));
  }
  return format;
}

std::vector<RawPart> read_file(const std::string& path, const Reading& how) {
  const Format format = checked_format(path, how);
  if (format == Format::vtu) return read_vtu(path);
  return kernel().read_file(path, format, how.section);
}

}  // namespace reye::cad
