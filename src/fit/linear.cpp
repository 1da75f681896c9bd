#include "fit/linear.hpp"

#include <algorithm>
#include <cmath>

#include "algebra/decompose.hpp"

namespace reye::fit {

namespace {

constexpr double longest_theta = 0.5, longest_shift = 0.25;  ///< steps; the latter of the extent
constexpr double farthest = 6.9;                             ///< of a bound: a factor of a thousand

Matrix inverse_of(const Matrix& H) { return algebra::solve_symmetric(H, Matrix::Identity(H.rows(), H.cols())); }

/// The part of a step within which a linear model is trusted.
Vector cut(const std::vector<Record>& records, Vector step, Eigen::Index p) {
  double reach = step.head(p).cwiseAbs().maxCoeff() / longest_theta;
  Eigen::Index i = p;
  for (const Record& record : records)
    for (int j = 0; j < record.shifts(); ++j)
      reach = std::max(reach, std::abs(step[i++]) / (longest_shift * record.extent.maxCoeff()));
  return reach > 1.0 ? Vector(step / reach) : step;
}

/// Weights of the residuals of each series in the scores g: H's columns, levels removed.
class Scores {
 public:
  Scores(const std::vector<Record>& records, const Model& model, const Unknowns& at)
      : records_(records), p_(at.theta.size()) {
    for (const Record& record : records) {
      const Matrix columns = columns_of(record, model, at);
      columns_.push_back(columns.leftCols(columns.cols() - 1));
    }
  }
  Vector at(const Model& model, const Unknowns& place) const {
    Vector g = Vector::Zero(p_);
    for (const Record& record : records_) {
      Matrix columns(record.series->value.size(), columns_[record.number].cols() + 1);
      columns << columns_[record.number], residual_columns(record, model, place).rightCols(1);
      const Matrix gram = gram_of(record, columns);
      g.head(p_) += gram.block(record.shifts(), gram.cols() - 1, p_, 1);
      const Eigen::Index first = g.size();
      g.conservativeResize(first + record.shifts());
      g.tail(record.shifts()) = gram.topRightCorner(record.shifts(), 1);
    }
    return g;
  }

 private:
  const std::vector<Record>& records_;
  Eigen::Index p_;
  std::vector<Matrix> columns_;
};

}  // namespace

Normal normal_at(const std::vector<Record>& records, const Model& model, const Unknowns& at) {
  const Eigen::Index p = at.theta.size();
  Eigen::Index size = p;
  for (const Record& record : records) size += record.shifts();
  Normal normal{Matrix::Zero(size, size), Vector::Zero(size)};
  Eigen::Index first = p;
  for (const Record& record : records) {
    const int shifts = record.shifts();
    const Matrix gram = gram_of(record, columns_of(record, model, at));
    const auto theta = gram.middleRows(shifts, p);
    normal.H.topLeftCorner(p, p) += theta.middleCols(shifts, p);
    normal.H.block(0, first, p, shifts) = theta.leftCols(shifts);
    normal.H.block(first, 0, shifts, p) = theta.leftCols(shifts).transpose();
    normal.H.block(first, first, shifts, shifts) = gram.topLeftCorner(shifts, shifts);
    normal.g.head(p) += theta.rightCols(1);
    normal.g.segment(first, shifts) = gram.topRightCorner(shifts, 1);
    normal.S += gram(shifts + p, shifts + p);
    first += shifts;
  }
  return normal;
}

Unknowns moved(const std::vector<Record>& records, Unknowns at, const Vector& step) {
  at.theta += step.head(at.theta.size());
  Eigen::Index i = at.theta.size();
  for (const Record& record : records)
    for (int j = 0; j < record.shifts(); ++j) at.shift[record.number][j] += step[i++];
  return at;
}

std::optional<double> bound_of(const std::vector<Record>& records, const Model& model, const Unknowns& best, int k,
                               double offset) {
  constexpr int most = 60;
  constexpr double close = 2e-3;  // of the offset
  const Eigen::Index p = best.theta.size();
  const Matrix inverse = inverse_of(normal_at(records, model, best).H);
  const Scores scores(records, model, best);
  const Vector first = scores.at(model, best);
  const Vector wanted = Vector::Unit(first.size(), k) * (offset / inverse(k, k));
  Unknowns at = moved(records, best, cut(records, inverse * wanted, p));
  for (int i = 0; i < most; ++i) {
    const Vector rest = wanted - (first - scores.at(model, at));
    if (!rest.allFinite()) return {};
    const Vector step = inverse * rest;
    at = moved(records, at, cut(records, step, p));
    if (std::abs(at.theta[k] - best.theta[k]) > farthest) return {};
    if (std::abs(step[k]) < close * std::abs(offset)) return at.theta[k];
  }
  return {};
}

}  // namespace reye::fit
