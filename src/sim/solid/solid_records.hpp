#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/space.hpp"
#include "mesh/solid/solid_mesh.hpp"
#include "sim/problem/records.hpp"

/// Records of a run of solids: plain values, filled by `sim`, written by `output`. Forces in N, moments in N mm.
namespace reye::sim {

using base::Points3;
using base::Vec3;

/// A contact at the end of an increment.
struct SkinContactRow {
  double pressure_max_MPa = 0.0;
  double area_mm2 = 0.0;                                        ///< of the nodes in contact
  double stick_area_mm2 = 0.0;                                  ///< of those that stick
  Vec3 force_N = Vec3::Zero();                                  ///< on the secondary side
  double normal_force_N = 0.0;                                  ///< int p dA
  double tangential_force_N = 0.0;                              ///< |int t dA|, of the shear alone
  double energy_mJ = 0.0;                                       ///< dissipated since the start
  double depth_secondary_mm = 0.0, depth_primary_mm = 0.0;      ///< largest worn depths
  double volume_secondary_mm3 = 0.0, volume_primary_mm3 = 0.0;  ///< worn since the start
};

/// The resultant of a support on its body.
struct SupportRow {
  Vec3 force_N = Vec3::Zero();
  Vec3 moment_N_mm = Vec3::Zero();  ///< about the support's centre, which moves along with its body
};

struct SolidIncrement {
  std::string step;
  double cycle = 0.0, progress = 0.0;
  int newton = 0;
  std::vector<SkinContactRow> contacts;  ///< one per contact of the scene
  std::vector<SupportRow> supports;      ///< one per support of the scene
  std::vector<double> errors{};          ///< largest violation over largest traction, per iteration
};

/// One body remeshed.
struct SolidRemeshRecord {
  std::string step;
  double cycle = 0.0;
  std::string body;
  std::string reason;
  int nodes_before = 0, nodes_after = 0;
  double quality_before = 1.0, quality_after = 1.0;  ///< shape of the poorest cell; 1 of a rigid body
  int fresh_facets = 0;                              ///< of the skin
  double volume_residue_mm3 = 0.0;                   ///< that the fresh skin lacked before its nodes moved for it
  double correction_mm = 0.0;                        ///< by which they moved
  /// Of this body's contacts the worst: pressures against those carried, root of the mean square over the mean; and
  /// the largest opening by which gaps were fitted to pressures [mm].
  double pressure_change = 0.0, fit_mm = 0.0;
};

/// One side of a contact: nodes that contact was prepared for, and the facets between them.
/// Vectors are in space, places on X. status: 0 inactive, 1 stick, 2 slip; the primary side repeats the tractions of
/// the secondary.
struct SkinRecord {
  std::string contact;
  Side side = Side::secondary;
  std::vector<int> body, node;               ///< of each row
  Points3 x_mm, shear_MPa, slip_mm, normal;  ///< slip: path vector of this increment
  std::vector<double> pressure_MPa, area_mm2;
  std::vector<double> wear_depth_mm;  ///< worn since the start
  std::vector<int> status;
  std::vector<mesh::Facet> facets;  ///< over the rows
  Points3 turn_rad{};               ///< rotation vector of the row's body from X; empty where no body turns
};

struct SolidFrameBody {
  std::string name;
  std::shared_ptr<const mesh::SolidMesh> mesh;
  Points3 u;                                      ///< nodal displacement [mm]
  std::vector<std::array<double, 6>> stress_MPa;  ///< nodal (11, 22, 33, 12, 23, 31); empty for a rigid body
};

struct SolidFrame {
  double cycle = 0.0;
  double progress = 0.0;
  std::string step;
  std::vector<SolidFrameBody> bodies;
  std::vector<SkinRecord> surfaces;
};

struct SkinSideSummary {
  double max_depth_mm = 0.0, worn_volume_mm3 = 0.0;
};

/// Values of a contact at the end of the last accepted increment.
struct SkinContactSummary {
  std::string name;
  std::optional<double> peak_pressure_MPa;
  std::optional<double> area_mm2, equivalent_radius_mm, stick_area_mm2;  ///< radius: of the circle of this area
  std::array<double, 2> half_widths_mm{};  ///< of the contact along its principal directions; 0: not known
  double normal_force_N = 0.0, tangential_force_N = 0.0, dissipated_energy_mJ = 0.0;
  std::optional<double> energy_last_cycle_mJ;  ///< dissipated in the last whole cycle
  bool wears = false;                          ///< else the following are empty
  SkinSideSummary secondary, primary;
  std::optional<double> ledger_relative_error;
};

struct SolidSize {
  int nodes = 0, dofs = 0, cells = 0, retained = 0;  ///< of all bodies
  double memory_MB = 0.0;                            ///< estimated
  double seconds = 0.0;                              ///< estimated, of one CPU
};

struct SolidSummary {
  std::string title;
  RunStatus status = RunStatus::done;
  std::string reason;  ///< empty when done
  double cycles = 0.0;
  std::vector<SkinContactSummary> contacts;
  std::map<std::string, Vec3> probes;
  std::map<std::string, std::optional<double>> life_cycles;  ///< by limit; as in Summary
  std::map<std::string, double> life_error, limit_share;
  std::map<std::string, LifeBand> life_band;
  std::optional<double> error_cycle_jump, error_discretisation, error_peak_pressure;
  std::vector<Warning> warnings;
  Counts counts;
  /// Largest sum of forces on a body over the largest force of the run, or of moments about the middle of its box over
  /// that force times its size, at any end of an increment.
  double balance = 0.0;
  SolidSize size;
  double wall_s = 0.0, cpu_s = 0.0, peak_rss_MB = 0.0;
  std::map<std::string, double> phase_seconds;  ///< "mesh", "stiffness", "factor", "mortar", "interface", "output"
  std::vector<std::string> cutback_reasons;
  std::string scene_sha256;
};

}  // namespace reye::sim
