#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/analysis.hpp"
#include "base/linalg.hpp"
#include "mesh/mesh.hpp"

/// Records of a run: plain values, filled by `sim`, written by `output`.
namespace reye::sim {

using base::Vec2;
using base::Vector;

/// One contact in a row of the history. Forces as in ContactSummary, energy per mm in plane problems.
struct ContactRow {
  double pressure_max_MPa = 0.0;
  double depth_max_secondary_mm = 0.0, depth_max_primary_mm = 0.0;
  double energy_mJ = 0.0;
  double normal_force = 0.0, tangential_force = 0.0;
};

/// The place and moment of a largest traction.
struct TractionPeak {
  double MPa = 0.0;  ///< 0: no such traction, and no place
  Vec2 at_mm{0.0, 0.0};
  double cycle = 0.0;
  bool at_end = false;  ///< within two facets of a free end of the bond, where it grows without bound as they shorten
};

/// The tractions of a bond, or the largest so far. Tension opens it.
struct BondTraction {
  TractionPeak tension, shear;
  double mean_tension_MPa = 0.0;  ///< over its length; below zero where it is pressed
  double mean_shear_MPa = 0.0;    ///< likewise, of the amount
};

/// One row of history.csv: the end of an accepted increment.
struct IncrementRecord {
  // Compiled once: every file that holds one would else compile them.
  IncrementRecord();
  IncrementRecord(const IncrementRecord&);
  IncrementRecord(IncrementRecord&&) noexcept;
  IncrementRecord& operator=(const IncrementRecord&);
  IncrementRecord& operator=(IncrementRecord&&) noexcept;
  ~IncrementRecord();

  std::string step;
  double cycle = 0.0;
  double progress = 0.0;  ///< of the step's play, in (0, 1]
  int newton = 0;
  double pressure_max_MPa = 0.0;
  double depth_max_secondary_mm = 0.0;
  double depth_max_primary_mm = 0.0;
  double energy_mJ = 0.0;  ///< per mm in plane problems
  std::vector<ContactRow>
      contacts;  ///< one per contact of the scene; above are the largest of them, and the sum of energies
  std::vector<BondTraction> bonds;   ///< one per bond of the scene
  std::vector<Vec2> support_forces;  ///< on the body, in x and y, one per support of the scene
  std::vector<std::optional<double>>
      support_moments;  ///< about the middle of the edge, of rigid edges in plane problems
};

enum class Side { secondary, primary };

/// One side of a contact as rows along its chains (mesh::arc_chains), one chain after the other: where the next one
/// begins, the arc length of the last row is repeated. A ring ends with the row it began with.
/// status: 0 inactive, 1 stick, 2 slip; the primary side repeats the tractions of the secondary.
struct SurfaceRecord {
  // Compiled once: every file that holds one would else compile them.
  SurfaceRecord();
  SurfaceRecord(const SurfaceRecord&);
  SurfaceRecord(SurfaceRecord&&) noexcept;
  SurfaceRecord& operator=(const SurfaceRecord&);
  SurfaceRecord& operator=(SurfaceRecord&&) noexcept;
  ~SurfaceRecord();

  std::string contact;
  Side side = Side::secondary;
  std::vector<int> body, node;       ///< of each row: the body, and the node of its mesh
  std::vector<char> body_on_left{};  ///< of each row: whether the body lies on the left of increasing arc length
  std::vector<double> arc_length_mm, x_mm, y_mm, pressure_MPa, shear_MPa, slip_mm, wear_depth_mm;
  std::vector<int> status;
};

struct BodyFrame {
  // Compiled once: every file that holds one would else compile them.
  BodyFrame();
  BodyFrame(const BodyFrame&);
  BodyFrame(BodyFrame&&) noexcept;
  BodyFrame& operator=(const BodyFrame&);
  BodyFrame& operator=(BodyFrame&&) noexcept;
  ~BodyFrame();

