#include "output/report/report_tables.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "output/folder/text.hpp"
#include "output/report/html.hpp"
#include "output/report/json_cells.hpp"

namespace reye::output {

using Json = nlohmann::ordered_json;

namespace {

struct Quantity {
  std::string label, key, unit;
  double factor = 1.0;  ///< from the unit of the key to that of the table
};

std::vector<Quantity> contact_quantities(const Suffixes& unit) {
  const std::string per = unit.force == "N" ? "" : " per mm";
  return {{"Peak pressure", "peak_pressure_MPa", "MPa"},
          {"Contact half width", "contact_half_width_mm", "mm"},
          {"Stick half width", "stick_half_width_mm", "mm"},
          {"Normal force, resultant", "normal_force_" + unit.force, "N" + per},
          {"Tangential force, resultant", "tangential_force_" + unit.force, "N" + per},
          {"Dissipated energy", "dissipated_energy_" + unit.energy, "mJ" + per}};
}

std::vector<Quantity> side_quantities(const Suffixes& unit) {
  const bool ring = unit.force == "N";
  return {{"Largest depth", "max_depth_mm", "µm", 1e3},
          {ring ? "Worn volume" : "Worn area", unit.worn, ring ? "mm³" : "mm²"},
          {"Scar width", "scar_width_mm", "mm"}};
}

/// Whether a tangential force is nothing beside the normal one.
bool only_round_off(const Json& contact, const Quantity& q, const Suffixes& unit) {
  const Json &force = json_part(contact, q.key), &normal = json_part(contact, "normal_force_" + unit.force);
  return q.key.starts_with("tangential_force") && force.is_number() && normal.is_number() &&
         std::abs(force.get<double>()) < 1e-10 * std::abs(normal.get<double>());
}

std::string contact_table(const RunData& run) {
  const auto unit = suffixes(run.identity.analysis);
  const Json& contacts = json_part(run.summary, "contacts");
  Row head{"At the end of the run"};
  for (const auto& item : contacts.items()) head.push_back(item.key());
  head.push_back("unit");
  std::vector<Row> rows;
  const auto add = [&](const Quantity& q, const std::string& side) {
    Row row{side.empty() ? q.label : q.label + ", " + side};
    for (const auto& contact : contacts)
      row.push_back(only_round_off(contact, q, unit)
                        ? "0"
                        : json_cell(side.empty() ? contact : json_part(contact, side), q.key, 5, q.factor));
    row.push_back(q.unit);
    rows.push_back(std::move(row));
  };
  if (contacts.empty()) return {};
  for (const auto& q : contact_quantities(unit)) add(q, "");
  for (const std::string side : {"secondary", "primary"}) {
    const bool worn = std::any_of(contacts.begin(), contacts.end(), [&](const Json& contact) {
      const Json& depth = json_part(json_part(contact, side), "max_depth_mm");
      return !depth.is_number() || depth.get<double>() != 0.0;
    });
    if (worn)
      for (const auto& q : side_quantities(unit)) add(q, side);
    else
      rows.emplace_back(head.size(), "–").front() = "Wear, " + side + " side";
  }
  return html_table(head, rows);
}

/// ", 1000 to 4000 under the scatter of wear"; empty where the limit has none or is not reached.
std::string band_of(const RunData& run, const std::string& limit) {
  const Json& band = json_part(json_part(run.summary, "life_band"), limit);
  if (!json_part(band, "longest_cycles").is_number()) return {};
  return ", " + json_cell(band, "shortest_cycles", 6) + " to " + json_cell(band, "longest_cycles", 6) +
         " under the scatter of wear";
}

constexpr const char* singular_note =
    "<p class=\"quiet\">At a free end of a bond between two materials the stress has no bound: the largest value there "
    "grows as elements get shorter. Compare means, or one mesh with the same mesh.</p>\n";

/// Where the largest traction of a bond is, and when.
std::string place_of_peak(const Json& most, const std::string& peak, bool at_end) {
  if (!json_part(most, peak + "_x_mm").is_number()) return "–";
  return "(" + json_cell(most, peak + "_x_mm") + ", " + json_cell(most, peak + "_y_mm") + "), cycle " +
         json_cell(most, peak + "_cycle", 8) + (at_end ? ", at the end of the bond" : "");
}

/// The largest tractions of the run, where and when; those at a free end of a bond depend on the mesh.
std::string bond_table(const RunData& run) {
  std::vector<Row> rows;
  bool singular = false;
  for (const auto& [name, bond] : json_part(run.summary, "bonds").items())
    for (const std::string key : {"tension", "shear"}) {
      const Json &most = json_part(bond, "most"), &end = json_part(bond, "end");
      const std::string peak = "peak_" + key;
      const bool at_end = json_part(most, peak + "_at_end") == true;
      singular = singular || at_end;
      rows.push_back({name + ", " + key, json_cell(most, peak + "_MPa", 4), json_cell(end, peak + "_MPa", 4),
                      json_cell(end, "mean_" + key + "_MPa", 4), place_of_peak(most, peak, at_end)});
    }
  const Row head{"Bond, MPa", "largest of the run", "largest at its end", "mean at its end",
                 "where the largest, mm, and when"};
  return html_table(head, rows, {4}) + (singular ? singular_note : "");
}

std::string probe_table(const RunData& run) {
  std::vector<Row> rows;
  for (const auto& [name, u] : json_part(run.summary, "probes").items())
    rows.push_back({name, json_cell(u, "u_x_mm"), json_cell(u, "u_y_mm")});
  return html_table({"Probe", "u_x, mm", "u_y, mm"}, rows);
}

std::string count_table(const RunData& run) {
  std::vector<Row> rows{{"Cycles", json_cell(run.summary, "cycles", 8)}};
  for (const auto& [key, label] : {std::pair("blocks", "Blocks of cycles"), std::pair("increments", "Increments"),
                                   std::pair("newton_iterations", "Newton iterations"),
                                   std::pair("equilibrium_iterations", "Newton iterations on worn and fresh shapes"),
                                   std::pair("factorisations", "Factorisations"), std::pair("remeshes", "Remeshes"),
                                   std::pair("cutbacks", "Cut-backs")})
    rows.push_back({label, json_cell(json_part(run.summary, "counts"), key, 12)});
  rows.push_back({"Wall time, s", json_cell(run.summary, "wall_s", 4)});
  rows.push_back({"Processor time, s", json_cell(run.summary, "cpu_s", 4)});
  rows.push_back({"Largest memory, MB", json_cell(run.summary, "peak_rss_MB", 4)});
  return html_table({"Counts", ""}, rows);
}

/// Cells of one row of remesh.csv; jumps in percent.
Row remesh_cells(const Table& t, std::size_t i) {
  const auto value = [&](const char* column) { return t.column(column).at(i); };
  Row row{rounded(value("cycle"), 8), t.word(value("body")),
          rounded(value("nodes_before"), 9) + " → " + rounded(value("nodes_after"), 9)};
  for (const char* jump : {"pressure_jump", "force_jump", "energy_jump"})
    row.push_back(rounded(100.0 * value(jump), 2));
  row.push_back(rounded(1e3 * value("projection_mm"), 3));
  row.push_back(t.word(value("reason")));
  return row;
}

}  // namespace

std::string life_table(const RunData& run) {
  std::vector<Row> rows;
  for (const auto& [name, cycles] : json_part(run.summary, "life_cycles").items())
    rows.push_back({name, (cycles.is_number() ? rounded(cycles.get<double>(), 6) + " cycles" : "not reached") +
                              band_of(run, name)});
  return html_table({"Limit", "life"}, rows);
}

std::string error_table(const RunData& run) {
  const Json& error = json_part(run.summary, "estimated_error");
  std::vector<Row> rows;
  for (const auto& [key, label] :
       {std::pair("cycle_jump", "of the cycle jump"), std::pair("discretisation", "of the mesh"),
        std::pair("peak_pressure", "of the peak pressure, by the mesh"), std::pair("kinematics", "of small strain"),
        std::pair("energy_norm", "of the stress in linear bodies, energy norm")})
    if (json_part(error, key).is_number()) rows.push_back({label, json_cell(error, key, 2)});
  return html_table({"Estimated relative error", ""}, rows);
}

std::string result_tables(const RunData& run) {
  if (!run.summary.is_object()) return {};
  const std::string right = life_table(run) + probe_table(run) + error_table(run);
  return "<h2>Results</h2>\n<div class=\"columns\">\n<div>" + contact_table(run) + "</div>\n<div>" + right +
         "</div>\n</div>\n" + bond_table(run);
}

std::string ledger_table(const RunData& run) {
  const auto unit = suffixes(run.identity.analysis);
  const bool ring = unit.force == "N";
  const std::string amount = ring ? " volume, mm³" : " area, mm²";
  std::vector<Row> rows;
  for (const auto& [name, contact] : json_part(run.summary, "contacts").items())
    rows.push_back({name, json_cell(contact, "dissipated_energy_" + unit.energy, 6),
                    json_cell(json_part(contact, "secondary"), unit.worn, 6),
                    json_cell(json_part(contact, "primary"), unit.worn, 6),
                    json_cell(contact, "ledger_relative_error", 2)});
  const std::string body = html_table({"Contact", ring ? "friction work, mJ" : "friction work, mJ per mm",
                                       "secondary" + amount, "primary" + amount, "relative error"},
                                      rows);
  if (body.empty()) return {};
  return page_section("Ledger",
                      body +
                          "<p class=\"quiet\">Relative error: |removed − sum of coefficient × the law's work| / "
                          "sum, over both sides; a dash where nothing wears.</p>\n");
}

std::string remesh_section(const Table& remeshes, const RemeshColumns& columns) {
  constexpr std::size_t shown_open = 20, shown_at_most = 200;
  const std::size_t count = remeshes.rows();
  std::vector<Row> rows;
  for (std::size_t i = count - std::min(count, shown_at_most); i < count; ++i)
    rows.push_back(columns.cells(remeshes, i));
  if (rows.empty()) return {};
  return "<div><h2>Remeshes</h2>\n<details" + std::string(rows.size() <= shown_open ? " open=\"open\"" : "") +
         "><summary>Remeshed bodies: " + std::to_string(count) +
         (count > rows.size() ? ", the last " + std::to_string(rows.size()) + " of them" : "") + "</summary>\n" +
         html_table(columns.head, rows, {1, columns.head.size() - 1}) + "<p class=\"quiet\">" + columns.note +
         "</p>\n</details>\n</div>\n";
}

std::string remesh_table(const RunData& run) {
  return remesh_section(
      run.remeshes,
      {{"Cycle", "body", "nodes", "pressure, %", "force, %", "energy, %", "outside, µm", "why"},
       remesh_cells,
       "In percent the jump from the equilibrium before the shape step to that on the new mesh: difference in pressure "
       "over the pressure, both as root mean squares, difference of contact force and of strain energy. Outside: how "
       "far a new contact node lay from the old mesh."});
}

std::string run_tables(const RunData& run) {
  if (!run.summary.is_object()) return {};
  return "<div class=\"columns\">\n" + page_section("The run", count_table(run)) +
         page_section("Where the time went", time_bars(json_part(run.summary, "room_seconds"))) +
         page_section("Skipped, and why", sentence_list(json_part(run.summary, "skipped"))) +
         page_section("Cut-backs, and why", sentence_list(json_part(run.summary, "cutback_reasons"))) + "</div>\n";
}

}  // namespace reye::output
