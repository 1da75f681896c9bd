#pragma once
#include <optional>
#include <span>
#include <vector>

#include "contact/complementarity.hpp"
#include "contact/setup.hpp"
#include "contact/state.hpp"
#include "mortar/integrate.hpp"

namespace reye::contact {

/// Data of one increment for a contact, constant through its Newton iterations.
struct IncrementOptions {
  double jump = 1.0;  ///< cycles that this increment stands for
  bool wear = true;
  double duration_s = 0.0;         ///< of one play of this increment; read where wear has a speed exponent only
  std::optional<double> friction;  ///< mu in this increment; empty: that of the contact
  double imposed_slip = 0.0;  ///< mm in this increment, where sliding is imposed; its sign is the direction of friction
  double first_way = 1.0;     ///< that direction, 1 or -1, where nothing slides in this increment and no shear gives it
  double inset = 0.0;         ///< distance of the primary side inside its body: the rest of a drawn overlap [mm]
  double cycle = 0.0;         ///< cycles before the block; read by formulas alone
  double imposed_turn = 0.0;  ///< rad in this increment, where sliding is imposed as a turn about the axis
  bool held = false;          ///< shear given by `held_shear`, no slip, no wear: re-equilibration
  std::vector<double> held_shear;
  std::vector<double> held_pressure;
  /// With `held` alone [mm/MPa]: 0, or the gap of a node that had pressure opens by this times the deficit of pressure
  /// against `held_pressure`.
  double compliance = 0.0;
  int anchor = -1;  ///< where nothing but friction holds a body along the contact: the node that sticks;
                    ///< what it takes beyond its held shear all nodes share in proportion to held_pressure
  /// Per node: opening of the present gap by a worn layer of one unit on X (1 / |F^-T N| of theory's w = W / |F^-T N|);
  /// empty: one everywhere. It scales depth in the gap, never volume.
  std::vector<double> thickness_secondary, thickness_primary;
  /// Per node, of a boundary on which other contacts wear, too: volume that they have removed and that waits in the
  /// gap, and frictional work that they have done there; empty: none. It opens this gap and counts towards the
  /// threshold, but stays in their ledger.
  std::vector<double> waiting_secondary, waiting_primary, energy_elsewhere;
};

/// Start of Newton in an increment. sticking: active nodes stay active and stick. sheared: they keep their shear, so
/// that they slide wherever they are driven, and are judged by that motion. predicted: a state to be judged at once.
/// continued: as predicted, but active nodes stay active for their pressure alone. On the straight line that continues
/// a slide round a curve they leave the other side by more than their pressure closes.
enum class Start { sticking, sheared, predicted, continued };

constexpr bool is_predicted(Start from) { return from == Start::predicted || from == Start::continued; }

/// Motions of a contact's nodes in one increment as supports restrict or impose them.
struct Mobility {
  double turn = 0.0;                       ///< angle by which supports turn one side against the other [rad]
  std::vector<char> secondary;             ///< per node: held along one direction, which nothing but its support moves
  std::vector<body::NodeFreedom> primary;  ///< per node: the directions in which forces move it
};

/// The thickness factor of a node.
inline double thickness(const std::vector<double>& factors, int node) { return factors.empty() ? 1.0 : factors[node]; }

/// The contribution of other contacts at a node.
inline double elsewhere(const std::vector<double>& values, std::size_t node) {
  return values.empty() ? 0.0 : values[node];
}

/// An entry of a sparse derivative; columns: surface dofs first, then 2 * secondary node + component of lambda.
struct Entry {
  int row = 0, col = 0;
  double value = 0.0;
};

/// What the mortar integrals give each node of the secondary side in one place.
struct Integrals {
  std::vector<MortarRow> rows;
  std::vector<std::vector<std::pair<int, double>>> cover;  ///< T_jl: its parts in the cover of primary nodes
  std::vector<double> spread;                              ///< sum_l T_jl
  std::vector<double> gap, worn_gap;                       ///< weighted: without wear; what earlier wear has opened
  std::vector<Vec2> offset, drift, normal;
};

/// What a contact has decided for each node.
struct Decision {
  std::vector<ContactStatus> status;
  std::vector<double> sign;   ///< of friction, on a slip node
  std::vector<char> unmoved;  ///< it keeps its shear: both sides are held along the surface and nothing slides, or the
                              ///< start is `sheared`
};

/// Depths of worn layers in the gap, per node of each side.
struct Depths {
  std::vector<double> secondary, primary;
};

/// What the linearisation of a contact contains: all of its derivatives, or those at integrals D, M and normals that
/// are held, in which a node moves against the other side as the points that it weighs do. Near a solution these leave
/// some hundredth of a step's error, at a fraction of the work.
enum class Derivatives { all, held_integrals };

/// The equations of one contact linearised about (x, lambda).
struct Linearised {
  std::vector<Entry> force;  ///< d(contact force)/dx, row and column surface dofs
  std::vector<Entry> rows;   ///< d(conditions), row 2 * node (normal) and 2 * node + 1 (tangential)
};

/// One contact between two Newton iterations: integrals, decision, conditions and their linearisation.
/// Holds work space only; everything is recomputed by `integrate`.
class Interface {
 public:
  // Compiled once: every file that holds one would else compile them.
  Interface();
  Interface(const Interface&);
  Interface(Interface&&) noexcept;
  Interface& operator=(const Interface&);
  Interface& operator=(Interface&&) noexcept;
  ~Interface();

