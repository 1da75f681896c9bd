#include "output/export/worn_skins.hpp"

#include <filesystem>

#include "base/errors.hpp"
#include "output/folder/csv.hpp"
#include "output/folder/text.hpp"
#include "output/solid/solid_run_data.hpp"
#include "output/solid/solid_tables.hpp"

namespace reye::output {

namespace {

/// The rows of one side of a contact in a frame; how many there are.
std::size_t add_rows(const Table& table, double frame, const std::string& start, const std::string& only,
                     std::string& text) {
  const auto &frames = table.column("frame"), &body = table.column("body"), &x = table.column("x_mm"),
             &y = table.column("y_mm"), &z = table.column("z_mm"), &depth = table.column("wear_depth_mm");
  std::size_t count = 0;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (frames[i] != frame) continue;
    ++count;
    const std::string& name = table.word(body[i]);
    if (!only.empty() && name != only) continue;
    text += start + csv_field(name);
    for (const double value : {x[i], y[i], z[i], depth[i]}) text += ',' + number(value);
    text += '\n';
  }
  return count;
}

}  // namespace

std::string worn_faces_csv(const std::string& dir, std::size_t frame, const std::string& body,
                           const std::string& note) {
  std::string text = "# " + note + "\ncontact,side,body,x_mm,y_mm,z_mm,wear_depth_mm\n";
  for (const auto& contact : read_solid_run(dir).inputs.contacts)
    for (const auto side : {sim::Side::secondary, sim::Side::primary}) {
      const auto file = (std::filesystem::path(dir) / surface_file(contact, side)).string();
      if (!std::filesystem::exists(file)) continue;
      const std::string start = csv_field(contact) + ',' + side_name(side) + ',';
      if (add_rows(read_table(file, skin_header(), false), static_cast<double>(frame), start, body, text) == 0)
        throw base::InputError({{"dir", "", file + " is damaged: it has no rows of frame " + std::to_string(frame)}});
    }
  return text;
}

}  // namespace reye::output
