#include <benchmark/benchmark.h>

#include <cmath>
#include <numeric>

#include "algebra/factor.hpp"
#include "mortar/integrate.hpp"
#include "output/folder/vtk_frames.hpp"

/// The inner kernels one by one: dual numbers, mortar integrals and their derivatives, the dense solve of an iteration,
/// a frame on its way to disk. Gauss point transfer stands in gauss_transfer.cpp.
namespace {

using namespace reye;
using base::Vec2;

/// A product of dual numbers against one of doubles.
template <class T>
void products(benchmark::State& run) {
  std::vector<T> a(256), b(256);
  for (std::size_t i = 0; i < a.size(); ++i) {
    a[i] = T(1.0 + 1e-3 * static_cast<double>(i));
    b[i] = T(1.0 - 1e-3 * static_cast<double>(i));
  }
  for (auto _ : run)
    for (std::size_t i = 0; i < a.size(); ++i) benchmark::DoNotOptimize(a[i] * b[i]);
  run.SetItemsProcessed(run.iterations() * static_cast<long>(a.size()));
}
BENCHMARK(products<double>)->Name("product/double");
BENCHMARK(products<base::Dual<6>>)->Name("product/dual_6");
BENCHMARK(products<base::Dual<16>>)->Name("product/dual_16");

/// A chain of facets along x from 0 to 1, running with the body below (turned: above) it.
mortar::Surface chain(int facets, bool turned) {
  base::Points X;
  for (int i = 0; i <= facets; ++i) {
    const double s = static_cast<double>(i) / facets, x = turned ? s : 1.0 - s;
    X.emplace_back(x, 0.01 * std::sin(6.0 * x));
  }
  mesh::Chain nodes(X.size());
  std::iota(nodes.begin(), nodes.end(), 0);
  std::vector<int> places;
  return mortar::make_surface(X, {nodes}, base::Analysis::plane_strain, places);
}

/// 200 facets against 217, in contact all along.
struct Pair {
  mortar::Surface secondary = chain(200, false), primary = chain(217, true);
  mortar::Placement placement;

  Pair() {
    placement.secondary = &secondary;
    placement.primary = &primary;
    placement.xs = placement.xs_before = secondary.X;
    placement.xm = placement.xm_before = primary.X;
    placement.cut.assign(secondary.X.size(), 0);
    placement.search = 0.02;
  }
};

void mortar_values(benchmark::State& run) {
  const Pair pair;
  mortar::Integrator integrator;
  long facets = 0;
  for (auto _ : run) facets += static_cast<long>(integrator.values(pair.placement).size());
  run.SetItemsProcessed(facets);
}
BENCHMARK(mortar_values)->Name("mortar/values");

void mortar_derivatives(benchmark::State& run) {
  const Pair pair;
  mortar::Integrator integrator;
  auto& records = integrator.values(pair.placement);
  for (auto _ : run)
    for (auto& record : records) integrator.differentiate(pair.placement, record);
  run.SetItemsProcessed(run.iterations() * static_cast<long>(records.size()));
}
BENCHMARK(mortar_derivatives)->Name("mortar/derivatives");

/// LU of a well conditioned matrix of some rows, copied afresh each time.
void dense_lu(benchmark::State& run) {
  const auto n = static_cast<Eigen::Index>(run.range(0));
  base::Matrix A = base::Matrix::Identity(n, n) * 4.0;
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      A(i, j) += std::cos(static_cast<double>(3 * i + 7 * j)) / static_cast<double>(1 + std::abs(i - j));
  algebra::DenseFactor factor;
  for (auto _ : run) {
    base::Matrix copy = A;
    factor.factor(copy);
  }
}
BENCHMARK(dense_lu)->Name("dense_lu")->Arg(150)->Arg(300)->Arg(600)->Unit(benchmark::kMillisecond);

/// A body of n x n quadrilaterals with displacement and stress as ParaView reads it.
void frame(benchmark::State& run) {
  const int n = static_cast<int>(run.range(0));
  auto mesh = std::make_shared<mesh::Mesh>();
  mesh->kind = mesh::CellKind::quad4;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) mesh->X.emplace_back(i, j);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = i + (n + 1) * j;
      mesh->cells.push_back(mesh::cell_of({a, a + 1, a + n + 2, a + n + 1}));
    }
  sim::BodyFrame body;
  body.name = "square";
  body.mesh = mesh;
  for (const auto& X : mesh->X) body.u.emplace_back(std::sin(X.x()), std::cos(X.y()));
  body.stress_MPa.assign(mesh->X.size(), {});
  body.wear_depth_mm.assign(mesh->X.size(), 0.0);
  sim::Frame whole;
  whole.bodies.push_back(std::move(body));
  for (auto _ : run) benchmark::DoNotOptimize(output::bodies_vtu(whole));
}
BENCHMARK(frame)->Name("frame")->Arg(50)->Arg(200)->Unit(benchmark::kMillisecond);

}  // namespace