  /// Fixes the start of an increment: setup, accepted state, positions then.
  void begin(const Setup& setup, const ContactState& before, Points xs, Points xm, const IncrementOptions& options);

  /// Sets which nodes no force moves along the surface in this increment, and how far the sides are turned.
  void hold(Mobility mobility) { mobility_ = std::move(mobility); }

  /// Begins with the expected conditions; slip points as these multipliers drag.
  void expect(const std::vector<ContactStatus>& status, const std::vector<Vec2>& lambda);

  /// Limits the integrals to the facets between marked nodes; empty marks: all. A bond keeps all its facets.
  void limit_to(std::vector<char> secondary, std::vector<char> primary) {
    if (setup_->options.bonded) return;
    placement_.secondary_near = std::move(secondary);
    placement_.primary_near = std::move(primary);
  }

  /// Mortar integrals at the current positions.
  void integrate(const Points& xs, const Points& xm);

  /// Leaves nodes of the secondary to another contact that meets them, like slivers: the nodes beside them carry their
  /// share. Integrals over `facets` are left out.
  void leave(const std::vector<int>& nodes, const std::vector<int>& facets);

  /// Active set from (lambda, gap, slip); wear of this increment stays out of the decision.  [README, Decision]
  /// In iteration 0 the start decides.
  void decide(const std::vector<Vec2>& lambda, int iteration, Start from = Start::sticking);
  /// Whether the last decision took a node out of contact.
  bool opened(int node) const { return !active(node) && last_.status[node] != ContactStatus::inactive; }
  /// Reverts the last decision on a node.
  void keep(int node) {
    decision_.status[node] = last_.status[node];
    decision_.sign[node] = last_.sign[node];
  }

  /// Conditions of all active nodes, this increment's wear included.
  void evaluate(const std::vector<Vec2>& lambda);

  /// Contact forces on the surface dofs: D^T lambda on the secondary, -M^T lambda on the primary side.
  Vector forces(const std::vector<Vec2>& lambda) const;

  void linearise(const std::vector<Vec2>& lambda, Linearised& out, Derivatives derivatives = Derivatives::all);

  /// The state after an accepted increment.
  ContactState accepted(const std::vector<Vec2>& lambda) const;

  /// Takes D and M of the present positions as slip reference.
  void renew_reference(ContactState& state) const { state.reference = at_.rows; }

  bool active(int node) const { return decision_.status[node] != ContactStatus::inactive; }
  const std::vector<ContactStatus>& status() const { return decision_.status; }
  const std::vector<MortarRow>& rows() const { return at_.rows; }
  const std::vector<double>& gap() const { return at_.gap; }  ///< weighted, without wear
  double worn_gap(int node) const { return at_.worn_gap[node]; }
  const std::vector<Vec2>& normal() const { return at_.normal; }
  double residual_normal(int node) const { return condition_[node].normal; }
  double residual_tangential(int node) const { return condition_[node].tangential; }
  const NodeConditions<double>& condition(int node) const { return condition_[node]; }
  const Setup& setup() const { return *setup_; }
  double inset() const { return options_.inset; }
  int dofs() const { return placement_.dofs(); }
  /// Whether the tangential condition of a node is one of tractions, not of slip.
  bool shear_is_given(int node) const {
    if (setup_->options.bonded) return decision_.unmoved[node];
    return options_.held || decision_.status[node] == ContactStatus::slip || decision_.unmoved[node];
  }
  bool touching(int node) const {
    return !left_[node] && at_.rows[node].cover > minimum_cover * setup_->secondary.area[node];
  }
  /// Length on X of a facet of the secondary that is covered.
  double covered(int facet) const;

  static constexpr double minimum_cover = 1e-3;

