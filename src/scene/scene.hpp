#pragma once
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "adapt/redraw/remesh.hpp"
#include "adapt/shape/triggers.hpp"
#include "adapt/transfer/gauss_transfer.hpp"
#include "base/analysis.hpp"
#include "body/supports.hpp"
#include "cad/part/options.hpp"
#include "contact/options.hpp"
#include "fem/loads.hpp"
#include "material/material.hpp"

/// The input as plain structs, composed of the option structs of the rooms below.
namespace reye::scene {

/// A table over the progress of a step: [progress, factor], progress increasing from 0 to 1.
using History = std::vector<std::array<double, 2>>;

/// A history from a file, thinned.
struct Measured {
  History corners;
  std::string file;         ///< as the scene writes it
  std::size_t points = 0;   ///< of the file
  double tolerance = 0.0;   ///< largest deviation of the corners' lines from the points, as a share of their range
  double way_lost = 0.0;    ///< share of the way up and down that the points left out made
  double duration_s = 0.0;  ///< 0: the file gives progress
};

struct BodyMaterial {
  std::string material;       ///< empty for a rigid body
  std::optional<bool> b_bar;  ///< default: quads of order 1 in plane strain and axisymmetry
  std::optional<base::Kinematics> kinematics = base::Kinematics::small;  ///< empty: the run chooses
  bool kinematics_given = false;  ///< else small strain that turns out to be too inaccurate ends the run
};

struct Step {
  std::string name;
  std::vector<std::string> play;
  int increments = 1;
  bool wear = true;
  double level = 1.0;           ///< all factors that it plays are multiplied by it: of a spectrum
  double cycles = 0.0;          ///< 0: a load step, which does not count as a cycle
  double jump = 1.0;            ///< cycles per block; of the first one where a tolerance chooses the others
  double jump_tolerance = 0.0;  ///< error that the run chooses its jumps by; 0: fixed
  double jump_most = std::numeric_limits<double>::infinity();  ///< cycles no block may exceed under a tolerance
  double period_s = 0.0;                                       ///< how long one play lasts; 0: not given
};

/// The first cycle at which a depth (or the worn area) is reached.
struct Limit {
  std::string name;
  std::string contact;
  std::string side;  ///< "secondary" | "primary" | "sum"
  std::optional<double> depth_mm;
  std::optional<double> area_mm2;  ///< axisymmetric: volume in mm^3
  bool stop = false;
  std::optional<std::array<double, 2>> wear_factor;  ///< scatter of all wear coefficients, lowest and highest
};

struct Probe {
  std::string name;
  std::string body;
  base::Vec2 at_mm{0.0, 0.0};
};

/// Rules of frames besides the first and last state of each step; 0 and false: rule not active.
struct FrameRules {
  int per_step = 0;  ///< so many in each step that counts cycles, evenly spaced
  double every_cycles = 0.0;
  int every_blocks = 0;      ///< of a step
  int per_decade = 0;        ///< log-spaced: so many per factor of ten in cycles
  bool at_remeshes = false;  ///< at the end of a block in which a body was remeshed
  bool every_increment = false;
  bool last_block = false;  ///< at each increment of the last block of every step
  bool paraview = true;     ///< false: rows of the surface tables alone
};

struct Output {
  FrameRules frames;
  int history_every_blocks = 1;  ///< rows of each so many blocks of a step, of its first and last
  double checkpoint_s = 1.0;     ///< least wall time between checkpoints
  bool estimate_error = false;   ///< of the mesh, by a companion run
  std::vector<Probe> probes;
};

/// When a worn body is remeshed, and how.
struct Remesh {
  bool automatic = true;
  int every_blocks = 0;  ///< 0: only when a trigger asks for it
  adapt::Triggers triggers;
  adapt::RemeshOptions options;
  adapt::GaussTransfer state_transfer = adapt::GaussTransfer::l2;
};

struct Scene {
  // Compiled once: every file that holds one would else compile them.
  Scene();
  Scene(const Scene&);
  Scene(Scene&&) noexcept;
  Scene& operator=(const Scene&);
  Scene& operator=(Scene&&) noexcept;
  ~Scene();

  std::string title;
  base::Analysis analysis = base::Analysis::plane_strain;
  double accuracy = 0.0;          ///< relative, for sizes and jumps left open; 0: none
  cad::GeometryOptions geometry;  ///< files, bodies, boundaries, fine zones; size 0: left to `accuracy`
  std::map<std::string, material::Material> materials;
  std::map<std::string, BodyMaterial> body_material;  ///< by body name
  std::vector<contact::ContactOptions> contacts;
  std::vector<contact::ContactOptions> bonds;  ///< bodies joined permanently: only name and sides count
  std::vector<body::Support> supports;
  std::vector<fem::BoundaryLoad> boundary_loads;
  std::vector<fem::PointLoad> point_loads;
  std::vector<fem::BodyForce> body_forces;
  std::map<std::string, History> histories;
  std::map<std::string, Measured> measured;  ///< those of them that come from files
  std::vector<Step> steps;
  std::vector<Limit> limits;
  Output output;
  Remesh remesh;
  bool shape = true;  ///< false (shape = "off"): wear stays in the gap
  int max_newton = 30;
  int max_cutbacks = 8;

  // Where the scene came from.
  std::string name;  ///< file name without .toml, or the folder's name for scene.toml
  std::string path;
  std::string text;          ///< of the file
  std::string sha256;        ///< over scene, geometry files and profiles
  std::string fixed_sha256;  ///< over these without what may differ when a run resumes (`extension`)
  /// Line of each key as "material.steel.nu"; array tables as "step[0].cycles".
  std::map<std::string, int> lines;
  /// Suspicious values that are not errors, one line each as in an InputError.
  std::vector<std::string> warnings;
};

}  // namespace reye::scene
