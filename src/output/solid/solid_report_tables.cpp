#include "output/solid/solid_report_tables.hpp"

#include <algorithm>
#include <cmath>

#include "output/folder/text.hpp"
#include "output/report/html.hpp"
#include "output/report/json_cells.hpp"
#include "output/report/report_tables.hpp"

namespace reye::output {

namespace {

using SummaryJson = nlohmann::ordered_json;

std::string half_width_cell(const SummaryJson& contact, std::size_t k) {
  const auto& widths = json_part(contact, "half_widths_mm");
  return widths.is_array() && widths.size() > k && widths[k].is_number() ? rounded(widths[k].get<double>()) : "–";
}

/// Adds a row with a cell for each contact.
template <class Cell>
void add_row(const SummaryJson& contacts, const std::string& label, const char* unit, Cell cell,
             std::vector<Row>& rows) {
  Row row{label};
  for (const auto& contact : contacts) row.push_back(cell(contact));
  row.push_back(unit);
  rows.push_back(std::move(row));
}

/// Rows of the sides that wear, and of the ledger.
void add_sides(const SummaryJson& contacts, std::vector<Row>& rows) {
  bool any = false;
  for (const std::string side : {"secondary", "primary"}) {
    const bool worn = std::any_of(contacts.begin(), contacts.end(), [&](const SummaryJson& contact) {
      const auto& depth = json_part(json_part(contact, side), "max_depth_mm");
      return depth.is_number() && depth.get<double>() > 0.0;
    });
    any = any || worn;
    if (!worn) continue;
    const auto cell = [&](const char* key, double factor) {
      return [&side, key, factor](const SummaryJson& contact) {
        return json_cell(json_part(contact, side), key, 5, factor);
      };
    };
    add_row(contacts, "Largest worn depth, " + side + " side", "µm", cell("max_depth_mm", 1e3), rows);
    add_row(contacts, "Worn volume, " + side + " side", "mm³", cell("worn_volume_mm3", 1.0), rows);
  }
  if (any)
    add_row(
        contacts, "Ledger: volume lost against the law", "1",
        [](const SummaryJson& contact) { return json_cell(contact, "ledger_relative_error", 2); }, rows);
}

std::string skin_contact_table(const SolidRunData& data) {
  struct Wanted {
    const char *label, *key, *unit;
  };
  static constexpr Wanted wanted[] = {{"Peak pressure", "peak_pressure_MPa", "MPa"},
                                      {"Area in contact", "contact_area_mm2", "mm²"},
                                      {"Radius of the circle of this area", "equivalent_radius_mm", "mm"},
                                      {"Area that sticks", "stick_area_mm2", "mm²"},
                                      {"Normal force", "normal_force_N", "N"},
                                      {"Tangential force", "tangential_force_N", "N"},
                                      {"Dissipated energy", "dissipated_energy_mJ", "mJ"},
                                      {"Dissipated in the last whole cycle", "energy_last_cycle_mJ", "mJ"}};
  const auto& contacts = json_part(data.run.summary, "contacts");
  Row head{"At the end of the run"};
  for (const auto& item : contacts.items()) head.push_back(item.key());
  head.push_back("unit");
  std::vector<Row> rows;
  if (contacts.empty()) return {};
  for (const auto& w : wanted) {
    add_row(
        contacts, w.label, w.unit, [&](const SummaryJson& contact) { return json_cell(contact, w.key); }, rows);
    if (std::string(w.key) == "equivalent_radius_mm")
      for (const std::size_t k : {0u, 1u})
        add_row(
            contacts, k == 0 ? "Half width, along its length" : "Half width, across", "mm",
            [&](const SummaryJson& contact) { return half_width_cell(contact, k); }, rows);
  }
  add_sides(contacts, rows);
  return html_table(head, rows);
}

std::string solid_probe_table(const SolidRunData& data) {
  std::vector<Row> rows;
  for (const auto& [name, u] : json_part(data.run.summary, "probes").items())
    rows.push_back({name, json_cell(u, "u_x_mm"), json_cell(u, "u_y_mm"), json_cell(u, "u_z_mm")});
  return html_table({"Probe", "u_x, mm", "u_y, mm", "u_z, mm"}, rows);
}

std::string balance_table(const SolidRunData& data) {
  if (!json_part(data.run.summary, "balance").is_number()) return {};
  return html_table({"Check", ""}, {{"Balance: largest sum of forces on a body over the largest force",
                                     json_cell(data.run.summary, "balance", 2)}});
}

/// A number of a resultant; 0 where it is nothing beside the others.
std::string resultant_cell(double value, double largest) {
  return std::abs(value) < 1e-9 * largest ? "0" : rounded(value, 5);
}

/// Force and moment of each support at the end of the last increment.
std::string support_table(const SolidRunData& data) {
  const Table& history = data.run.history;
  if (history.rows() == 0) return {};
  const auto last = [&](const std::string& column) { return history.column(column).back(); };
  std::vector<std::vector<double>> values;
  double force = 0.0, moment = 0.0;
  for (const auto& name : data.inputs.supports) {
    values.emplace_back();
    for (const char way : {'x', 'y', 'z'}) {
      values.back().push_back(last(name + "_force_" + way + "_N"));
      force = std::max(force, std::abs(values.back().back()));
    }
    for (const char way : {'x', 'y', 'z'}) {
      values.back().push_back(last(name + "_moment_" + way + "_N_mm"));
      moment = std::max(moment, std::abs(values.back().back()));
    }
  }
  std::vector<Row> rows;
  for (std::size_t s = 0; s < values.size(); ++s) {
    rows.push_back({data.inputs.supports[s]});
    for (std::size_t k = 0; k < 6; ++k) rows.back().push_back(resultant_cell(values[s][k], k < 3 ? force : moment));
  }
  return html_table(
      {"Support, on its body, at the end", "F_x, N", "F_y, N", "F_z, N", "M_x, N mm", "M_y, N mm", "M_z, N mm"}, rows);
}

std::string solid_count_table(const SolidRunData& data) {
  const auto& summary = data.run.summary;
  std::vector<Row> rows{{"Cycles", json_cell(summary, "cycles", 8)}};
  for (const auto& [key, label] :
       {std::pair("increments", "Increments"), std::pair("newton_iterations", "Newton iterations"),
        std::pair("equilibrium_iterations", "Newton iterations on worn and fresh shapes"),
        std::pair("factorisations", "Factorisations"), std::pair("cutbacks", "Cut-backs")})
    rows.push_back({label, json_cell(json_part(summary, "counts"), key, 12)});
  rows.push_back({"Wall time, s", json_cell(summary, "wall_s", 4)});
  rows.push_back({"Processor time, s", json_cell(summary, "cpu_s", 4)});
  rows.push_back({"Largest memory, MB", json_cell(summary, "peak_rss_MB", 4)});
  return html_table({"Counts", ""}, rows);
}

std::string size_table(const SolidRunData& data) {
  const auto& size = json_part(data.run.summary, "size");
  std::vector<Row> rows;
  for (const auto& [key, label] :
       {std::pair("nodes", "Nodes"), std::pair("cells", "Elements"), std::pair("dofs", "Degrees of freedom"),
        std::pair("retained_nodes", "Nodes that contact may touch"),
        std::pair("estimated_memory_MB", "Memory, estimated, MB"),
        std::pair("estimated_seconds", "Time, estimated, s")})
    if (json_part(size, key).is_number()) rows.push_back({label, json_cell(size, key, 4)});
  return html_table({"All bodies", ""}, rows);
}

}  // namespace

std::string solid_result_tables(const SolidRunData& data) {
  const std::string supports = support_table(data);
  const std::string right =
      life_table(data.run) + solid_probe_table(data) + error_table(data.run) + balance_table(data);
  if (!data.run.summary.is_object()) return page_section("Supports", supports);
  return "<h2>Results</h2>\n<div class=\"columns\">\n<div>" + skin_contact_table(data) + "</div>\n<div>" + right +
         "</div>\n</div>\n" + supports;
}

std::string solid_input_tables(const SolidRunData& data) {
  std::string html;
  for (const auto& table : data.inputs.tables) {
    std::set<std::size_t> texts;
    for (std::size_t i = 0; i < table.head.size(); ++i) texts.insert(i);
    html += html_table(table.head, table.rows, texts);
  }
  return html.empty() ? html : "<h2>What went in</h2>\n" + html;
}

std::string solid_remesh_table(const SolidRunData& data) {
  const auto cells = [](const Table& t, std::size_t i) {
    const auto value = [&](const char* column) { return t.column(column).at(i); };
    return Row{rounded(value("cycle"), 8),
               t.word(value("body")),
               rounded(value("nodes_before"), 9) + " → " + rounded(value("nodes_after"), 9),
               rounded(value("quality_before"), 2) + " → " + rounded(value("quality_after"), 2),
               rounded(100.0 * value("pressure_change"), 2),
               rounded(1e3 * value("fit_mm"), 3),
               t.word(value("reason"))};
  };
  return remesh_section(
      data.run.remeshes,
      {{"Cycle", "body", "nodes", "poorest element", "pressure, %", "fitted, µm", "why"},
       cells,
       "Pressure: difference of the pressures on the fresh mesh from those carried onto it, root of the mean square "
       "over the mean. Fitted: by how much gaps were opened or closed to keep them. Elements: 1 is regular."});
}

std::string solid_run_tables(const SolidRunData& data) {
  if (!data.run.summary.is_object()) return {};
  return "<div class=\"columns\">\n" + page_section("The run", solid_count_table(data)) +
         page_section("Its size", size_table(data)) +
         page_section("Where the time went", time_bars(json_part(data.run.summary, "phase_seconds"))) +
         page_section("Cut-backs, and why", sentence_list(json_part(data.run.summary, "cutback_reasons"))) + "</div>\n";
}

}  // namespace reye::output
