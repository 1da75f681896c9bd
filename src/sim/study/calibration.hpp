#pragma once
#include <functional>
#include <string>
#include <vector>

#include "fit/estimate.hpp"
#include "scene/scars.hpp"
#include "sim/problem/records.hpp"

/// The result of a calibration.
namespace reye::sim {

/// A value of the scene and what the measurements say of it, in the unit of its key.
struct FittedValue {
  std::string key;  ///< "contact.pad.wear.secondary_mm3_per_J"
  double scene = 0.0, fitted = 0.0;
  double low = 0.0, high = 0.0;  ///< bounds of the 95 % interval
  bool coefficient = true;       ///< of wear
};

struct Calibration {
  scene::MeasuredScars measured;
  std::vector<FittedValue> values;
  fit::Estimate estimate;
  double low = 1.0, high = 1.0;    ///< of the interval over the fitted value, the widest of all wear coefficients
  bool scales = true;              ///< lives go as 1 / coefficient, so that `low` and `high` give their scatter
  std::vector<std::string> notes;  ///< what was assumed, and what a reader must know, a sentence each
  std::vector<Warning> warnings;   ///< of the last run
  int runs = 0;
  long increments = 0;  ///< of all runs
  std::string failure;  ///< why there is no result; empty where there is one
};

/// Callbacks that observe a calibration; every member may be empty.
struct CalibrationWatch {
  std::function<void(const std::string&)> told;  ///< what it is doing, a sentence now and then
  std::function<bool()> interrupted;             ///< asked after each increment; true ends it without a result
};

}  // namespace reye::sim
