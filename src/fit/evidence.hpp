#pragma once
#include <vector>

#include "fit/record.hpp"

/// What a series says of theta, and of its noise.
namespace reye::fit {

/// One noise that a series may have.
struct Told {
  Noise noise;
  double weight = 1.0;   ///< restricted likelihood times prior, of all one: README (6)
  double squares = 0.0;  ///< what theta of the series alone, shifts and levels leave of the values, in units of V
  Matrix variance;       ///< of the scores, over sigma^2
};

struct Evidence {
  Matrix information;  ///< J^T W J, shifts and levels eliminated; the score J^T W e has covariance sigma^2 variance
  Vector score;        ///< J^T W (value - model)
  int freedom = 0;     ///< blocks minus what the series itself takes; 0: scatter is given
  std::vector<Told> told;
};

/// Of columns of the record (a row per value, nuisances first, then `asked` ones, then values): under each noise.
/// Weights W are those of the record.
Evidence evidence_of(const Record& record, const Matrix& columns, int asked, const std::vector<Noise>& noises);

const Told& likeliest(const Evidence& evidence);

/// The variance under which independent values would inform as much as those of the series do (mean over the
/// directions of theta): README (3).
double variance_as_white(const Record& record, const Evidence& evidence);

}  // namespace reye::fit
