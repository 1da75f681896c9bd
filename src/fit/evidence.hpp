#pragma once
#include <vector>

#include "fit/record.hpp"

/// What a series says of theta under each noise it may have, and how much each noise is worth.
namespace reye::fit {

/// Under one noise, per unit of sigma^2: log L(theta) = const - (delta - A^-1 b)^T A (delta - A^-1 b) / (2 sigma^2).
struct Told {
  Noise noise;
  double weight = 1.0;   ///< restricted likelihood times prior, of all one: README (6)
  double squares = 0.0;  ///< what theta of the series alone, shifts and levels leave of the values
  Matrix A;
  Vector b;
};

struct Evidence {
  std::vector<Told> told;
  int freedom = 0;     ///< values (of a block's mean each) minus what the series itself takes; 0: scatter is given
  int dependence = 0;  ///< how many of `asked` columns the series tells apart
};

/// `columns`: of the record, a row per value; the last but one to the last `asked` are asked for, all before them
/// are nuisances. Noise is that of the record alone where its scatter is given, else one of `candidates`.
Evidence evidence_of(const Record& record, const Matrix& columns, int asked, const std::vector<Noise>& noises);

/// The noise of the largest weight, and sigma^2 under it.
void believe(Record& record, const Evidence& evidence);

}  // namespace reye::fit
