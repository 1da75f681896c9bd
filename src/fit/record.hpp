#pragma once
#include <vector>

#include "fit/noise.hpp"

/// A series as it is weighed, and its columns of least squares.
namespace reye::fit {

/// A series with its blocks, and the variance by which it is weighed.
struct Record {
  const Series* series = nullptr;
  std::size_t number = 0;  ///< the model's
  Blocks blocks;
  Vec2 middle{0.0, 0.0}, extent{0.0, 0.0};
  double variance = 1.0;  ///< of a value, as if all were independent (README (3)); 1 where the scatter is given

  bool known() const { return series->scatter.size() > 0; }
  int shifts() const { return !series->moved ? 0 : series->map ? 2 : 1; }  ///< unknown directions of the shift
  int levels() const { return !series->level ? 0 : series->map ? 3 : 2; }  ///< unknown offset and tilts
};
std::vector<Record> records_of(const std::vector<Series>& series);

/// What enters nonlinearly: parameters, and the shift of each series.
struct Unknowns {
  Vector theta;
  std::vector<Vec2> shift;
};

/// 1 and the coordinates from the middle, over the extent: columns of offset and tilts, a row per value.
Matrix level_columns(const Record& record);

/// A row per value: levels, derivatives of the model by shifts and by theta (central differences), and value - model.
/// Of given scatter each row is divided by it. Not finite where the model is not.
Matrix columns_of(const Record& record, const Model& model, const Unknowns& at);
/// Where the model bends within a reach of each unknown (shifts first): half of the second difference, and half of the
/// first one. A row per value.
Matrix bends_of(const Record& record, const Model& model, const Unknowns& at, const Vector& reach);
/// Levels and value - model alone.
Matrix residual_columns(const Record& record, const Model& model, const Unknowns& at);

/// Their Gram matrix over the variance of the record; levels eliminated and left out.
Matrix gram_of(const Record& record, const Matrix& columns);

/// Offset at the origin and tilts that fit best (three numbers).
Vector level_of(const Record& record, const Model& model, const Unknowns& at);

}  // namespace reye::fit
