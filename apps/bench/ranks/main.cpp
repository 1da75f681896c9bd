// reye-ranks PARTS SIDE [one]: what the factor of a cube of PARTS^3 hexahedra with SIDE x SIDE nodes retained takes on
// all ranks of mpirun, or, with `one`, in this process by CHOLMOD. Each rank prints a line of its largest memory.
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "../patch_last.hpp"
#include "algebra/factor.hpp"
#include "algebra/factor_cost.hpp"
#include "algebra/ranks.hpp"

namespace {

using namespace reye;

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

void tell_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("{\"largest_MB\": %.1f}\n", static_cast<double>(usage.ru_maxrss) / 1e3);
}

struct Times {
  double factor_s = 0.0, solve_s = 0.0;
};

Times of_one(base::SparseMatrix K, int retained) {
  const algebra::Vector f = algebra::Vector::Ones(K.rows());
  const double start = seconds();
  const algebra::SchurFactor factor(std::move(K), retained, {}, algebra::Ordering::nested_dissection);
  const double made = seconds();
  factor.recover(f, algebra::Vector::Zero(retained));
  return {made - start, seconds() - made};
}

Times of_ranks(const base::SparseMatrix& K, int retained) {
  const double start = seconds();
  const algebra::RankedFactor factor(K, retained);
  const double made = seconds();
  factor.solve_interior(algebra::Vector::Ones(K.rows() - retained));
  return {made - start, seconds() - made};
}

}  // namespace

int main(int argc, char** argv) {
  const algebra::Ranks ranks;
  if (ranks.served()) {
    tell_memory();
    return 0;
  }
  if (argc < 3) return 2;
  const int parts = std::atoi(argv[1]), side = std::atoi(argv[2]), retained = 3 * side * side;
  auto K = bench::patch_last({parts, parts, parts}, side);
  const int dofs = static_cast<int>(K.rows());
  const bool one = argc > 3;
  const Times times = one ? of_one(K, retained) : of_ranks(K, retained);
  tell_memory();
  const auto cost = algebra::factor_cost(std::move(K), retained, 1);
  std::printf(
      "{\"ranks\": %d, \"dofs\": %d, \"retained\": %d, \"factor_s\": %.4g, \"solve_s\": %.4g, \"entries\": %.6g, "
      "\"flops\": %.6g}\n",
      one ? 0 : algebra::ranks(), dofs, retained / 3, times.factor_s, times.solve_s, cost.entries, cost.flops);
  return 0;
}
