#pragma once
#include "fit/evidence.hpp"

/// Whether a scar of another shape would fit better than noise explains.
namespace reye::fit {

struct ShapeTest {
  double probability = 1.0;  ///< of noise that a freer shape fits as much better
  double part = 0.0;         ///< of the depth (root mean square) that the freer shape adds
};
/// README (11). The scatter of the series is not given.
ShapeTest shape_test(const Record& record, const Model& model, const Unknowns& at);

}  // namespace reye::fit
