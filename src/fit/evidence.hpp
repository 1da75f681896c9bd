#pragma once
#include <vector>

#include "fit/pairs.hpp"
#include "fit/record.hpp"

/// What a series says of theta, and of its noise.
namespace reye::fit {

/// Scores J^T W (value - model) of a series, shifts and levels eliminated: J^T W e of the noise e, with covariance
/// J^T W V W J.
struct Scores {
  Matrix information;  ///< J^T W J
  Vector score;
  Pairs pairs;  ///< of W J
};
/// Of columns of the record: nuisances first, then `asked` ones, then value - model.
Scores scores_of(const Record& record, const Matrix& columns, int asked);

/// One noise that a series may have.
struct Likely {
  Noise noise;
  double weight = 1.0;    ///< restricted likelihood times prior, of all one: README (6)
  double variance = 1.0;  ///< sigma^2
};
/// What is believed of the noise of a series.
struct Belief {
  std::vector<Likely> noises;  ///< the likeliest first
  int freedom = 0;             ///< blocks minus what the series itself takes; 0: scatter is given
};
/// From columns that the series itself takes, then value - model.
Belief belief_of(const Record& record, const Matrix& columns);
/// The columns it takes at a place: levels, derivatives by all unknowns, and where the model bends within a standard
/// deviation of them; then value - model.
Matrix taken_columns(const Record& record, const Model& model, const Unknowns& at);

/// Mean covariance of scores.
Matrix variance_of(const Scores& scores, const Belief& belief);

}  // namespace reye::fit
