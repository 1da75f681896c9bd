#include "output/folder/summary.hpp"

#include <cmath>

#include "output/folder/summary_parts.hpp"
#include "output/folder/tables.hpp"
#include "output/folder/text.hpp"

namespace reye::output {

Json value_json(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }
Json value_json(const std::optional<double>& x) { return x ? value_json(*x) : Json(nullptr); }
Json text_json(const std::string& s) { return s.empty() ? Json(nullptr) : Json(s); }

Json counts_json(const sim::Counts& c) {
  return {{"blocks", c.blocks},
          {"increments", c.increments},
          {"newton_iterations", c.newton_iterations},
          {"equilibrium_iterations", c.equilibrium_iterations},
          {"factorisations", c.factorisations},
          {"remeshes", c.remeshes},
          {"cutbacks", c.cutbacks},
          {"cycles_solved", c.cycles_solved},
          {"refused_blocks", c.refused_blocks}};
}

Json warnings_json(const std::vector<sim::Warning>& warnings) {
  Json all = Json::array();
  for (const auto& w : warnings) all.push_back({{"kind", w.kind}, {"about", text_json(w.about)}, {"text", w.text}});
  return all;
}

Json lives_json(const std::map<std::string, std::optional<double>>& lives) {
  Json all;
  for (const auto& [name, cycles] : lives) all[name] = value_json(cycles);
  return all;
}

Json life_errors_json(const std::map<std::string, double>& errors) {
  Json all;
  for (const auto& [name, cycles] : errors) all[name] = value_json(cycles);
  return all;
}

Json bands_json(const std::map<std::string, sim::LifeBand>& bands) {
  Json all;
  for (const auto& [name, band] : bands)
    all[name] = {{"shortest_cycles", value_json(band.shortest_cycles)},
                 {"longest_cycles", value_json(band.longest_cycles)}};
  return all;
}

namespace {

Json side(const sim::SideSummary& s, const Suffixes& unit) {
  return {{"max_depth_mm", value_json(s.max_depth_mm)},
          {unit.worn, value_json(s.worn_area)},
          {"scar_width_mm", value_json(s.scar_width_mm)}};
}

Json contact(const sim::ContactSummary& c, const Suffixes& unit) {
  return {{"peak_pressure_MPa", value_json(c.peak_pressure_MPa)},
          {"contact_half_width_mm", value_json(c.contact_half_width_mm)},
          {"stick_half_width_mm", value_json(c.stick_half_width_mm)},
          {"normal_force_" + unit.force, value_json(c.normal_force)},
          {"tangential_force_" + unit.force, value_json(c.tangential_force)},
          {"dissipated_energy_" + unit.energy, value_json(c.dissipated_energy)},
          {"secondary", side(c.secondary, unit)},
          {"primary", side(c.primary, unit)},
          {"ledger_relative_error", value_json(c.ledger_relative_error)}};
}

/// A place is null where there is no such traction.
void add_peak(Json& json, const std::string& name, const sim::TractionPeak& peak) {
  const auto place = [&](double x) { return peak.MPa > 0.0 ? value_json(x) : Json(nullptr); };
  json[name + "_MPa"] = value_json(peak.MPa);
  json[name + "_x_mm"] = place(peak.at_mm.x());
  json[name + "_y_mm"] = place(peak.at_mm.y());
  json[name + "_cycle"] = place(peak.cycle);
  json[name + "_at_end"] = peak.at_end;
}

Json bond(const sim::BondTraction& t) {
  Json json = Json::object();
  add_peak(json, "peak_tension", t.tension);
  add_peak(json, "peak_shear", t.shear);
  json["mean_tension_MPa"] = value_json(t.mean_tension_MPa);
  json["mean_shear_MPa"] = value_json(t.mean_shear_MPa);
  return json;
}

Json bonds(const sim::Summary& summary) {
  Json all = Json::object();
  for (const auto& b : summary.bonds) all[b.name] = {{"end", bond(b.end)}, {"most", bond(b.most)}};
  return all;
}

Json contacts(const sim::Summary& summary) {
  const auto unit = suffixes(summary.analysis);
  Json all = Json::object();
  for (const auto& c : summary.contacts) all[c.name] = contact(c, unit);
  return all;
}

Json probes(const sim::Summary& summary) {
  Json all = Json::object();
  for (const auto& [name, u] : summary.probes)
    all[name] = {{"u_x_mm", value_json(u.x())}, {"u_y_mm", value_json(u.y())}};
  return all;
}

Json histories(const sim::Summary& s) {
  Json all = Json::object();
  for (const auto& [name, h] : s.histories)
    all[name] = {{"points", h.points},
                 {"points_kept", h.kept},
                 {"tolerance", value_json(h.tolerance)},
                 {"way_lost", value_json(h.way_lost)}};
  return all;
}

}  // namespace

const char* status_name(sim::RunStatus status) {
  switch (status) {
    case sim::RunStatus::done:
      return "done";
    case sim::RunStatus::failed:
      return "failed";
    case sim::RunStatus::interrupted:
      break;
  }
  return "interrupted";
}

std::string summary_json(const sim::Summary& s) {
  Json json{{"title", s.title},
            {"status", status_name(s.status)},
            {"reason", text_json(s.reason)},
            {"cycles", value_json(s.cycles)},
            {"contacts", contacts(s)},
            {"probes", probes(s)},
            {"life_cycles", lives_json(s.life_cycles)},
            {"estimated_error",
             {{"cycle_jump", value_json(s.error_cycle_jump)},
              {"discretisation", value_json(s.error_discretisation)},
              {"peak_pressure", value_json(s.error_peak_pressure)},
              {"kinematics", value_json(s.error_small_strain)},
              {"life_cycles", life_errors_json(s.life_error)},
              {"energy_norm", value_json(s.error_energy_norm)}}},
            {"counts", counts_json(s.counts)},
            {"wall_s", value_json(s.wall_s)},
            {"cpu_s", value_json(s.cpu_s)},
            {"peak_rss_MB", value_json(s.peak_rss_MB)},
            {"version", version},
            {"scene_sha256", s.scene_sha256},
            {"life_band", bands_json(s.life_band)},
            {"bonds", bonds(s)},
            {"room_seconds", Json::object()},
            {"skipped", s.skipped},
            {"histories", histories(s)},
            {"cutback_reasons", s.cutback_reasons},
            {"warnings", warnings_json(s.warnings)}};
  for (const auto& [room, seconds] : s.room_seconds) json["room_seconds"][room] = value_json(seconds);
  // A title that is not valid UTF-8 must not prevent the results.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace reye::output
