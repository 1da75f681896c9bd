#include "output/folder/summary.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "sample_run.hpp"

using Json = nlohmann::ordered_json;
using Keys = std::vector<std::string>;

namespace {

Json read(const reye::sim::Summary& summary) { return Json::parse(reye::output::summary_json(summary)); }

Keys keys(const Json& object) {
  Keys all;
  for (const auto& item : object.items()) all.push_back(item.key());
  return all;
}

}  // namespace

// The keys of a plane problem are those of the contract, in its order; extra ones come after.
TEST(Summary, PlaneKeysAreTheContract) {
  const Json json = read(sample::summary());
  EXPECT_EQ(keys(json), (Keys{"title",       "status",          "reason",    "cycles", "contacts",     "probes",
                              "life_cycles", "estimated_error", "counts",    "wall_s", "cpu_s",        "peak_rss_MB",
                              "version",     "scene_sha256",    "life_band", "bonds",  "room_seconds", "skipped",
                              "histories",   "cutback_reasons", "warnings"}));
  const Json& pad = json["contacts"]["pad"];
  EXPECT_EQ(keys(pad), (Keys{"peak_pressure_MPa", "contact_half_width_mm", "stick_half_width_mm",
                             "normal_force_N_per_mm", "tangential_force_N_per_mm", "dissipated_energy_mJ_per_mm",
                             "secondary", "primary", "ledger_relative_error"}));
  for (const char* side : {"secondary", "primary"})
    EXPECT_EQ(keys(pad[side]), (Keys{"max_depth_mm", "worn_area_mm2", "scar_width_mm"}));
  EXPECT_EQ(keys(json["estimated_error"]),
            (Keys{"cycle_jump", "discretisation", "peak_pressure", "kinematics", "life_cycles", "energy_norm"}));
  EXPECT_EQ(keys(json["counts"]), (Keys{"blocks", "increments", "newton_iterations", "equilibrium_iterations",
                                        "factorisations", "remeshes", "cutbacks", "cycles_solved", "refused_blocks"}));
  EXPECT_EQ(keys(json["probes"]["edge"]), (Keys{"u_x_mm", "u_y_mm"}));
}

// For a bond the end and the largest of the run are reported, each peak with its place, which is null where nothing
// pulls.
TEST(Summary, BondsTellWhereTheyPull) {
  auto summary = sample::summary();
  EXPECT_EQ(read(summary)["bonds"].dump(), "{}");
  reye::sim::BondTraction now, most;
  now.mean_tension_MPa = -4.0;
  most.tension = {12.5, {1.0, 2.0}, 30.0, true};
  summary.bonds = {{"glue", now, most}};
  const Json glue = read(summary)["bonds"]["glue"];
  EXPECT_EQ(keys(glue), (Keys{"end", "most"}));
  EXPECT_EQ(keys(glue["end"]), (Keys{"peak_tension_MPa", "peak_tension_x_mm", "peak_tension_y_mm", "peak_tension_cycle",
                                     "peak_tension_at_end", "peak_shear_MPa", "peak_shear_x_mm", "peak_shear_y_mm",
                                     "peak_shear_cycle", "peak_shear_at_end", "mean_tension_MPa", "mean_shear_MPa"}));
  EXPECT_EQ(glue["end"]["mean_tension_MPa"].get<double>(), -4.0);
  EXPECT_EQ(glue["end"]["peak_tension_MPa"].get<double>(), 0.0);
  EXPECT_TRUE(glue["end"]["peak_tension_x_mm"].is_null());
  EXPECT_EQ(glue["most"]["peak_tension_MPa"].get<double>(), 12.5);
  EXPECT_EQ(glue["most"]["peak_tension_y_mm"].get<double>(), 2.0);
  EXPECT_EQ(glue["most"]["peak_tension_cycle"].get<double>(), 30.0);
  EXPECT_EQ(glue["most"]["peak_tension_at_end"].get<bool>(), true);
}

