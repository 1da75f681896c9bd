#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "sim/study/run.hpp"

/// Runs, and what is read off them.
namespace reye::test {

struct Played {
  sim::State state;
  sim::Summary summary;
  std::vector<sim::IncrementRecord> rows{};
  std::vector<std::string> log{};
};

inline Played played(const sim::Problem& problem, const sim::Observer& observer = {}) {
  Played p{sim::initial_state(problem), {}};
  p.summary = sim::run(problem, p.state, observer);
  return p;
}

/// With rows and log; the run must be done.
inline Played recorded(const sim::Problem& problem) {
  std::vector<sim::IncrementRecord> rows;
  std::vector<std::string> log;
  sim::Observer observer;
  observer.increment = [&](const sim::IncrementRecord& row) { rows.push_back(row); };
  observer.log = [&](const std::string& line) { log.push_back(line); };
  Played p = played(problem, observer);
  EXPECT_EQ(p.summary.status, sim::RunStatus::done) << p.summary.reason;
  p.rows = std::move(rows);
  p.log = std::move(log);
  return p;
}

/// Of warnings: kind, and what it is about.
using Kinds = std::vector<std::string>;

inline Kinds kinds_of(const std::vector<sim::Warning>& warnings) {
  Kinds kinds;
  for (const auto& w : warnings) kinds.push_back(w.kind + ", " + w.about);
  return kinds;
}

inline double sum(const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); }

/// Volumes that the secondary side of the first contact has lost.
inline std::vector<double> removed(const Played& r) { return r.state.solution.contacts[0].removed_secondary; }

/// int |w - w_0| over the worn area.
inline double apart(const std::vector<double>& a, const std::vector<double>& b) {
  double d = 0.0;
  for (std::size_t j = 0; j < a.size(); ++j) d += std::abs(a[j] - b[j]);
  return d / sum(b);
}

}  // namespace reye::test
