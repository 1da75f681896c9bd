#pragma once
#include <string>

namespace reye::sim {

/// Observations of a contact at the end of the increment with the largest force in the present block, for warnings.
struct Pressed {
  double force = 0.0;      ///< normal force [N per mm, N]; 0: nothing touched
  double peak_mm = 0.0;    ///< where the pressure is largest: x
  double across = 0.0;     ///< elements across the run of loaded nodes with the peak, of the coarser deformable side
  double length_mm = 0.0;  ///< of that run
  double size_mm = 0.0;    ///< of the secondary facets at the peak
  bool bounded = false;    ///< both its ends are ends of the bodies' sides: no edge of contact lies between nodes
  std::string cut;         ///< a named boundary that ends in the contact while the outline continues; empty: none
  double beside_zone =
      0.0;  ///< element length over that of the fine zone where more than half of the force lies beside it
  double facets_mm = 0.0;  ///< sagitta of the facets of both sides, where nothing has worn yet
};

/// What stuck through a block of a contact that wears.
struct StickZone {
  double stick_mm = 0.0;    ///< width that stuck; 0: none
  double contact_mm = 0.0;  ///< width under pressure
  double element_mm = 0.0;  ///< longest of its elements
};

/// Observations of one contact at ends of increments.
struct ContactWatch {
  double force_most = 0.0;  ///< largest normal force since the start; 0: it never closed
  StickZone widest;         ///< of the block whose stick zone was widest
  int slipped_most = 0;     ///< most nodes that slipped at one end of an increment of a step that wears
  Pressed pressed;          ///< of the present block
};

}  // namespace reye::sim
