#pragma once
#include <string>
#include <vector>

#include "output/report/run_data.hpp"
#include "output/solid/solid_inputs.hpp"
#include "output/solid/solid_vtk.hpp"

namespace reye::output {

/// A run of solids as its folder holds it.
struct SolidRunData {
  RunData run;  ///< identity, summary and history; no surface tables
  SolidInputs inputs;
  std::string dir;
  std::size_t frames = 0;  ///< files of surfaces that are there, from the first on
};

/// Reads what is there; all of it must be if the run has ended. Throws base::InputError with the file that is missing,
/// cut or altered.
SolidRunData read_solid_run(const std::string& dir);

/// The surfaces of a frame.
DrawnSkins skins_of(const SolidRunData& data, std::size_t frame);

/// The secondary side of a contact; null where the frame has none.
const DrawnSkin* secondary_of(const DrawnSkins& skins, const std::string& contact);

/// "pad: " where there are several contacts, else nothing.
std::string before_titles(const SolidRunData& data, const std::string& contact);

}  // namespace reye::output
