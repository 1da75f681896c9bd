#include "output/solid/solid_summary.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "output/folder/text.hpp"
#include "solid_sample.hpp"

using reye::output::solid_summary_json;
using SolidJson = nlohmann::ordered_json;

// Every value of the summary stands under its key, and what is unknown or not finite is null.
TEST(SolidSummary, UnknownIsNull) {
  const auto json = SolidJson::parse(solid_summary_json(solid_sample::summary()));
  EXPECT_EQ(json["title"].get<std::string>(), "Block <on> block");
  EXPECT_EQ(json["status"].get<std::string>(), "done");
  EXPECT_TRUE(json["reason"].is_null());
  EXPECT_EQ(json["version"].get<std::string>(), reye::output::version);
  const auto& pad = json["contacts"]["pad"];
  EXPECT_EQ(pad["peak_pressure_MPa"].get<double>(), 20.0);
  EXPECT_EQ(pad["contact_area_mm2"].get<double>(), 1.5);
  EXPECT_EQ(pad["normal_force_N"].get<double>(), 100.0);
  for (const char* key : {"equivalent_radius_mm", "stick_area_mm2", "energy_last_cycle_mJ"})
    EXPECT_TRUE(pad.contains(key) && pad[key].is_null()) << key;
  EXPECT_EQ(pad["half_widths_mm"][0].get<double>(), 0.75);
  EXPECT_TRUE(pad["half_widths_mm"][1].is_null());
  EXPECT_EQ(json["probes"]["tip"]["u_y_mm"].get<double>(), 0.2);
  EXPECT_TRUE(json["probes"]["tip"]["u_z_mm"].is_null());
  EXPECT_EQ(json["balance"].get<double>(), 1e-14);
  EXPECT_EQ(json["size"]["dofs"].get<double>(), 117);
  EXPECT_EQ(json["size"]["retained_nodes"].get<double>(), 12);
  EXPECT_EQ(json["phase_seconds"]["factor"].get<double>(), 3.0);
  EXPECT_EQ(json["counts"]["increments"].get<double>(), 5);
  EXPECT_EQ(json["warnings"][0]["about"].get<std::string>(), "contact pad");
}

// A run that fails says so and why, with numbers that are not finite as null and bytes that are no text replaced.
TEST(SolidSummary, FailedRun) {
  auto summary = solid_sample::summary();
  summary.status = reye::sim::RunStatus::failed;
  summary.reason = "no equilibrium \xff";
  summary.balance = std::numeric_limits<double>::infinity();
  summary.cutback_reasons = {"rub at 0.5"};
  const auto json = SolidJson::parse(solid_summary_json(summary));
  EXPECT_EQ(json["status"].get<std::string>(), "failed");
  EXPECT_EQ(json["reason"].get<std::string>(), "no equilibrium \xef\xbf\xbd");
  EXPECT_TRUE(json["balance"].is_null());
  EXPECT_EQ(json["cutback_reasons"][0].get<std::string>(), "rub at 0.5");
}
