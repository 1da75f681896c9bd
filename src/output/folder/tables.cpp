#include "output/folder/tables.hpp"

#include <fstream>
#include <limits>
#include <stdexcept>

#include "base/printable.hpp"
#include "output/folder/csv.hpp"
#include "output/folder/files.hpp"
#include "output/folder/text.hpp"

namespace reye::output {

Suffixes suffixes(base::Analysis analysis) {
  if (analysis == base::Analysis::axisymmetric) return {"N", "mJ", "worn_volume_mm3"};
  return {"N_per_mm", "mJ_per_mm", "worn_area_mm2"};
}

std::string history_header(const HistoryColumns& columns, base::Analysis analysis) {
  const auto unit = suffixes(analysis);
  std::string line =
      "step,cycle,progress,newton,pressure_max_MPa,depth_max_secondary_mm,depth_max_primary_mm,energy_" + unit.energy;
  for (const auto& contact : columns.contacts)
    for (const auto& column : {std::string("_pressure_max_MPa"), std::string("_depth_max_secondary_mm"),
                               std::string("_depth_max_primary_mm"), "_energy_" + unit.energy,
                               "_normal_force_" + unit.force, "_tangential_force_" + unit.force})
      line += ',' + csv_field(contact + column);
  for (const auto& [support, moment] : columns.supports) {
    for (const char* axis : {"_force_x_", "_force_y_"}) line += ',' + csv_field(support + axis + unit.force);
    if (moment) line += ',' + csv_field(support + "_moment_N_mm_per_mm");
  }
  for (const auto& bond : columns.bonds)
    for (const char* column : {"_tension_max_MPa", "_shear_max_MPa", "_tension_mean_MPa", "_shear_mean_MPa"})
      line += ',' + csv_field(bond + column);
  return line + '\n';
}

std::string history_row(const sim::IncrementRecord& record) {
  std::string line = csv_field(record.step) + ',' + number(record.cycle) + ',' + number(record.progress) + ',' +
                     std::to_string(record.newton);
  for (const double value :
       {record.pressure_max_MPa, record.depth_max_secondary_mm, record.depth_max_primary_mm, record.energy_mJ})
    line += ',' + number(value);
  for (const auto& contact : record.contacts)
    for (const double value : {contact.pressure_max_MPa, contact.depth_max_secondary_mm, contact.depth_max_primary_mm,
                               contact.energy_mJ, contact.normal_force, contact.tangential_force})
      line += ',' + number(value);
  for (std::size_t s = 0; s < record.support_forces.size(); ++s) {
    line += ',' + number(record.support_forces[s].x()) + ',' + number(record.support_forces[s].y());
    if (record.support_moments[s]) line += ',' + number(*record.support_moments[s]);
  }
  for (const auto& bond : record.bonds)
    for (const double value : {bond.tension.MPa, bond.shear.MPa, bond.mean_tension_MPa, bond.mean_shear_MPa})
      line += ',' + number(value);
  return line + '\n';
}

std::string remesh_header(base::Analysis analysis) {
  const bool ring = analysis == base::Analysis::axisymmetric;
  return std::string(
             "step,cycle,body,nodes_before,nodes_after,scaled_jacobian_before,scaled_jacobian_after,projection_mm,") +
         (ring ? "volume_residue_mm3" : "area_residue_mm2") +
         ",gap_moved_mm,gap_left_mm,pressure_jump,peak_jump,force_jump,energy_jump,reason\n";
}

std::string remesh_row(const sim::RemeshRecord& r) {
  std::string line = csv_field(r.step) + ',' + number(r.cycle) + ',' + csv_field(r.body) + ',' +
                     std::to_string(r.nodes_before) + ',' + std::to_string(r.nodes_after);
  for (const double value : {r.scaled_jacobian_before, r.scaled_jacobian_after, r.projection_mm, r.area_residue,
                             r.gap_moved_mm, r.gap_left_mm, r.pressure_jump, r.peak_jump, r.force_jump, r.energy_jump})
    line += ',' + number(value);
  return line + ',' + csv_field(r.reason) + '\n';
}

std::string surface_header() {
  return "frame,cycle,body,arc_length_mm,x_mm,y_mm,pressure_MPa,shear_MPa,slip_mm,wear_depth_mm,status\n";
}

std::string surface_rows(std::size_t index, const sim::Frame& frame, const sim::SurfaceRecord& surface) {
  static constexpr const char* words[] = {"inactive", "stick", "slip"};
  const std::string start = std::to_string(index) + ',' + number(frame.cycle) + ',';
  std::string text;
  for (std::size_t i = 0; i < surface.arc_length_mm.size(); ++i) {
    text += start + csv_field(frame.bodies.at(surface.body.at(i)).name) + ',';
    for (const auto* column : {&surface.arc_length_mm, &surface.x_mm, &surface.y_mm, &surface.pressure_MPa,
                               &surface.shear_MPa, &surface.slip_mm, &surface.wear_depth_mm})
      text += number(column->at(i)) + ',';
    text += words[surface.status.at(i)];
    text += '\n';
  }
  return text;
}

const char* side_name(sim::Side side) { return side == sim::Side::secondary ? "secondary" : "primary"; }

std::string surface_file(const std::string& contact, sim::Side side) {
  return "surface_" + file_part(contact) + '_' + side_name(side) + ".csv";
}

std::uintmax_t size_of_rows(const std::string& path, long rows) {
  std::ifstream file(path, std::ios::binary);
  for (long line = 0; line <= rows && file; ++line) file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  // Reading past the last line break sets eof: the row asked for is missing or only half there.
  if (!file || file.eof())
    throw std::runtime_error(base::printable(path) + " holds fewer than " + std::to_string(rows) + " rows");
  return static_cast<std::uintmax_t>(file.tellg());
}

void keep_rows(const std::string& path, long rows) { cut_file(path, size_of_rows(path, rows)); }

}  // namespace reye::output
