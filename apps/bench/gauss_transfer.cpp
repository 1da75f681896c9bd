#include <benchmark/benchmark.h>

#include <cmath>

#include "adapt/transfer/gauss_points.hpp"
#include "adapt/transfer/gauss_transfer.hpp"

/// State of Gauss points from mesh to mesh by each choice: error, decay over a hundred transfers there and back, time.
namespace {

using namespace reye;
using adapt::GaussTransfer;
using base::Matrix;
using base::Vec2;

constexpr std::array names{"nearest", "patch", "l2"};
constexpr std::array kinds{"tri3", "quad4"};

/// The unit square in n x m quadrilaterals or twice as many triangles, inner nodes scattered by a share of a third of a
/// cell.
mesh::Mesh square(int n, int m, mesh::CellKind kind, double scatter) {
  mesh::Mesh mesh;
  mesh.kind = kind;
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) {
      const bool inner = i > 0 && j > 0 && i < n && j < m;
      const double k = 37.0 * (12.9898 * i + 78.233 * j), s = inner ? scatter / 3.0 : 0.0;
      mesh.X.emplace_back((i + s * std::sin(k)) / n, (j + s * std::cos(1.43 * k)) / m);
    }
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, d = a + n + 1, c = d + 1;
      if (kind == mesh::CellKind::quad4) {
        mesh.cells.push_back(mesh::cell_of({a, b, c, d}));
      } else {
        mesh.cells.push_back(mesh::cell_of({a, b, c}));
        mesh.cells.push_back(mesh::cell_of({a, c, d}));
      }
    }
  return mesh;
}

mesh::CellKind kind_of(const benchmark::State& run) {
  return run.range(1) == 0 ? mesh::CellKind::tri3 : mesh::CellKind::quad4;
}

adapt::GaussOptions options(const benchmark::State& run) { return {static_cast<GaussTransfer>(run.range(0))}; }

void label(benchmark::State& run) { run.SetLabel(std::string(names[run.range(0)]) + " " + kinds[run.range(1)]); }

template <class F>
Matrix sampled(const mesh::Mesh& mesh, F f) {
  const auto points = adapt::gauss_points(mesh, base::Analysis::plane_strain).x;
  Matrix values(static_cast<Eigen::Index>(points.size()), 1);
  for (std::size_t i = 0; i < points.size(); ++i) values(static_cast<Eigen::Index>(i), 0) = f(points[i]);
  return values;
}

double integral(const mesh::Mesh& mesh, const Matrix& values) {
  const auto points = adapt::gauss_points(mesh, base::Analysis::plane_strain);
  return Eigen::Map<const base::Vector>(points.volume.data(), values.rows()).dot(values.col(0));
}

double norm(const mesh::Mesh& mesh, const Matrix& values) {
  return std::sqrt(integral(mesh, values.cwiseProduct(values)));
}

/// Relative L2 error of one transfer of a smooth field, old cells of 1 / n.
void gauss_error(benchmark::State& run) {
  const auto smooth = [](const Vec2& x) { return 1.5 + std::sin(3.0 * x.x()) * std::cos(2.0 * x.y()); };
  const auto n = static_cast<int>(run.range(2));
  const auto from = square(n, n, kind_of(run), 0.6), to = square(5 * n / 4, 9 * n / 8, kind_of(run), 0.4);
  const Matrix exact = sampled(to, smooth);
  Matrix got;
  for (auto _ : run) got = adapt::transfer_gauss(from, sampled(from, smooth), to, options(run));
  label(run);
  run.counters["n"] = static_cast<double>(n);
  run.counters["error"] = norm(to, got - exact) / norm(to, exact);
}

double zone(const Vec2& x) { return std::exp(-(x - Vec2(0.5, 0.5)).squaredNorm() / (2.0 * 0.1 * 0.1)); }
double front(const Vec2& x) { return (x - Vec2(0.5, 0.5)).norm() < 0.25 ? 1.0 : 0.0; }

/// The decay of a plastic zone, a bell eight cells wide or a disc twenty cells wide, on 40 x 40 cells.
void gauss_decay(benchmark::State& run) {
  const auto one = square(40, 40, kind_of(run), 0.5), other = square(44, 43, kind_of(run), 0.6);
  const Matrix start = sampled(one, run.range(2) == 0 ? zone : front);
  const auto times = static_cast<int>(run.range(3));
  Matrix now;
  for (auto _ : run) {
    now = start;
    for (int k = 0; k < times; ++k) {
      now = adapt::transfer_gauss(one, now, other, options(run), {0});
      now = adapt::transfer_gauss(other, now, one, options(run), {0});
    }
  }
  label(run);
  run.counters["front"] = static_cast<double>(run.range(2));
  run.counters["times"] = times;
  run.counters["peak"] = now.maxCoeff() / start.maxCoeff();
  run.counters["integral"] = integral(one, now) / integral(one, start);
  run.counters["error"] = norm(one, now - start) / norm(one, start);
  run.counters["least"] = now.minCoeff();
}

/// Five components, 1e4 old and new cells.
void gauss_time(benchmark::State& run) {
  const bool triangles = run.range(1) == 0;
  const int n = 100, m = triangles ? 50 : 100;
  const auto from = square(n, m, kind_of(run), 0.5), to = square(m, n, kind_of(run), 0.6);
  const Matrix values = sampled(from, zone).replicate(1, 5);
  for (auto _ : run) benchmark::DoNotOptimize(adapt::transfer_gauss(from, values, to, options(run)));
  label(run);
}

const std::vector<std::int64_t> every_way{0, 1, 2}, every_kind{0, 1};
BENCHMARK(gauss_error)->ArgsProduct({every_way, every_kind, {8, 16, 32, 64}})->Iterations(1);
BENCHMARK(gauss_decay)->ArgsProduct({every_way, every_kind, {0, 1}, {1, 10, 100}})->Iterations(1);
BENCHMARK(gauss_time)->ArgsProduct({every_way, every_kind})->Unit(benchmark::kMillisecond);

}  // namespace
