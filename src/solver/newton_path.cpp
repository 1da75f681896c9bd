#include "solver/newton_path.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"

namespace reye::solver {

using body::Tangent;
using contact::Start;

namespace {

constexpr int all_at_once = 5;           ///< iterations in which nodes open and close together
constexpr int few_changes = 4;           ///< changes of status in an iteration of an active set that is nearly settled
constexpr int marching = 10;             ///< iterations in a row with so few changes: a moving edge of contact
constexpr double worse = 1.5;            ///< growth of the imbalance at which a start does not fit,
constexpr double far_out = 0.01;         ///< where it exceeds this share of the forces
constexpr int settling = 5;              ///< iterations that follow the last change
constexpr int most_on_one_tangent = 15;  ///< iterations of contact before nonlinear bodies are linearised again
constexpr double same = 0.1;             ///< share of the imbalance within which a renewal has not changed it
constexpr int standing = 3;       ///< such renewals in a row, with contact not settled, after which it never will be
constexpr double beside = 0.3;    ///< share of the imbalance that contact may leave to the next renewal
constexpr double square = 10.0;   ///< factor of the squared imbalance that contact may leave to a new tangent
constexpr double coarse = 1e-3;   ///< residual that contact leaves at most; with more, bad factors c cost cut-backs
constexpr int most_follows = 10;  ///< times in a path that another reach is chosen round the contact that was found
constexpr int most_kept_nearest = 3;  ///< times in a path that a node is kept in contact, of nodes that all open
constexpr double on_kept =
    0.01;  ///< of the tolerances, for a step with a kept tangent: Newton's own step falls far below them
constexpr double on_chord = 0.03;  ///< with a kept exact matrix of linear bodies, whose steps gain a thousand
constexpr double in_form = 0.1;    ///< in compliance form, whose steps gain a hundred
constexpr double little =
    0.1;  ///< share of the error: a step in compliance form that leaves more has gained too little

}  // namespace

NewtonPath::NewtonPath(Increment& increment, const NewtonOptions& options, const System& system,
                       const SolverState& before, const Controls& controls, const Attempt& attempt)
    : increment_(increment),
      options_(options),
      system_(system),
      before_(before),
      controls_(controls),
      attempt_(attempt) {}

SolveResult NewtonPath::follow(bool narrowing) {
  narrowing_ = narrowing;
  try {
    for (ended_ = !begin(); !ended_; ++iteration_, ++since_) iterate();
  } catch (const wear::FormulaError& error) {
    end(Failure::no_law, error.what());
  }
  return std::move(result_);
}

void NewtonPath::end(Failure failure, std::string reason) {
  result_.report.failure = failure;
  result_.report.converged = failure == Failure::none;
  result_.report.reason = std::move(reason);
  ended_ = true;
}

double NewtonPath::error() const {
  return std::max(row_.force / options_.force_tolerance, row_.condition / options_.condition_tolerance);
}

bool NewtonPath::begin() {
  last_ = options_.max_iterations;
  limit_ = most_on_one_tangent;
  exact_ = !attempt_.chords;
  try {
    q_ = increment_.begin(system_, before_, controls_, attempt_.from,
                          attempt_.chords ? Tangent::symmetric_part : Tangent::exact);
  } catch (const base::SolveError& error) {
    end(Failure::torn, error.what());
    return false;
  }
  result_.report.tangents = increment_.nonlinear() ? 1 : 0;
  return true;
}

/// A phase that ends the path gives the reason; a phase that changes the basis of later ones begins another iteration.
void NewtonPath::iterate() {
  increment_.place(system_, q_);
  decide();
  extend();
  if (!finite() || astray() || stands_still()) return;
  judge_compliance();
  chord_ = may_keep_matrix();
  const bool is_met = met();
  if (is_met && fresh()) return accept();
  const bool settled = is_met || settled_enough();
  if (increment_.nonlinear() && (settled || since_ == limit_ || watch_.stuck())) return renew(settled);
  if (iteration_ == last_ || watch_.stuck())
    return end(Failure::no_convergence, increment_.not_found(system_, result_.report.table, options_, watch_.stuck()));
  if (renewed() && !linearise()) return;
  step();
}

/// The active set, and the residual on it.
void NewtonPath::decide() {
  cycling_ = watch_.cycling();
  const Allowed together = stage() < all_at_once ? Allowed::all : Allowed::opening_first;
  const int changes = increment_.decide(stage(), attempt_.from, cycling_ ? Allowed::none : together);
  row_ = increment_.measure(system_, controls_, q_, fresh());
  if (cycling_ && changes > 0 && error() < 1.0) {
    increment_.decide(stage(), attempt_.from, Allowed::one);
    row_ = increment_.measure(system_, controls_, q_, fresh());
  }
  row_.changes = changes;
  if (fresh()) imbalance_ = std::max(row_.force, row_.condition);
  if (fresh()) result_.report.table.push_back(row_);
}

/// An edge of contact may move by a node in each iteration, past all nodes.
void NewtonPath::extend() {
  const auto set = increment_.active_set();
  watch_.add(set);
  few_ = row_.changes > 0 && row_.changes <= few_changes ? few_ + 1 : 0;
  if (!increment_.nonlinear() && few_ >= marching)
    last_ = std::max(last_, std::min(iteration_ + settling, options_.max_iterations + static_cast<int>(set.size())));
  if (watch_.cycling() && !cycling_) limit_ = since_ + most_on_one_tangent;
}

bool NewtonPath::finite() {
  if (std::isfinite(row_.force) && std::isfinite(row_.condition)) return true;
  end(Failure::contact_lost,
      "the residual is not finite after " + std::to_string(iteration_) +
          " iterations: displacements grow without bound, as where a body that contact holds is unsupported");
  return false;
}

/// Whether a predicted start leads nonlinear bodies away from equilibrium.
bool NewtonPath::astray() {
  if (!fresh() || !increment_.nonlinear()) return false;
  if (is_predicted(attempt_.from) && row_.force > std::max(worse * least_, far_out)) {
    end(Failure::astray, "the start that was predicted leads away from balance");
    return true;
  }
  least_ = std::min(least_, row_.force);
  keeps_tangent_ = tangents_.allows(row_.force, 0) && attempt_.chords;
  return false;
}

/// Whether contact finds no consistent status on nonlinear bodies, and renewing the bodies does not change them.
bool NewtonPath::stands_still() {
  if (!renewed()) return false;
  const bool back = !settled_ && std::abs(row_.force - renewed_force_) <= same * renewed_force_;
  still_ = back ? still_ + 1 : 0;
  renewed_force_ = row_.force;
  if (still_ < standing) return false;
  end(Failure::no_convergence, increment_.not_found(system_, result_.report.table, options_, true));
  return true;
}

/// A step in compliance form from the present status that gains too little shows that bodies give way to contact as
/// fast as they touch, by the derivatives that are left out: from then on they are in the matrix.
void NewtonPath::judge_compliance() {
  const double now = error();
  const bool judged = last_matrix_ == StepMatrix::compliance && row_.changes == 0 && iteration_ > 0;
  if (judged && now > 1.0 && now > little * last_error_) exact_ = true;
  last_error_ = now;
}

StepMatrix NewtonPath::next_matrix() {
  if (chord_) return StepMatrix::kept;
  return !exact_ && increment_.complies(system_) ? StepMatrix::compliance : StepMatrix::exact;
}

bool NewtonPath::may_keep_matrix() {
  const bool allowed = attempt_.chords && matrices_.allows(error(), row_.changes);
  const bool with_tangent = renewed() && keeps_tangent_ && row_.changes == 0;  // contact's matrix goes with the tangent
  return allowed || with_tangent;
}

/// The error, in tolerances, below which the equations hold.
double NewtonPath::asked() const {
  if (row_.changes > 0 || on_kept_tangent_) return on_kept;
  if (increment_.nonlinear()) return last_matrix_ == StepMatrix::kept && chord_ ? on_kept : 1.0;
  if (last_matrix_ == StepMatrix::exact || !chord_) return 1.0;
  return increment_.in_compliance() ? in_form : on_chord;
}

/// Whether the equations hold, on an active set that is decided once more: early decisions leave out the wear by
/// neighbours, so that a node it opens would stay in tension. A set that after the search still changes while its own
/// equations hold far below the tolerances changes by round-off, as where nodes rest at the limit of friction: either
/// status is right.
bool NewtonPath::met() {
  if (row_.changes > 0 && stage() < all_at_once) return false;
  if (iteration_ == 0 || !(error() < asked())) return false;
  if (late_) return true;
  if (increment_.decide(options_.max_iterations, attempt_.from, cycling_ ? Allowed::one : Allowed::all) == 0)
    return true;
  late_ = true;
  chord_ = false;
  increment_.measure(system_, controls_, q_, fresh());
  return false;
}

/// Whether more iterations of contact on these linearised bodies would gain nothing: the next renewal removes what they
/// leave together with the error of the linearisation.
bool NewtonPath::settled_enough() const {
  const double share = on_kept_tangent_ ? beside : std::min(beside, square * imbalance_);
  const double left = std::max(row_.force, row_.condition);
  return since_ > 0 && row_.changes == 0 && !cycling_ && left < std::min(share * imbalance_, coarse);
}

/// The state is the answer, unless contact has outrun its reach: then Newton continues round the contact that it has
/// found.
void NewtonPath::accept() {
  if (increment_.accept(system_, q_, result_.state)) {
    std::string passed = increment_.passed_through();
    const Failure failure = passed.empty() ? Failure::none : Failure::passed_through;
    return end(failure, std::move(passed));
  }
  narrowing_ = false;
  matrices_.forget();
  tangents_.forget();  // contact's matrix, which goes with a kept tangent, is of other columns
  last_matrix_ = StepMatrix::exact;
  if (++follows_ > most_follows)
    return end(Failure::no_convergence, increment_.not_found(system_, result_.report.table, options_, true));
  increment_.follow(system_, controls_, q_);
  if (!increment_.nonlinear()) return;
  since_ = -1;                                       // the residual is still that of the bodies
  least_ = std::numeric_limits<double>::infinity();  // what has converged was not yet the whole contact
  watch_ = {};
  late_ = false;
  settled_ = true;
  still_ = 0;
}

/// Contact has settled on the linearised bodies, or cannot: the bodies are moved to the state in which it left them.
void NewtonPath::renew(bool settled) {
  settled_ = settled;
  if (renewals_++ == options_.max_iterations)
    return end(Failure::no_convergence, increment_.not_found(system_, result_.report.table, options_, watch_.stuck()));
  if (auto reason = increment_.renew(q_); !reason.empty()) return end(Failure::torn, std::move(reason));
  watch_ = {};
  matrices_.forget();
  limit_ = most_on_one_tangent;
  iteration_ = 0;
  since_ = -1;
}

/// Renewed bodies get a tangent there, unless the present one still converges fast.
bool NewtonPath::linearise() {
  on_kept_tangent_ = keeps_tangent_;
  if (keeps_tangent_) return true;
  ++result_.report.tangents;
  const auto tangent = attempt_.chords ? Tangent::symmetric_part : Tangent::exact;
  if (auto reason = increment_.linearise(q_, tangent); !reason.empty()) {
    end(Failure::torn, std::move(reason));
    return false;
  }
  increment_.measure(system_, controls_, q_, fresh());
  return true;
}

/// `on_nearest`: all contact has opened, and its nearest node is kept; where one node does not hold the body, either,
/// contact is lost.
void NewtonPath::step(bool on_nearest) {
  const bool narrowed = narrowing_ && !chord_ && increment_.narrow(system_, controls_, q_);
  if (narrowed) {
    increment_.place(system_, q_);
    increment_.measure(system_, controls_, q_, fresh());
  }
  try {
    last_matrix_ = next_matrix();
    result_.report.compliant += last_matrix_ == StepMatrix::compliance;
    const Vector dq = increment_.step(system_, controls_, q_, last_matrix_);
    ++result_.report.solves;
    result_.report.matrices += last_matrix_ != StepMatrix::kept;
    q_ += dq;
    // Far away the rounding of S q hides that nothing is in balance.
    const double way = increment_.way(dq), bound = 1e3 * system_.extent;
    if (!system_.contacts.empty() && !(way < bound))
      return end(Failure::contact_lost,
                 "a body moves by " + std::to_string(way) + " in one iteration: it is unsupported");
    if (narrowed && iteration_ == 0) {  // nodes that the first step closes are judged among all nodes
      increment_.widen(system_, controls_, q_);
      matrices_.forget();
    }
  } catch (const base::SolveError& error) {
    if (increment_.touching() && !on_nearest) return end(Failure::singular, error.what());
    if (on_nearest || kept_nearest_ == most_kept_nearest || !increment_.keep_nearest())
      return end(Failure::contact_lost, "no node is in contact, and a body that only contact holds is unsupported");
    ++kept_nearest_;
    row_ = increment_.measure(system_, controls_, q_, fresh());
    step(true);
  }
}

}  // namespace reye::solver