// Axisymmetric scenes give forces, energies and volumes of the whole circumference.
TEST(Summary, AxisymmetricKeysAreTheContract) {
  const Json json = read(sample::summary(sample::Analysis::axisymmetric));
  const Json& pad = json["contacts"]["pad"];
  EXPECT_EQ(keys(pad),
            (Keys{"peak_pressure_MPa", "contact_half_width_mm", "stick_half_width_mm", "normal_force_N",
                  "tangential_force_N", "dissipated_energy_mJ", "secondary", "primary", "ledger_relative_error"}));
  EXPECT_EQ(keys(pad["primary"]), (Keys{"max_depth_mm", "worn_volume_mm3", "scar_width_mm"}));
}

// What is unknown is null: an empty optional, a limit not reached, a run without limits, no reason.
TEST(Summary, UnknownIsNull) {
  auto summary = sample::summary();
  Json json = read(summary);
  EXPECT_TRUE(json["contacts"]["pad"]["stick_half_width_mm"].is_null());
  EXPECT_EQ(json["life_cycles"]["deep"].get<double>(), 17000.0);
  EXPECT_TRUE(json["life_cycles"]["deeper"].is_null());
  EXPECT_TRUE(json["estimated_error"]["cycle_jump"].is_null());
  EXPECT_TRUE(json["estimated_error"]["life_cycles"].is_null());
  EXPECT_TRUE(json["reason"].is_null());
  summary.life_error["deep"] = 120.0;
  EXPECT_EQ(read(summary)["estimated_error"]["life_cycles"]["deep"].get<double>(), 120.0);
  summary.life_cycles.clear();
  EXPECT_TRUE(read(summary)["life_cycles"].is_null());
}

// Warnings are objects with what scripts ask for; a run without any has an empty list.
TEST(Summary, Warnings) {
  auto summary = sample::summary();
  EXPECT_EQ(read(summary)["warnings"].dump(), "[]");
  summary.warnings = {{"resolution", "contact pad", "2 elements touch.", 4.0}, {"scene", "", "no step plays it.", 0.0}};
  const Json all = read(summary)["warnings"];
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].dump(),
            (Json{{"kind", "resolution"}, {"about", "contact pad"}, {"text", "2 elements touch."}}).dump());
  EXPECT_TRUE(all[1]["about"].is_null());
}

// The band of a life stands by its limit: null without one, null cycles when the limit is not reached.
TEST(Summary, LifeBand) {
  auto summary = sample::summary();
  EXPECT_TRUE(read(summary)["life_band"].is_null());
  summary.life_band = {{"deep", {8500.0, 34000.0}}, {"deeper", {}}};
  const Json json = read(summary);
  EXPECT_EQ(json["life_band"]["deep"].dump(), (Json{{"shortest_cycles", 8500.0}, {"longest_cycles", 34000.0}}).dump());
  EXPECT_EQ(json["life_band"]["deeper"].dump(),
            (Json{{"shortest_cycles", nullptr}, {"longest_cycles", nullptr}}).dump());
}

// What is not finite is written as null, never as NaN or inf.
TEST(Summary, NotFiniteIsNull) {
  auto summary = sample::summary();
  summary.contacts[0].secondary.max_depth_mm = std::numeric_limits<double>::quiet_NaN();
  summary.contacts[0].peak_pressure_MPa = std::numeric_limits<double>::infinity();
  const Json json = read(summary);
  EXPECT_TRUE(json["contacts"]["pad"]["secondary"]["max_depth_mm"].is_null());
  EXPECT_TRUE(json["contacts"]["pad"]["peak_pressure_MPa"].is_null());
}

// Values and status read back exactly.
TEST(Summary, ValuesReadBack) {
  auto summary = sample::summary();
  summary.status = reye::sim::RunStatus::interrupted;
  summary.reason = "stopped by the user";
  summary.contacts[0].normal_force = 0.1 + 0.2;
  const Json json = read(summary);
  EXPECT_EQ(json["status"].get<std::string>(), "interrupted");
  EXPECT_EQ(json["reason"].get<std::string>(), "stopped by the user");
  EXPECT_EQ(json["contacts"]["pad"]["normal_force_N_per_mm"].get<double>(), 0.1 + 0.2);
  EXPECT_EQ(json["counts"]["increments"].get<double>(), 7250);
}
