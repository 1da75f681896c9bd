#include "fit/search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algebra/decompose.hpp"

namespace reye::fit {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr int most_steps = 100;
constexpr double longest_theta = 1.0, longest_shift = 0.25;  ///< steps; the latter of the extent
constexpr double farthest_theta = 14.0;                      ///< from the start: a factor of a million

double sum_of_squares(const std::vector<Record>& records, const Model& model, const Unknowns& at) {
  double S = 0.0;
  for (const Record& record : records) {
    const Matrix columns = residual_columns(record, model, at);
    if (!columns.allFinite()) return infinite;
    S += gram_of(record, columns)(0, 0);
  }
  return std::isfinite(S) ? S : infinite;
}

int values_of(const std::vector<Record>& records) {
  int count = 0;
  for (const Record& record : records) count += static_cast<int>(record.blocks.at.size());
  return count;
}

/// The step to the minimum of a damped normal system, cut where it is longer than the model is trusted.
Vector damped_step(const Normal& normal, double damping, const std::vector<Record>& records, Eigen::Index p) {
  Matrix H = normal.H;
  for (Eigen::Index i = 0; i < H.rows(); ++i) H(i, i) = H(i, i) > 0.0 ? H(i, i) * (1.0 + damping) : 1.0;
  Vector step = algebra::solve_symmetric(H, normal.g);
  if (!step.allFinite()) return Vector::Zero(step.size());
  double reach = step.head(p).cwiseAbs().maxCoeff() / longest_theta;
  Eigen::Index i = p;
  for (const Record& record : records)
    for (int j = 0; j < record.shifts(); ++j)
      reach = std::max(reach, std::abs(step[i++]) / (longest_shift * record.extent.maxCoeff()));
  return reach > 1.0 ? Vector(step / reach) : step;
}

void hold(Normal& normal, int held) {
  if (held < 0) return;
  normal.H.row(held).setZero();
  normal.H.col(held).setZero();
  normal.g[held] = 0.0;
}

}  // namespace

Found descend(const std::vector<Record>& records, const Model& model, Unknowns start, int held) {
  constexpr double negligible = 1e-7, tolerable = 1e-2;  // decrease of S over the variance of a value
  constexpr double shortest = 1e-8;
  const Eigen::Index p = start.theta.size();
  const Vector first = start.theta;
  Found found{start, sum_of_squares(records, model, start)};
  if (!std::isfinite(found.S)) return found;
  double damping = 1e-3, ahead = infinite;
  for (int i = 0; i < most_steps; ++i) {
    Normal normal = normal_at(records, model, found.at);
    if (!normal.H.allFinite()) break;
    hold(normal, held);
    const double unit = std::max(found.S / values_of(records), std::numeric_limits<double>::min());
    bool better = false;
    while (!better && damping < 1e8) {
      const Vector step = damped_step(normal, damping, records, p);
      ahead = step.dot(2.0 * normal.g - normal.H * step) / unit;
      if (damping < 1.0 && step.cwiseAbs().maxCoeff() < shortest) ahead = 0.0;
      const Unknowns next = moved(records, found.at, step);
      if (ahead < negligible || (next.theta - first).cwiseAbs().maxCoeff() > farthest_theta) break;
      const double S = sum_of_squares(records, model, next);
      better = S < found.S;
      if (better) found = {next, S};
      damping = std::max(damping * (better ? 0.1 : 10.0), 1e-12);
    }
    if (!better) break;
  }
  found.converged = ahead < tolerable;
  return found;
}

double scan_shifts(const std::vector<Record>& records, const Model& model, Unknowns& at) {
  constexpr int along_a_line = 24, along_a_side = 4;  // to either side
  constexpr double farthest = 0.75;                   // of the extent
  double sum = 0.0;
  for (const Record& record : records) {
    const std::vector<Record> alone{record};
    const int steps = !record.series->moved ? 0 : record.series->map ? along_a_side : along_a_line;
    const int across = record.series->map ? steps : 0;
    const Vec2 centre = at.shift[record.number];
    Unknowns trial = at;
    double least = infinite;
    for (int j = -across; j <= across; ++j)
      for (int i = -steps; i <= steps; ++i) {
        const Vec2 part{steps > 0 ? farthest * i / steps : 0.0, across > 0 ? farthest * j / across : 0.0};
        trial.shift[record.number] = centre + part.cwiseProduct(record.extent);
        const double S = sum_of_squares(alone, model, trial);
        if (S >= least) continue;
        least = S;
        at.shift[record.number] = trial.shift[record.number];
      }
    sum += least;
  }
  return sum;
}

Found search(const std::vector<Record>& records, const Model& model, const Unknowns& start) {
  constexpr std::size_t descents = 3;
  const Eigen::Index p = start.theta.size();
  std::vector<Found> starts{{start, 0.0, false}};
  for (Eigen::Index k = p > 1 ? -1 : 0; k < p; ++k)
    for (const double by : {-6.0, -4.0, -2.0, -1.0, 1.0, 2.0, 4.0}) {
      starts.push_back({start, 0.0, false});
      starts.back().at.theta += by * (k < 0 ? Vector::Ones(p) : Vector(Vector::Unit(p, k)));
    }
  for (Found& one : starts) one.S = scan_shifts(records, model, one.at);
  std::sort(starts.begin(), starts.end(), [](const Found& a, const Found& b) { return a.S < b.S; });
  Found best{start, infinite, false};
  for (std::size_t i = 0; i < std::min(descents, starts.size()); ++i) {
    const Found found = descend(records, model, starts[i].at);
    if (found.S < best.S) best = found;
  }
  return best;
}

}  // namespace reye::fit