 private:
  using Eleven = base::Dual<11>;
  struct WearEntry {
    int col = 0;
    double value = 0.0;
  };
  void book(int node, ContactState& next) const;
  void note_friction(ContactState& next) const;
  void place_primary(const Points& xm);
  void integrate_here();
  void integrate_bond(const Points& xs, const Points& xm);
  void evaluate_bond(const std::vector<Vec2>& lambda);
  void linearise_bond(Linearised& out) const;
  mortar::LineFacet carrier(int node) const;
  Vec2 turned_offset(int node) const;
  std::array<Vec2, 2> directions(int node) const;
  NodeConstants constants(int node) const;
  Vec2 motion(int node) const;
  bool uses_drift(int node) const;
  double share(int node, const std::vector<Vec2>& lambda) const;
  double others_wear(int node) const;
  /// The basis of one decision.
  struct Judgement {
    Start from;
    bool unjudged;  ///< the start decides, not the state
    bool stays;     ///< active nodes open for want of pressure alone
    bool spread;    ///< that of neighbours, too
    double c_normal, c_tangential;
    double sliding;  ///< direction of imposed sliding
  };
  /// The decision in the normal direction of a node.
  struct Pressed {
    bool active, was;
    double bound;  ///< pressure that bounds friction
  };
  Pressed decide_normal(int node, const Vec2& lambda, const Judgement& by) const;
  void decide_tangential(int node, const Vec2& lambda, const Pressed& pressed, const Judgement& by);
  void decide_free(int node, const Vec2& lambda, const Pressed& pressed, double c_tangential);
  std::optional<double> support_slip(int node) const;
  double sliding_sign() const;
  double friction_at(int node, double pressure) const;
  void note_place(int node, wear::Start& start) const;
  double shear_before(int node) const;
  /// A node without multiplier whose share slides and wears with the nodes beside it.
  bool goes_with_neighbours(int node) const { return setup_->between(node) || left_[node]; }
  /// Whether one of its facets faces the other side.
  bool meets(int node) const { return record_of_[node][0] >= 0 || record_of_[node][1] >= 0; }
  void sum_rows();
  bool leave_out_slivers();
  void sum_start_of_increment();
  double faces(const mortar::FacetRecord& record) const;
  mortar::NormalStencil stencil(int node) const;
  NodeConditions<Eleven> node_duals(int node, const std::vector<Vec2>& lambda) const;
  bool wear_spreads() const;
  double worn_others(int node) const;
  /// Wear of the primary side by a secondary node: the volume that a primary node loses, of which T is its part of the
  /// node's cover, and the opening of the gap per volume there.
  double primary_volume(int node, double T, double volume) const { return volume * T / at_.spread[node]; }
  double primary_opening(int l) const { return thickness(options_.thickness_primary, l) / setup_->primary.area[l]; }
  double shares_between(int node) const;
  void spread_wear();
  void begin_wear();
  template <class Add>
  void chain(int node, const Eleven& quantity, Add add) const;
  template <class Add>
  void chain_relative(int node, const MortarRow& row, const Vec2& slope, Add add) const;
  template <class Add>
  void chain_normal(int node, double slope_x, double slope_y, Add add) const;
  template <class Add>
  void chain_motion(int node, double slope_x, double slope_y, Add add) const;
  template <class Visit>
  void for_records(int node, Visit visit) const;
  void force_entries(int node, const Vec2& lambda, std::vector<Entry>& out) const;
  void add_up(std::vector<WearEntry>& entries);
  void collect_primary_wear(int node, const Eleven& volume);
  void collect_wear_between(int node, const Eleven& volume);
  void cover_entries(int node, double slope, std::vector<Entry>& out) const;
  void wear_entries(int node, double slope, std::vector<Entry>& out);

  const Setup* setup_ = nullptr;
  const ContactState* before_ = nullptr;
  IncrementOptions options_;
  Mobility mobility_;
  double friction_ = 0.0;
  mortar::Placement placement_;
  Points
      inset_;  ///< per primary node: its displacement into the body by the rest of a drawn overlap; empty without one
  mortar::Integrator integrator_;
  std::vector<mortar::FacetRecord>* records_ = nullptr;
  /// Per node: record of the facet before (its end 1), after (its end 0); of a control point: of its facet, -1.
  std::vector<std::array<int, 2>> record_of_;
  std::vector<char> differentiated_;
  Derivatives derivatives_ = Derivatives::all;  ///< that `linearise` was asked for
  std::vector<char> left_;                      ///< per node: another contact's in this iteration
  Integrals at_;
  Decision decision_, last_;
  Depths start_, depth_;             ///< before this increment's wear, and with it
  std::vector<double> worn_length_;  ///< A_j, and half of it from each control point that wears with j
  std::vector<std::vector<std::pair<int, double>>> between_;  ///< those control points, depth there per volume of j
  std::vector<Vec2> drawn_offset_;                            ///< of a bond, on X; empty until it is integrated
  std::vector<NodeConditions<double>> condition_;
  std::vector<std::vector<WearEntry>> primary_slope_, secondary_slope_;  ///< d(depth of a node)
  std::vector<WearEntry> node_slope_;                                    ///< d(worn_others) of a node, work space
  std::vector<double> column_sum_;                                       ///< of `add_up`, zero between its calls
};

}  // namespace reye::contact