  std::string name;
  std::shared_ptr<const mesh::Mesh> mesh;         ///< on X; a rigid body has outline only
  std::vector<Vec2> u;                            ///< nodal displacement [mm]
  double angle_rad = 0.0;                         ///< rotation of a linear body, whose strain is measured in that frame
  std::vector<std::array<double, 4>> stress_MPa;  ///< nodal (11, 22, 12, 33); empty for a rigid body
  std::vector<double> plastic_strain;             ///< nodal, accumulated; empty where nothing yields
  std::vector<double> wear_depth_mm;              ///< nodal, zero inside
};

/// A state as pictures need it.
struct Frame {
  double cycle = 0.0;
  std::string step;
  std::vector<BodyFrame> bodies;
  std::vector<SurfaceRecord> surfaces;
  std::vector<SurfaceRecord>
      bonds;  ///< of bonds the secondary side alone: its tractions, pressure below zero in tension
};

struct SideSummary {
  double max_depth_mm = 0.0;
  double worn_area = 0.0;  ///< mm^2, or mm^3 in axisymmetry
  double scar_width_mm = 0.0;
};

/// Values at the end of the last accepted increment; unknown values are empty (null on disk).
struct ContactSummary {
  std::string name;
  std::optional<double> peak_pressure_MPa, contact_half_width_mm, stick_half_width_mm;
  double normal_force = 0.0;  ///< N per mm, or N
  double tangential_force = 0.0;
  double dissipated_energy = 0.0;  ///< mJ per mm, or mJ
  SideSummary secondary, primary;
  std::optional<double> ledger_relative_error;  ///< empty where nothing wears
};

/// A bond at the end of the last accepted increment, and the largest tractions at the end of any.
struct BondSummary {
  std::string name;
  BondTraction end, most;
};

/// One body remeshed. The jumps compare the equilibrium before the shape step with that on the new mesh.
struct RemeshRecord {
  std::string step;
  double cycle = 0.0;
  std::string body;
  std::string reason;
  int nodes_before = 0, nodes_after = 0;
  double scaled_jacobian_before = 0.0, scaled_jacobian_after = 0.0;  ///< of the poorest element
  double projection_mm = 0.0;  ///< largest distance of a new contact node from the old mesh
  double area_residue = 0.0;   ///< correction of the fresh outline's content [mm^2; mm^3 in axisymmetry]
  double gap_moved_mm = 0.0;   ///< largest move of a worn node to keep pressures on the new mesh
  double gap_left_mm = 0.0;    ///< largest gap under a pressure that no worn node could close
  double pressure_jump =
      0.0;  ///< difference in pressure over the pressure, both as root mean squares; the worst of this body's contacts
  double peak_jump = 0.0;    ///< largest difference at a node within 0.9 of the contact, over the largest pressure
  double force_jump = 0.0;   ///< difference of the contact force over the force
  double energy_jump = 0.0;  ///< difference of the strain energy over the energy
  double mesh_seconds = 0.0, seconds = 0.0;  ///< in gmsh, and in total with re-equilibration
};

/// The life of a limit under the scatter of the wear coefficients; empty when it is not reached.
struct LifeBand {
  std::optional<double> shortest_cycles, longest_cycles;
};

struct Counts {
  long blocks = 0, increments = 0, newton_iterations = 0, factorisations = 0, remeshes = 0, cutbacks = 0;
  long cycles_solved = 0;           ///< plays of a cycle, those for the error and of refused blocks included
  long refused_blocks = 0;          ///< blocks under a tolerance that were tried with too many cycles
  long equilibrium_iterations = 0;  ///< of Newton on worn and on fresh shapes; those are no increments
};

/// A warning that a reader of the results must know before trusting them.
struct Warning {
  std::string kind;       ///< one word for scripts: "strain", "overlap", "resolution", "tolerance" ...
  std::string about;      ///< contact, body, step, limit or support of the scene, "contact pad"; empty: the whole run
  std::string text;       ///< a sentence with the size of the problem and what to change
  double severity = 0.0;  ///< of one kind about one thing only the most severe is kept
};

enum class RunStatus { done, failed, interrupted };

/// What thinning has left of a measured history.
struct ThinnedHistory {
  std::size_t points = 0, kept = 0;
  double tolerance = 0.0, way_lost = 0.0;  ///< shares of its range, and of its way up and down
};

struct Summary {
  // Compiled once: every file that holds one would else compile them.
  Summary();
  Summary(const Summary&);
  Summary(Summary&&) noexcept;
  Summary& operator=(const Summary&);
  Summary& operator=(Summary&&) noexcept;
  ~Summary();

  std::string title;
  RunStatus status = RunStatus::done;
  std::string reason;  ///< empty when done
  double cycles = 0.0;
  std::vector<ContactSummary> contacts;
  std::vector<BondSummary> bonds;
  std::map<std::string, Vec2> probes;
  std::map<std::string, std::optional<double>> life_cycles;  ///< by limit
  std::map<std::string, double> life_error;                  ///< of the limits reached, where known [cycles]
  std::map<std::string, double> limit_share;                 ///< of every limit: its measure at the end over its bound
  std::map<std::string, LifeBand> life_band;                 ///< of the limits with a scatter
  std::optional<double> error_cycle_jump, error_discretisation, error_peak_pressure, error_small_strain,
      error_energy_norm;
  std::vector<Warning> warnings;  ///< those known before the run, then those found in it
  Counts counts;
  double wall_s = 0.0, cpu_s = 0.0, peak_rss_MB = 0.0;
  std::map<std::string, double> room_seconds;       ///< where the time went
  std::vector<std::string> skipped;                 ///< sentences of the plan
  std::map<std::string, ThinnedHistory> histories;  ///< those that come from files
  std::vector<std::string> cutback_reasons;
  std::string scene_sha256;
  base::Analysis analysis = base::Analysis::plane_strain;
};

/// Data of the progress line.
struct Progress {
  std::string step;
  double cycle = 0.0, cycles = 0.0;
  int increment = 0, increments = 0;
  int newton = 0;
  double depth_max_mm = 0.0;
  double fraction = 0.0;      ///< of the step
  double solved = 0.0;        ///< increments of the run so far, those of halves and refused blocks included
  double to_be_solved = 0.0;  ///< increments left, by an estimate at the start of the block
};

}  // namespace reye::sim
