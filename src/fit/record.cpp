#include "fit/record.hpp"

#include "algebra/decompose.hpp"

namespace reye::fit {

namespace {

/// Steps of central differences: wide enough to average over kinks of interpolation, narrow against what bends a scar.
constexpr double theta_step = 5e-3, shift_step = 2e-3;  ///< the latter of the extent

/// Rows over the given scatter.
Matrix scaled(const Record& record, Matrix columns) {
  if (record.known()) columns = record.series->scatter.cwiseInverse().asDiagonal() * columns;
  return columns;
}

}  // namespace

std::vector<Record> records_of(const std::vector<Series>& series) {
  std::vector<Record> records;
  for (std::size_t s = 0; s < series.size(); ++s) {
    Record record;
    record.series = &series[s];
    record.number = s;
    record.blocks = blocks_of(series[s]);
    record.extent = extent_of(series[s].at);
    for (const Vec2& p : series[s].at) record.middle += p / static_cast<double>(series[s].at.size());
    records.push_back(std::move(record));
  }
  return records;
}

Matrix level_columns(const Record& record) {
  const auto& at = record.series->at;
  Matrix columns = Matrix::Ones(static_cast<Eigen::Index>(at.size()), record.levels());
  for (int j = 1; j < record.levels(); ++j)
    for (std::size_t i = 0; i < at.size(); ++i) {
      const double extent = record.extent[j - 1];
      columns(static_cast<Eigen::Index>(i), j) = extent > 0.0 ? (at[i][j - 1] - record.middle[j - 1]) / extent : 0.0;
    }
  return columns;
}

Matrix columns_of(const Record& record, const Model& model, const Unknowns& at) {
  const int levels = record.levels(), shifts = record.shifts();
  const auto p = static_cast<int>(at.theta.size());
  Matrix columns(record.series->value.size(), levels + shifts + p + 1);
  columns.leftCols(levels) = level_columns(record);
  const Vec2& shift = at.shift[record.number];
  for (int j = 0; j < shifts; ++j) {
    const Vec2 step = shift_step * record.extent.maxCoeff() * Vec2::Unit(j);
    columns.col(levels + j) =
        (model(at.theta, record.number, shift + step) - model(at.theta, record.number, shift - step)) / (2.0 * step[j]);
  }
  for (int j = 0; j < p; ++j) {
    const Vector step = theta_step * Vector::Unit(p, j);
    columns.col(levels + shifts + j) =
        (model(at.theta + step, record.number, shift) - model(at.theta - step, record.number, shift)) /
        (2.0 * theta_step);
  }
  columns.rightCols(1) = record.series->value - model(at.theta, record.number, shift);
  return scaled(record, std::move(columns));
}

Matrix bends_of(const Record& record, const Model& model, const Unknowns& at, const Vector& reach) {
  const int shifts = record.shifts();
  const auto p = static_cast<int>(at.theta.size());
  Matrix bends(record.series->value.size(), 2 * (shifts + p));
  const Vec2& shift = at.shift[record.number];
  const Vector here = model(at.theta, record.number, shift);
  for (int j = 0; j < shifts + p; ++j) {
    Vec2 aside = Vec2::Zero();
    Vector along = Vector::Zero(p);
    (j < shifts ? aside[j] : along[j - shifts]) = reach[j];
    const Vector after = model(at.theta + along, record.number, shift + aside);
    const Vector before = model(at.theta - along, record.number, shift - aside);
    bends.col(2 * j) = 0.5 * (after + before) - here;
    bends.col(2 * j + 1) = 0.5 * (after - before);
  }
  return scaled(record, std::move(bends));
}

Matrix residual_columns(const Record& record, const Model& model, const Unknowns& at) {
  Matrix columns(record.series->value.size(), record.levels() + 1);
  columns.leftCols(record.levels()) = level_columns(record);
  columns.rightCols(1) = record.series->value - model(at.theta, record.number, at.shift[record.number]);
  return scaled(record, std::move(columns));
}

Matrix gram_of(const Record& record, const Matrix& columns) {
  Matrix gram = weigh(record.blocks, record.series->map, {}, record.blocks.averaged(columns)).gram;
  eliminate(gram, record.levels());
  const Eigen::Index left = gram.cols() - record.levels();
  return gram.bottomRightCorner(left, left) / record.variance;
}

Vector level_of(const Record& record, const Model& model, const Unknowns& at) {
  const int levels = record.levels();
  Vector result = Vector::Zero(3);
  if (levels == 0) return result;
  const Matrix columns = record.blocks.averaged(residual_columns(record, model, at));
  const Matrix gram = weigh(record.blocks, record.series->map, {}, columns).gram;
  result.head(levels) = algebra::least_squares(gram.topLeftCorner(levels, levels), gram.topRightCorner(levels, 1));
  for (int j = 1; j < levels; ++j) {
    result[j] = record.extent[j - 1] > 0.0 ? result[j] / record.extent[j - 1] : 0.0;
    result[0] -= result[j] * record.middle[j - 1];
  }
  return result;
}

}  // namespace reye::fit
