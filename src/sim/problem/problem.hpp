#pragma once
#include <optional>
#include <string>
#include <vector>

#include "body/operator.hpp"
#include "contact/setup.hpp"
#include "fem/distortion.hpp"
#include "scene/scene.hpp"
#include "sim/problem/records.hpp"

namespace reye::sim {

/// The gap or overlap of the two sides of a contact on the drawing.
struct DrawnGap {
  double gap_mm = 0.0;      ///< shortest way between them; 0: they touch or overlap
  double overlap_mm = 0.0;  ///< largest depth of a node of one side inside the body of the other; 0: none
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

/// The trial at small strain that decided the kinematics of a body which leaves it to the run.
struct KinematicsChoice {
  fem::Distortion largest;  ///< largest distortion in the trial
  std::string failure;      ///< why it failed; empty when it did not
};

/// The kind of each body and contact, what is skipped and why, as `reye plan` prints it.
struct Plan {
  std::vector<std::string> lines;
  std::vector<std::string> skipped;
};

/// Everything that does not change in a run.
struct Problem {
  // Compiled once: every file that holds one would else compile them.
  Problem();
  Problem(const Problem&);
  Problem(Problem&&) noexcept;
  Problem& operator=(const Problem&);
  Problem& operator=(Problem&&) noexcept;
  ~Problem();

  scene::Scene scene;                   ///< decided: what a user may leave to the run (sizes, kinematics) stands in it
  std::vector<body::BodyInput> inputs;  ///< per body
  std::vector<char> rigid;              ///< per body
  std::vector<std::vector<int>> support_of;  ///< per body: scene support of each of its own supports
  std::vector<int> support_body;             ///< per support of the scene: the body it acts on
  std::vector<PlacedContact> contacts;
  std::vector<PlacedContact> bonds;    ///< in `solver::System` and `State` they come after the contacts
  std::vector<body::ShapePtr> shapes;  ///< at the start
  std::vector<std::optional<KinematicsChoice>> kinematics;  ///< per body; empty where the scene decides it
  Plan plan;
  std::vector<Warning> warnings;  ///< known before the run

  int body_count() const { return static_cast<int>(inputs.size()); }
};

/// Finite strain or a material with history: not condensed once, but linearised in every iteration.
bool is_nonlinear(const body::BodyInput& input);

/// Whether a body has a yield stress.
bool may_yield(const Problem& problem);

/// Whether wear is in the gap when pressures are found: that of every contact is implicit.
bool wear_is_in_gaps(const Problem& problem);

/// Whether the outlines of worn bodies may wait until one shape step serves several blocks: bodies are linear, wear is
/// in the gap when pressures are found, and the scene does not remesh by blocks.
bool outlines_may_wait(const Problem& problem);

/// Largest estimated error of the bodies whose small strain was chosen; empty where there is none.
std::optional<double> chosen_small_error(const Problem& problem);

}  // namespace reye::sim
