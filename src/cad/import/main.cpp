#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>

#include "cad/import/face_server.hpp"
#include "cad/import/guard.hpp"
#include "cad/import/messages.hpp"
#include "cad/import/read_file.hpp"
#include "cad/import/same_addresses.hpp"
#include "cad/import/solid_server.hpp"
#include "cad/meshing/kernel.hpp"
#include "cad/part/importer_process.hpp"
#include "cad/part/raw_bytes.hpp"

/// reye-import: reads geometry files for another program, which starts it (`cad/importer`), and can do nothing else.
///   reye-import guarded|trusted FOLDER SECTION FILE...
///   reye-import guarded|trusted FOLDER solid FILE    FOLDER: as seen from that of FILE, an absolute path
///   reye-import guarded|trusted FOLDER fill|faces -
/// SECTION: six numbers, point and normal, or "-". Its messages go to descriptor 3, each preceded by its size: first
/// whether the system keeps it from anything but reading, then an answer for each file; after files of plane faces, of
/// which one needed gmsh, the mesh of each region on standard input (`face_server`); of solids, an answer to each
/// request there (`solid_server`). With `fill`, surfaces to be filled by solids are there, with `faces` regions.
namespace {

using namespace reye;
using cad::say;

std::optional<cad::Section> section_of(const char* text) {
  cad::Section section;
  char* rest = const_cast<char*>(text);
  for (cad::Vec3* v : {&section.point_mm, &section.normal})
    for (double& x : *v) {
      char* const begin = rest;
      x = std::strtod(begin, &rest);
      if (rest == begin) return std::nullopt;
    }
  return section;
}

cad::Answer answer_about(const std::string& file, const cad::Reading& how) {
  const auto refused = [&](const std::string& rule) {
    return cad::Answer{{}, {{"geometry", "\"" + file + "\"", rule}}};
  };
  try {
    return {cad::read_file(file, how), {}};
  } catch (const base::InputError& error) {
    return {{}, error.issues()};
  } catch (const std::bad_alloc&) {
    return refused("reading it takes more than 3 GB of memory");
  } catch (const std::exception& error) {
    return refused(std::string("cannot be read: ") + error.what());
  } catch (...) {
    return refused("cannot be read");
  }
}

/// Goes to the folder of a file and leaves its name alone in `word`, without a text of its own length: gmsh orders some
/// of its sets by addresses of memory, which such texts move, and a scene had another mesh in each folder.
void go_beside(char* word) {
  char* const slash = std::strrchr(word, '/');
  if (slash == nullptr || slash == word) return;
  *slash = '\0';
  if (::chdir(word) != 0) std::_Exit(1);
  word[0] = '.';
  word[1] = '/';
  std::memmove(word + 2, slash + 1, std::strlen(slash + 1) + 1);
}

}  // namespace

int main(int count, char** words) {
  if (count < 5) {
    std::fputs("reye-import is started by reye\n", stderr);
    return 2;
  }
  const std::string task = words[3];
  const bool without_files = task == "fill" || task == "faces";
  const bool with_gmsh = without_files || std::any_of(words + 4, words + count, cad::needs_gmsh);
  const bool trusted = std::string(words[1]) == "trusted";
  // The second start leaves the environment behind, which a trusted script of plane faces may need.
  if (task == "solid" || without_files || (with_gmsh && !trusted)) cad::start_with_same_addresses(words);
  if (task == "solid") go_beside(words[4]);
  const cad::Reading how{section_of(words[3]), words[2], trusted};
  const std::vector<std::string> files(words + (without_files ? count : 4), words + count);
  std::vector<std::string> folders{how.folder};
  for (const std::string& file : files) folders.push_back(std::filesystem::path(file).parent_path().string());
  cad::end_with_parent();
  if (!how.trusted) cad::limit_memory();
  if (with_gmsh) cad::kernel();  // loaded before the restriction to reading
  const bool guarded = how.trusted || cad::forbid_all_but_reading(folders);
  say(guarded ? "guarded" : "open");
  if (task == "solid") {
    cad::serve_solids(files[0], how);
  } else if (task == "fill") {
    cad::serve_fillings(how);
  } else {
    for (const std::string& file : files) {
      if (!how.trusted) cad::limit_computing(cad::computing_s);
      say(cad::to_bytes(answer_about(file, how)));
    }
    if (with_gmsh) cad::serve_faces(how);
  }
  std::_Exit(0);  // nothing to clean up, and libraries that failed may fail again at exit
}
