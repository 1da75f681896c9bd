#include "output/solid/solid_summary.hpp"

#include "output/folder/summary.hpp"
#include "output/folder/summary_parts.hpp"
#include "output/folder/text.hpp"

namespace reye::output {

namespace {

Json skin_side_json(const sim::SkinSideSummary& side) {
  return {{"max_depth_mm", value_json(side.max_depth_mm)}, {"worn_volume_mm3", value_json(side.worn_volume_mm3)}};
}

Json skin_contact_json(const sim::SkinContactSummary& c) {
  Json widths = Json::array();
  for (const double w : c.half_widths_mm) widths.push_back(w > 0.0 ? value_json(w) : Json(nullptr));
  return {{"peak_pressure_MPa", value_json(c.peak_pressure_MPa)},
          {"contact_area_mm2", value_json(c.area_mm2)},
          {"equivalent_radius_mm", value_json(c.equivalent_radius_mm)},
          {"stick_area_mm2", value_json(c.stick_area_mm2)},
          {"half_widths_mm", widths},
          {"normal_force_N", value_json(c.normal_force_N)},
          {"tangential_force_N", value_json(c.tangential_force_N)},
          {"dissipated_energy_mJ", value_json(c.dissipated_energy_mJ)},
          {"energy_last_cycle_mJ", value_json(c.energy_last_cycle_mJ)},
          {"secondary", skin_side_json(c.secondary)},
          {"primary", skin_side_json(c.primary)},
          {"ledger_relative_error", value_json(c.ledger_relative_error)}};
}

Json solid_contacts_json(const sim::SolidSummary& s) {
  Json all = Json::object();
  for (const auto& c : s.contacts) all[c.name] = skin_contact_json(c);
  return all;
}

Json solid_probes_json(const sim::SolidSummary& s) {
  Json all = Json::object();
  for (const auto& [name, u] : s.probes)
    all[name] = {{"u_x_mm", value_json(u.x())}, {"u_y_mm", value_json(u.y())}, {"u_z_mm", value_json(u.z())}};
  return all;
}

Json solid_size_json(const sim::SolidSize& size) {
  return {{"nodes", size.nodes},
          {"dofs", size.dofs},
          {"cells", size.cells},
          {"retained_nodes", size.retained},
          {"estimated_memory_MB", value_json(size.memory_MB)},
          {"estimated_seconds", value_json(size.seconds)}};
}

}  // namespace

std::string solid_summary_json(const sim::SolidSummary& s) {
  Json json{{"title", s.title},
            {"status", status_name(s.status)},
            {"reason", text_json(s.reason)},
            {"cycles", value_json(s.cycles)},
            {"contacts", solid_contacts_json(s)},
            {"probes", solid_probes_json(s)},
            {"life_cycles", lives_json(s.life_cycles)},
            {"life_band", bands_json(s.life_band)},
            {"estimated_error",
             {{"cycle_jump", value_json(s.error_cycle_jump)},
              {"discretisation", value_json(s.error_discretisation)},
              {"peak_pressure", value_json(s.error_peak_pressure)},
              {"life_cycles", life_errors_json(s.life_error)}}},
            {"balance", value_json(s.balance)},
            {"counts", counts_json(s.counts)},
            {"size", solid_size_json(s.size)},
            {"wall_s", value_json(s.wall_s)},
            {"cpu_s", value_json(s.cpu_s)},
            {"peak_rss_MB", value_json(s.peak_rss_MB)},
            {"version", version},
            {"scene_sha256", s.scene_sha256},
            {"phase_seconds", Json::object()},
            {"cutback_reasons", s.cutback_reasons},
            {"warnings", warnings_json(s.warnings)}};
  for (const auto& [phase, seconds] : s.phase_seconds) json["phase_seconds"][phase] = value_json(seconds);
  // A title that is not valid UTF-8 must not prevent the results.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace reye::output
