#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "adapt/relocation.hpp"
#include "body/operator.hpp"
#include "contact/setup.hpp"
#include "fem/distortion.hpp"
#include "scene/scene.hpp"
#include "sim/recall.hpp"
#include "sim/records.hpp"
#include "sim/watch.hpp"
#include "solver/newton.hpp"

namespace reye::sim {

/// A support of the scene with the body it acts on.
struct PlacedSupport {
  body::Support support;
  int body = 0;
};

/// How the two sides of a contact lie to one another on the drawing.
struct DrawnGap {
  double gap_mm = 0.0;      ///< shortest way between them; 0: they touch or overlap
  double overlap_mm = 0.0;  ///< how deep a node of one side lies inside the body of the other at most; 0: none does
  Vec2 at{0.0, 0.0};        ///< where they are nearest, or that node
  Vec2 out{0.0, 0.0};       ///< from there along the shortest way out, a unit normal
  int primary = 0;          ///< body of the primary side there
  bool let_in = false;      ///< the overlap is too deep to be closed at once: the first step lets it in
};

/// A contact of the scene with its boundaries found.
struct PlacedContact {
  contact::ContactOptions options;
  contact::BoundaryRef secondary;
  std::vector<contact::BoundaryRef> primary;
  double modulus_MPa = 0.0;  ///< stiffness scale of the pair
  DrawnGap drawn;
};

/// What decided the kinematics of a body that left it to the run: a trial at small strain.
struct KinematicsChoice {
  fem::Distortion largest;  ///< that it met
  std::string failure;      ///< why it failed; empty when it did not
};

/// What each body and contact is, what is skipped and why: what `plan` prints is what runs.
struct Plan {
  std::vector<std::string> lines;
  std::vector<std::string> skipped;
};

/// Everything that does not change in a run.
struct Problem {
  scene::Scene scene;
  std::vector<body::BodyInput> inputs;           ///< per body
  std::vector<char> rigid;                       ///< per body
  std::vector<std::vector<int>> support_of;      ///< per body: scene support of each of its own supports
  std::vector<PlacedSupport> supports;           ///< in the order of the scene
  std::vector<PlacedContact> contacts;
  std::vector<PlacedContact> bonds;              ///< in `solver::System` and `State` they come after the contacts
  std::vector<body::ShapePtr> shapes;            ///< at the start
  std::vector<std::optional<KinematicsChoice>> kinematics;  ///< per body; empty where the scene says it
  Plan plan;
  std::vector<Warning> warnings;                 ///< known before the run

  int body_count() const { return static_cast<int>(inputs.size()); }
};

/// Of so many cut-backs a state knows why; more are only counted, so that it does not grow without bound.
inline constexpr long told_cutbacks = 100;

/// All that changes in a run, and nothing else. A value: copied, never half updated.
struct State {
  double cycle = 0.0;
  int step = 0;
  double step_cycles = 0.0;                      ///< cycles done of this step
  long step_blocks = 0;                          ///< blocks done of this step
  double jump = 0.0;                             ///< cycles that the next block is tried with under a tolerance; 0: the first
  double jump_rate = 0.0;                        ///< error of the last block under a tolerance over its share of all wear; 0: none
  double block_cycles = 0.0;                     ///< of a fixed jump that was too long in this step, what worked; 0: none was
  std::optional<double> jump_error;              ///< what the blocks under a tolerance have left, as far as is known
  std::map<std::string, double> factors;         ///< of every history
  std::vector<body::ShapePtr> shapes;
  solver::SolverState solution;
  Recall recall;
  /// Per support of the scene: its x, y and rotation when the reference of its body was last renewed, from where its
  /// columns count since. Empty: no body's ever was.
  std::vector<std::array<double, 3>> renewed_at;
  /// Per body: how far its nodes were displaced when its reference was last renewed; empty: it never was.
  std::vector<base::Points> displaced;
  bool approached = false;                       ///< bodies apart have been moved until they touch
  std::map<std::string, double> life_cycles;     ///< limits reached so far
  std::map<std::string, double> life_error;      ///< of those, by the error known of the cycle jump [cycles]
  std::map<std::string, double> limit_measure;   ///< value of each limit's measure at the last block end
  std::optional<double> small_strain_error;      ///< largest estimate so far where small strain was chosen
  std::vector<Warning> warnings;                 ///< found in the run
  std::vector<ContactWatch> watch;               ///< what was seen of each contact
  std::vector<BondTraction> bonds;               ///< the most that each bond has carried
  Counts counts;
  bool shown = false;                            ///< this very state is a frame already: none is written twice
  std::vector<std::string> cutback_reasons;      ///< of the first `told_cutbacks`
};

/// Derived things, keyed by the shapes they came from; throwing it away changes no result.
struct Cache {
  std::vector<body::ShapePtr> shapes;
  solver::System system;
  solver::Newton newton;
  adapt::RelocationCache relocation;
  std::map<std::string, double> seconds;         ///< wall time by room
  double cpu_s = 0.0;                            ///< processor time that went into it before the run
};

/// Reads geometry, finds names, meshes, checks. Throws base::InputError with located lines. `cache`: takes the equations
/// that were set up to be looked at; a run that is given it goes on with them.
Problem prepare(const scene::Scene& scene, Cache* cache = nullptr);

/// Finite strain or a material with history: not condensed once, but linearised in every iteration.
bool is_nonlinear(const body::BodyInput& input);

/// The state before the first step.
State initial_state(const Problem& problem);

/// The system of equations on the state's shapes; unchanged bodies keep their operators. What it returned before is
/// gone where a shape has changed.
const solver::System& system_of(const Problem& problem, const State& state, Cache& cache);

}  // namespace reye::sim
