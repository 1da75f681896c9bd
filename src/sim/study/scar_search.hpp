#pragma once
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/study/calibration.hpp"
#include "sim/study/scar_model.hpp"
#include "wear/law.hpp"

/// The search for values with which computed scars are as measured.
namespace reye::sim {

using KeyValues = std::vector<std::pair<std::string, double>>;

/// A contact and its law, with the coefficients of the scene.
struct ScarContact {
  std::string name;
  wear::Law wear;
};

/// A scene of any kind, as the search needs it.
struct ScarScene {
  std::vector<ScarContact> contacts;
  std::string no_scaling;  ///< why scars do not depend on coefficient x cycles alone; empty where they do
  double cycles = 0.0;     ///< of all its steps
  std::function<std::optional<double>(const std::string& key)> number_at;
  /// Throws base::InputError where the scene cannot take the values.
  std::function<void(const KeyValues&)> check;
  /// Plays the scene with these values; the rest as `play_scars`.
  std::function<ScarRun(const KeyValues&, const WearFactors&, double cycles, const ScarStop&)> play;
};

/// Plays and fits until runs and estimate agree; `result.measured` is given, the rest but its values is filled. Returns
/// what the parameters of the estimate stand for.
ScarParameters search_scars(const ScarScene& scene, std::vector<FreeKey> free, const CalibrationWatch& watch,
                            Calibration& result);

}  // namespace reye::sim
