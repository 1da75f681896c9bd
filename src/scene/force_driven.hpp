#pragma once
#include <set>
#include <string>

#include "scene/scene.hpp"

/// Whether forces alone drive what wears: then no contact can slide as a whole, and stick zones keep their width.
namespace reye::scene {

/// What varies over the cycles that wear.
class CycleDrives {
 public:
  explicit CycleDrives(const std::vector<Step>& steps);

  void add(const body::Motion& motion);
  /// A load with the factor of a history.
  void add_load(const std::string& history) { loaded_ = loaded_ || cycled_.contains(history); }
  /// Forces vary, and no motion that is prescribed.
  bool forces_alone() const { return loaded_ && !moved_; }

 private:
  std::set<std::string> cycled_;  ///< histories that are played cycle by cycle while contacts wear
  bool moved_ = false, loaded_ = false;
};

/// True where forces vary over a cycle that wears and no motion is prescribed.
bool only_forces_drive(const Scene& scene);

}  // namespace reye::scene
