#include "cad/part/beside.hpp"

#include <dlfcn.h>
#include <link.h>

#include <filesystem>
#include <stdexcept>

namespace reye::cad {

namespace fs = std::filesystem;

namespace {

/// The module that holds this code; empty where that is the program itself.
fs::path own_module() {
  Dl_info info{};
  void* loaded = nullptr;
  const bool found = ::dladdr1(reinterpret_cast<void*>(&own_module), &info, &loaded, RTLD_DL_LINKMAP) != 0;
  const auto* const map = static_cast<const link_map*>(loaded);
  return found && map ? map->l_name : "";  // the program has no name there
}

fs::path programs_of(const fs::path& module) {
  for (fs::path above = module.parent_path(); above != above.parent_path(); above = above.parent_path())
    if (fs::exists(above / "bin" / "reye-import")) return above / "bin";
  throw std::runtime_error("no folder above " + module.string() +
                           " holds bin/reye-import, the program that reads geometry");
}

/// Where the module lay when it was loaded: its path may be relative, and the working folder may change.
const fs::path module_when_loaded = own_module().empty() ? fs::path() : fs::absolute(own_module());

}  // namespace

std::string beside_program(const std::string& name) {
  const fs::path programs = module_when_loaded.empty() ? fs::read_symlink("/proc/self/exe").parent_path()
                                                       : programs_of(fs::canonical(module_when_loaded));
  return (programs / name).lexically_normal().string();
}

}  // namespace reye::cad
