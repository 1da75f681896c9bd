#pragma once
#include "sim/measure/measure.hpp"
#include "sim/measure/nodal_depth.hpp"
#include "sim/reshape/carry.hpp"
#include "verification/wear_scene.hpp"

namespace reye::verification {

/// A run and what its remeshes changed.
struct Watched {
  Played run;
  std::vector<sim::RemeshRecord> remeshes;
  double depth_step = 0.0;  ///< largest change of the largest depth of a side over a block end with a remesh, relative

  double pressure_jump() const {
    double largest = 0.0;
    for (const auto& r : remeshes) largest = std::max(largest, r.pressure_jump);
    return largest;
  }
};

inline Watched watched(const std::string& text) {
  Watched w;
  Played& p = w.run;
  p.problem = prepared(text);
  p.state = sim::initial_state(p.problem);
  std::size_t seen = 0;
  sim::Observer watch;
  watch.increment = [&](const sim::IncrementRecord& r) { p.records.push_back(r); };
  watch.frame = [&](const sim::Frame& f) { p.frame = f; };
  watch.remesh = [&](const sim::RemeshRecord& r) { w.remeshes.push_back(r); };
  watch.block = [&](const sim::State& s) {
    if (seen == w.remeshes.size()) return;
    seen = w.remeshes.size();
    double secondary = 0.0, primary = 0.0;
    for (std::size_t c = 0; c < p.problem.contacts.size(); ++c) {
      const auto& placed = p.problem.contacts[c];
      const auto& contact = s.solution.contacts[c];
      const auto surface = [&](const contact::BoundaryRef& ref) {
        return sim::surface_of(ref, p.problem.scene.analysis, s.shapes);
      };
      secondary = std::max(secondary, sim::deepest(surface(placed.secondary), contact.removed_secondary));
      primary = std::max(primary, sim::deepest(surface(placed.primary.at(0)), contact.removed_primary));
    }
    const auto& before = p.records.back();
    for (const auto& [now, then] :
         {std::pair{secondary, before.depth_max_secondary_mm}, {primary, before.depth_max_primary_mm}})
      if (then > 0.0) w.depth_step = std::max(w.depth_step, std::abs(now / then - 1.0));
  };
  p.summary = sim::run(p.problem, p.state, watch);
  EXPECT_EQ(p.summary.status, sim::RunStatus::done) << p.summary.reason;
  return w;
}

}  // namespace reye::verification
