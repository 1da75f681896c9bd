#include "output/solid/solid_run_data.hpp"

#include <filesystem>

#include "base/errors.hpp"
#include "output/solid/solid_tables.hpp"

namespace reye::output {

namespace fs = std::filesystem;

SolidRunData read_solid_run(const std::string& dir) {
  SolidRunData data;
  data.dir = dir;
  data.run.identity = identity_in(dir);
  if (!data.run.identity.solid) throw base::InputError({{"dir", dir, "holds no run of solids"}});
  const auto file = [&](const char* name) { return (fs::path(dir) / name).string(); };
  try {
    data.inputs = read_inputs(file("inputs.json"));
    data.run.summary = read_summary(file("summary.json"));
    const bool ended = data.run.summary.is_object();
    if (fs::exists(file("history.csv")))
      data.run.history =
          read_table(file("history.csv"), solid_history_header({data.inputs.contacts, data.inputs.supports}), ended);
    else if (ended)
      throw base::InputError({{"dir", "", file("history.csv") + " is missing, though the run has ended"}});
    if (ended && data.run.summary["status"] == "done")
      check_end(data.run.history, file("history.csv"), data.run.summary);
    if (fs::exists(file("remesh.csv")))
      data.run.remeshes = read_table(file("remesh.csv"), solid_remesh_header(), ended);
  } catch (const base::InputError&) {
    throw;
  } catch (const std::runtime_error& error) {  // a file that cannot be read at all
    throw base::InputError({{"dir", "", error.what()}});
  }
  while (data.inputs.paraview && fs::is_regular_file(frame_path(dir, "surface", "vtp", data.frames))) ++data.frames;
  return data;
}

DrawnSkins skins_of(const SolidRunData& data, std::size_t frame) {
  return read_drawn_skins(frame_path(data.dir, "surface", "vtp", frame));
}

const DrawnSkin* secondary_of(const DrawnSkins& skins, const std::string& contact) {
  for (const auto& skin : skins.all)
    if (skin.secondary && skin.contact == contact) return &skin;
  return nullptr;
}

std::string before_titles(const SolidRunData& data, const std::string& contact) {
  return data.inputs.contacts.size() > 1 ? contact + ": " : "";
}

}  // namespace reye::output
