#include "solver/solid/solid_newton.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "solver/solid/solid_iterate.hpp"

namespace reye::solver {

namespace {

/// Below this traction nothing is counted, as a share of the modulus: bodies at rest without load.
constexpr double faint = 1e-14;

double faint_traction(const SolidSystem& system) {
  double largest = 0.0;
  for (const auto& contact : system.contacts)
    for (std::size_t j = 0; j < contact.stiffness.size(); ++j) largest = std::max(largest, contact.stiffness[j]);
  return faint * largest;
}

SolidSolution failed(std::string reason, int iterations, std::vector<double> errors) {
  SolidSolution solution;
  solution.reason = std::move(reason);
  solution.iterations = iterations;
  solution.errors = std::move(errors);
  return solution;
}

SolidSolution loose(std::string reason, int iterations, std::vector<double> errors) {
  SolidSolution solution = failed(std::move(reason), iterations, std::move(errors));
  solution.loose = true;
  return solution;
}

/// Whether the last step served so well that its matrix will serve again, at a fraction of the cost of another: what is
/// left of the error is that of integrals which no matrix holds.
bool falls_fast(const std::vector<double>& errors) {
  constexpr double near = 1e-2, fast = 0.05;
  return errors.size() > 1 && errors.back() < near && errors.back() < fast * errors[errors.size() - 2];
}

double balance_tolerance(const SolidTarget& target, const SolidOptions& options) {
  const bool friction = std::any_of(target.friction.begin(), target.friction.end(), [](double mu) { return mu > 0.0; });
  return (friction ? 10.0 : 1.0) * options.balance_tolerance;
}

/// So many iterations usually settle which points stick and slip; where they have not, points change with care.
constexpr int patience = 10;

/// A start, and the error of an iteration above which it is given up.
struct Try {
  SolidStart start;
  double most = std::numeric_limits<double>::infinity();  ///< of the largest traction
};

/// What slid and turns back misses by several times the largest traction in the natural start, at once or after its
/// first steps, and needs 11 to more than 30 iterations from there; where everything sticks at first it needs 6 to 12
/// (`worn_balls` of the benchmarks). A ball that slides on, and back by imposed slip, takes no more iterations for this
/// bound (`sliding_ball`).
constexpr double turned_back = 3.0;
constexpr std::array first_touch{Try{SolidStart::settled}, Try{SolidStart::natural}, Try{SolidStart::sticking}};
constexpr std::array later{Try{SolidStart::natural, turned_back}, Try{SolidStart::sticking}, Try{SolidStart::settled},
                           Try{SolidStart::natural}};

/// Newton's iteration from one start. The integrals follow the bodies in every iteration; at the end they belong to the
/// positions that were found, to the tolerance.
SolidSolution attempt(const SolidSystem& system, const SolidState& old, const SolidTarget& target,
                      const SolidOptions& options, const Try& from) {
  const SolidStart start = from.start;
  SolidIterate iterate(system, old, target, start);
  const double least = faint_traction(system);
  std::vector<double> errors;
  for (int i = 0;; ++i) {
    bool changed = iterate.classify(i > patience);
    const auto error = iterate.error();
    const double relative = error.traction_MPa / std::max(error.largest_MPa, least);
    if (!std::isfinite(relative)) return failed("Newton's iteration left the numbers", i, errors);
    errors.push_back(relative);
    if (relative > from.most) return failed("the start is far from the solution", i, errors);
    const bool small = relative <= options.tolerance && error.balance <= balance_tolerance(target, options);
    if (small && !changed && (target.keeps_shear || !iterate.shear_is_kept())) {
      iterate.finish();
      SolidSolution solution = iterate.take();
      solution.iterations = i;
      solution.errors = std::move(errors);
      solution.mortar_s = iterate.mortar_s;
      solution.interface_s = iterate.interface_s;
      return solution;
    }
    if (iterate.shear_is_kept() && !target.keeps_shear && !changed && relative < 1e-3) {
      iterate.let_shear_go();
      iterate.classify();
      changed = true;
    }
    if (i >= options.max_newton)
      return failed("Newton's iteration did not converge in " + std::to_string(i) + " iterations: a violation of " +
                        base::formatted("%.1e", relative) + " of the largest traction is left",
                    i, errors);
    if (iterate.came_apart() > 3) return loose("the bodies come apart", i, errors);
    try {
      iterate.step(!changed && falls_fast(errors), relative < 0.1);
    } catch (const base::SolveError& singular) {
      return system.unheld > 0 ? loose(singular.what(), i, errors) : failed(singular.what(), i, errors);
    }
    iterate.integrate();
  }
}

/// Points that were in contact and are stay what they were: while shear is kept nothing decides it.
void keep_status(const SolidState& old, SolidState& now) {
  constexpr auto open = contact::SkinStatus::open;
  for (std::size_t c = 0; c < now.status.size(); ++c)
    for (std::size_t j = 0; j < now.status[c].size(); ++j)
      if (now.status[c][j] != open && old.status[c][j] != open) now.status[c][j] = old.status[c][j];
}

}  // namespace

SolidSolution solve_increment(const SolidSystem& system, const SolidState& old, const SolidTarget& target,
                              const SolidOptions& options) {
  const bool first = !touched(old);
  std::span<const Try> tries = first ? std::span<const Try>(first_touch) : std::span<const Try>(later);
  if (target.keeps_shear) tries = std::span<const Try>(first_touch).first(1);
  SolidSolution solution;
  int spent = 0;
  bool given_up = first;  // else the natural start was tried to its end
  for (const Try& from : tries) {
    const bool again = !first && from.start == SolidStart::natural && &from == &tries.back();
    if (again && !given_up) break;
    try {
      solution = attempt(system, old, target, options, from);
    } catch (const base::MeshError& folded) {  // an iterate with facets that nothing can be integrated over
      solution = failed(folded.what(), 0, {});
    }
    spent += solution.iterations;
    if (solution.converged) break;
    given_up = given_up || (!solution.errors.empty() && solution.errors.back() > from.most);
  }
  solution.iterations = spent;
  if (target.keeps_shear && solution.converged) keep_status(old, solution.state);
  return solution;
}

}  // namespace reye::solver
