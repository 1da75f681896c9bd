#include "sim/reshape/balance.hpp"

#include <algorithm>
#include <cmath>

namespace reye::sim {

Balance balance_of(const Problem& problem, const State& state, const solver::System& system) {
  Balance balance;
  for (const auto& contact : state.solution.contacts) {
    balance.force.emplace_back(Vec2::Zero());
    for (std::size_t j = 0; j < contact.lambda.size(); ++j)
      balance.force.back() += contact.reference[j].carried() * contact.lambda[j];
  }
  for (int b = 0; b < problem.body_count(); ++b) {
    const Vector q = system.part(state.solution.q.high, b);
    const auto* linear = std::get_if<body::LinearBody>(&system.bodies[b]);
    const auto* nonlinear = std::get_if<body::NonlinearBody>(&system.bodies[b]);
    balance.energy.push_back(linear      ? linear->strain_energy(q)
                             : nonlinear ? nonlinear->strain_energy(state.solution.interiors[b], q)
                                         : 0.0);
  }
  return balance;
}

double pressure_jump(const contact::Setup& setup, const contact::ContactState& state, const HeldTraction& carried) {
  double difference = 0.0, all = 0.0;
  for (std::size_t j = 0; j < carried.normal.size(); ++j) {
    const double A = setup.secondary.area[j], before = carried.normal[j] / A,
                 now = state.lambda[j].dot(state.normal[j]);
    difference += A * (now - before) * (now - before);
    all += A * before * before;
  }
  return all > 0.0 ? std::sqrt(difference / all) : 0.0;
}

double peak_jump(const contact::Setup& setup, const contact::ContactState& state, const HeldTraction& carried) {
  std::vector<char> inner(carried.normal.size(), 0);
  double count = 0.0, peak = 0.0, most = 0.0;
  const auto pressure = [&](std::size_t j) { return carried.normal[j] / setup.secondary.area[j]; };
  for (std::size_t j = 0; j < inner.size(); ++j) {
    inner[j] = carried.normal[j] > 0.0;
    count += inner[j];
    peak = std::max(peak, pressure(j));
  }
  for (int turn = 0; turn < std::max(1.0, count / 20.0); ++turn) {
    const auto before = inner;
    for (const auto& facet : setup.secondary.facets)
      for (int node : facet)
        for (int beside : facet)
          if (node >= 0 && beside >= 0 && !before[beside]) inner[node] = 0;
  }
  for (std::size_t j = 0; j < inner.size(); ++j)
    if (inner[j]) most = std::max(most, std::abs(state.lambda[j].dot(state.normal[j]) - pressure(j)));
  return peak > 0.0 ? most / peak : 0.0;
}

}  // namespace reye::sim
