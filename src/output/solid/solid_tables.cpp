#include "output/solid/solid_tables.hpp"

#include <stdexcept>

#include "output/folder/csv.hpp"
#include "output/folder/text.hpp"

namespace reye::output {

namespace {

constexpr const char* axes_of_space = "xyz";

void add_cells(std::string& line, const base::Vec3& v) {
  for (int i = 0; i < 3; ++i) line += ',' + number(v[i]);
}

}  // namespace

std::string solid_history_header(const SolidColumns& columns) {
  std::string line = "step,cycle,progress,newton";
  for (const auto& contact : columns.contacts)
    for (const char* column :
         {"_pressure_max_MPa", "_area_mm2", "_stick_area_mm2", "_force_x_N", "_force_y_N", "_force_z_N",
          "_normal_force_N", "_tangential_force_N", "_energy_mJ", "_depth_max_secondary_mm", "_depth_max_primary_mm",
          "_volume_secondary_mm3", "_volume_primary_mm3"})
      line += ',' + csv_field(contact + column);
  for (const auto& support : columns.supports)
    for (const auto& [quantity, unit] : {std::pair("_force_", "_N"), std::pair("_moment_", "_N_mm")})
      for (const char* axis = axes_of_space; *axis; ++axis) line += ',' + csv_field(support + quantity + *axis + unit);
  return line + '\n';
}

std::string solid_history_row(const sim::SolidIncrement& record, const SolidColumns& columns) {
  if (record.contacts.size() != columns.contacts.size() || record.supports.size() != columns.supports.size())
    throw std::logic_error("an increment has other contacts or supports than its scene");
  std::string line = csv_field(record.step) + ',' + number(record.cycle) + ',' + number(record.progress) + ',' +
                     std::to_string(record.newton);
  for (const auto& contact : record.contacts) {
    for (const double value : {contact.pressure_max_MPa, contact.area_mm2, contact.stick_area_mm2})
      line += ',' + number(value);
    add_cells(line, contact.force_N);
    for (const double value :
         {contact.normal_force_N, contact.tangential_force_N, contact.energy_mJ, contact.depth_secondary_mm,
          contact.depth_primary_mm, contact.volume_secondary_mm3, contact.volume_primary_mm3})
      line += ',' + number(value);
  }
  for (const auto& support : record.supports) {
    add_cells(line, support.force_N);
    add_cells(line, support.moment_N_mm);
  }
  return line + '\n';
}

std::string solid_remesh_header() {
  return "step,cycle,body,nodes_before,nodes_after,quality_before,quality_after,fresh_facets,volume_residue_mm3,"
         "correction_mm,pressure_change,fit_mm,reason\n";
}

std::string solid_remesh_row(const sim::SolidRemeshRecord& r) {
  std::string line = csv_field(r.step) + ',' + number(r.cycle) + ',' + csv_field(r.body);
  for (const int count : {r.nodes_before, r.nodes_after}) line += ',' + std::to_string(count);
  for (const double value : {r.quality_before, r.quality_after}) line += ',' + number(value);
  line += ',' + std::to_string(r.fresh_facets);
  for (const double value : {r.volume_residue_mm3, r.correction_mm, r.pressure_change, r.fit_mm})
    line += ',' + number(value);
  return line + ',' + csv_field(r.reason) + '\n';
}

std::string skin_header() {
  return "frame,cycle,body,node,x_mm,y_mm,z_mm,pressure_MPa,shear_x_MPa,shear_y_MPa,shear_z_MPa,slip_x_mm,slip_y_mm,"
         "slip_z_mm,area_mm2,wear_depth_mm,status\n";
}

std::string skin_rows(std::size_t index, double cycle, const std::vector<std::string>& bodies,
                      const sim::SkinRecord& skin) {
  static constexpr const char* words[] = {"inactive", "stick", "slip"};
  const std::string start = std::to_string(index) + ',' + number(cycle) + ',';
  std::string text;
  for (std::size_t i = 0; i < skin.x_mm.size(); ++i) {
    text += start + csv_field(bodies.at(skin.body.at(i))) + ',' + std::to_string(skin.node.at(i));
    add_cells(text, skin.x_mm[i]);
    text += ',' + number(skin.pressure_MPa.at(i));
    add_cells(text, skin.shear_MPa.at(i));
    add_cells(text, skin.slip_mm.at(i));
    const int status = skin.status.at(i);
    if (status < 0 || status > 2) throw std::logic_error("a node of a contact has an unknown status");
    text += ',' + number(skin.area_mm2.at(i)) + ',' + number(skin.wear_depth_mm.at(i)) + ',' + words[status] + '\n';
  }
  return text;
}

}  // namespace reye::output
