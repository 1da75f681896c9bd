#pragma once
#include "fit/evidence.hpp"

/// Whether a scar of another shape would fit better than noise explains.
namespace reye::fit {

struct ShapeTest {
  double probability = 1.0;  ///< of noise that a freer shape fits as much better
  double part = 0.0;         ///< of the depth (root mean square) that is left
  double width = 0.0;        ///< of the scar, four times the root mean square of its distance from the middle [mm]
};
/// README (11). The scatter of the series is not given. `taken`: its `taken_columns`. Where what is left is less than
/// `noticeable`, the probability is not looked for.
ShapeTest shape_test(const Record& record, const Model& model, const Unknowns& at, const Matrix& taken,
                     double noticeable);

}  // namespace reye::fit
