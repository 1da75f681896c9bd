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

void scan_shifts(const std::vector<Record>& records, const Model& model, Unknowns& at) {
  constexpr int along_a_line = 16, along_a_side = 4;  // to either side, of half an extent
  for (const Record& record : records) {
    if (!record.series->moved) continue;
    const std::vector<Record> alone{record};
    const int steps = record.series->map ? along_a_side : along_a_line, across = record.series->map ? steps : 0;
    const Vec2 centre = at.shift[record.number];
    Unknowns trial = at;
    double least = sum_of_squares(alone, model, at);
    for (int j = -across; j <= across; ++j)
      for (int i = -steps; i <= steps; ++i) {
        const Vec2 part{0.5 * i / steps, across > 0 ? 0.5 * j / across : 0.0};
        trial.shift[record.number] = centre + part.cwiseProduct(record.extent);
        const double S = sum_of_squares(alone, model, trial);
        if (S < least) {
          least = S;
          at.shift[record.number] = trial.shift[record.number];
        }
      }
  }
}

Found search(const std::vector<Record>& records, const Model& model, Unknowns start) {
  scan_shifts(records, model, start);
  Found found = descend(records, model, start);
  constexpr int most_scans = 3;
  for (int i = 0; i < most_scans; ++i) {
    Unknowns elsewhere = found.at;
    scan_shifts(records, model, elsewhere);
    if (elsewhere.shift == found.at.shift) break;
    const Found other = descend(records, model, elsewhere);
    if (!(other.S < found.S * (1.0 - 1e-6))) break;
    found = other;
  }
  return found;
}

}  // namespace reye::fit
