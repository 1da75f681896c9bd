#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "algebra/decompose.hpp"
#include "algebra/factor.hpp"
#include "scene/read.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"
#include "sim/study/prepare.hpp"

/// A flat punch, pressed or sheared, on the multipliers of one body: the ratio of its edge forces in the two cases. It
/// is one for a half-plane; on a mesh it depends on the elements at the last facet.
namespace {

using namespace reye;
using base::Matrix;
using base::Vector;

struct Compliance {
  Matrix normal, tangential;  ///< of forces at the nodes that carry multipliers, along the flat [mm/(N/mm)]
};

/// Forces on q of a unit multiplier force at `node` along `d`: at the node, or by psi on the Bernstein polynomials of
/// straight facets where their control points carry none.
Vector unit_force(const contact::Setup& setup, const body::LinearBody& body, int node, const base::Vec2& d) {
  const auto& s = setup.secondary;
  Vector f = Vector::Zero(body.dofs());
  const auto put = [&](int k, double share) {
    const auto p = body.position(setup.secondary_nodes[k].contact_node, f);
    for (int t = 0; t < p.count; ++t) f[p.terms[t].column] += share * p.terms[t].direction.dot(d);
  };
  const bool second_order = s.facets.front()[2] >= 0;
  if (!second_order) put(node, 1.0);
  for (int facet : {s.before[node], s.after[node]}) {
    if (!second_order || facet < 0) continue;
    // psi = 3 - 4t of (1-t)^2, t^2, 2t(1-t): 2/3, 0, 1/3; halved, for the node has two facets.
    put(node, 0.5 * 2.0 / 3.0);
    put(s.facets[facet][2], 0.5 * 1.0 / 3.0);
  }
  return f;
}

Compliance compliance(const contact::Setup& setup, const body::LinearBody& body, const std::vector<int>& nodes) {
  Matrix S = body.tangent({});
  for (const auto& support : body.support_columns()) {  // held
    S.row(support.column).setZero();
    S.col(support.column).setZero();
    S(support.column, support.column) = 1.0;
  }
  const algebra::DenseCholesky factor(std::move(S));
  const auto along = [&](const base::Vec2& d) {
    Matrix F(body.dofs(), static_cast<Eigen::Index>(nodes.size()));
    for (std::size_t k = 0; k < nodes.size(); ++k)
      F.col(static_cast<Eigen::Index>(k)) = unit_force(setup, body, nodes[k], d);
    return factor.condense(F);
  };
  return {along({0.0, 1.0}), along({1.0, 0.0})};
}

/// Forces under a flat punch of unit load on the first `count` nodes.
Vector punch(const Matrix& compliance, Eigen::Index first, Eigen::Index count) {
  const Vector f = algebra::solve_symmetric(compliance.block(first, first, count, count), Vector::Ones(count));
  return f / f.sum();
}

/// range: order, elements across the first contact.
void punch(benchmark::State& run) {
  auto scene = scene::read(std::string(REYE_SOURCE_DIR) + "/geo/partial_slip_life/scene.toml");
  const double size = 0.18 / static_cast<double>(run.range(1)), half_width = 0.0645843;
  for (auto& zone : scene.geometry.fine_zones) zone.size_mm = size;
  for (auto& body : scene.geometry.bodies) body.mesh.order = static_cast<int>(run.range(0));
  for (auto& contact : scene.contacts) contact.dual = contact::DualOrder::linear;
  const auto problem = sim::prepare(scene);
  const auto state = sim::initial_state(problem);
  for (auto _ : run) {
    sim::Cache cache;
    const auto kept = sim::system_of(problem, state, cache);
    const auto& system = *kept;
    const auto& setup = system.contacts.front();
    std::vector<int> nodes;
    for (int j = 0; j < setup.secondary_count(); ++j)
      if (!setup.cut[j] && std::abs(setup.secondary.X[j].x()) < half_width) nodes.push_back(j);
    std::ranges::sort(nodes, {}, [&](int j) { return setup.secondary.X[j].x(); });
    const auto c =
        compliance(setup, std::get<body::LinearBody>(system.bodies[setup.secondary_nodes.front().body]), nodes);
    const auto count = static_cast<Eigen::Index>(nodes.size());
    const Vector pressed = punch(c.normal, 0, count), sheared = punch(c.tangential, 0, count);
    run.counters["edge_ratio"] = sheared[0] / pressed[0];
    run.counters["next_ratio"] = sheared[1] / pressed[1];
  }
  run.SetLabel(run.range(0) == 1 ? "quads of first order" : "second order, linear multipliers");
}

BENCHMARK(punch)->ArgsProduct({{1, 2}, {20, 30, 40, 80}})->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
