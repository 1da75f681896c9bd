// reye-ranks PARTS HEIGHT SIDE [one]: seconds that all ranks take for the factor of a block of PARTS x PARTS x HEIGHT
// hexahedra with SIDE x SIDE nodes retained, and for a solution; with `one` those of CHOLMOD in one process. Under
// mpirun.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "../patch_last.hpp"
#include "algebra/factor.hpp"
#include "algebra/ranks.hpp"

namespace {

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

int main(int argc, char** argv) {
  using namespace reye;
  const algebra::Ranks ranks;
  if (ranks.served()) return 0;
  if (argc < 4) return 2;
  const int parts = std::atoi(argv[1]), height = std::atoi(argv[2]), side = std::atoi(argv[3]);
  auto K = bench::patch_last({parts, parts, height}, side);
  const int retained = 3 * side * side, size = static_cast<int>(K.rows());
  double start = seconds(), made = 0.0;
  if (argc > 4) {
    const algebra::SchurFactor factor(std::move(K), retained, {}, algebra::Ordering::nested_dissection);
    made = seconds() - start;
    start = seconds();
    factor.recover(algebra::Vector::Ones(size), algebra::Vector::Zero(retained));
  } else {
    const algebra::RankedFactor factor(K, retained);
    made = seconds() - start;
    start = seconds();
    factor.solve_interior(algebra::Vector::Ones(size - retained));
  }
  std::printf("%d,%d,%d,%.3f,%.4f\n", argc > 4 ? 0 : algebra::ranks(), size, retained / 3, made, seconds() - start);
  return 0;
}
