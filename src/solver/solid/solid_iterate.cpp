#include "solver/solid/solid_iterate.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

#include "solver/solid/most_due.hpp"
#include "solver/solid/point_rows.hpp"

namespace reye::solver {

namespace {

double cpu_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Adds the CPU time of a scope to an account.
class Account {
 public:
  explicit Account(double& seconds) : seconds_(seconds), start_(cpu_now()) {}
  ~Account() { seconds_ += cpu_now() - start_; }
  Account(const Account&) = delete;
  Account& operator=(const Account&) = delete;

 private:
  double& seconds_;
  double start_;
};

/// -Q^T z of all contacts.
Vector contact_forces(const SolidSystem& system, const std::vector<contact::SkinPlace>& places,
                      const std::vector<Points3>& traction) {
  Vector force = Vector::Zero(3 * system.points());
  for (std::size_t c = 0; c < places.size(); ++c) add_contact_forces(places[c], traction[c], force);
  return force;
}

/// Positions of all points.
Vector positions(const SolidSystem& system, const Vector& u) {
  Vector x = u;
  std::vector<char> done(static_cast<std::size_t>(system.points()), 0);
  for (const auto& contact : system.contacts)
    for (const auto* side : {&contact.secondary, &contact.primary})
      for (std::size_t i = 0; i < side->points.size(); ++i) {
        const int column = side->points[i].column;
        if (done[column]++) continue;
        x.segment<3>(3 * column) += side->skin.x[i];
      }
  return x;
}

}  // namespace

SolidIterate::SolidIterate(const SolidSystem& system, const SolidState& old, const SolidTarget& target,
                           SolidStart start)
    : system_(system),
      old_(old),
      target_(target),
      now_(old),
      keep_shear_(start == SolidStart::settled),
      stick_all_(start == SolidStart::sticking),
      as_before_(start == SolidStart::natural && touched(old)) {
  now_.s = target.s;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {  // what is driven moves at once, the rest follows by Newton
    const auto& U = system.bodies[b].U();
    now_.u.segment(3 * system.first_point[b], U.rows()) +=
        U * (target.s - old.s).segment(system.first_driven[b], U.cols());
  }
  integrate();
  seed();
}

void SolidIterate::integrate() {
  const Account account(mortar_s);
  const auto before = std::move(place_);
  place_.clear();
  pairs_.resize(system_.contacts.size());
  for (std::size_t c = 0; c < system_.contacts.size(); ++c)
    place_.push_back(contact::place_skins(system_.contacts[c], now_.u, system_.held, system_.points(), pairs_[c]));
  for (std::size_t c = 0; c < place_.size(); ++c) turn_tractions(c, before.empty() ? place_[c].frame : before[c].frame);
  evaluate();
}

/// Pressure stays pressure as normals turn.
void SolidIterate::turn_tractions(std::size_t c, const std::vector<contact::SkinFrame>& before) {
  for (int j = 0; j < place_[c].count(); ++j) {
    Vec3& z = now_.traction[c][j];
    const auto &frame = place_[c].frame[j], &known = before[j];
    if (!place_[c].carries[j])
      z.setZero();
    else if (target_.friction[c] == 0.0)
      z = z.dot(known.normal) * frame.normal;
    else
      z = z.dot(known.normal) * frame.normal + frame.across(known.across(z));
  }
}

void SolidIterate::turn_normals() {
  for (std::size_t c = 0; c < place_.size(); ++c) {
    const auto before = place_[c].frame;
    contact::turn_frames(system_.contacts[c], now_.u, system_.held, place_[c]);
    turn_tractions(c, before);
  }
  evaluate();
}

void SolidIterate::evaluate() {
  force_ = contact_forces(system_, place_, now_.traction);
  now_.u = displacement(system_, force_, now_.s, now_.a);
  const Vector x = positions(system_, now_.u), moved = now_.u - old_.u;
  nodes_.resize(place_.size());
  for (std::size_t c = 0; c < place_.size(); ++c) {
    const auto& place = place_[c];
    const Points3 w = contact::relative(place, x), slip = contact::relative(place, moved);
    nodes_[c].resize(w.size());
    for (std::size_t j = 0; j < w.size(); ++j) {
      const auto& frame = place.frame[j];
      nodes_[c][j] = {now_.traction[c][j], -frame.normal.dot(w[j]), frame.across(slip[j] + target_.slip[c][j])};
    }
  }
}

/// Where a body is free to move and touches nothing, the points nearest to the other side begin in contact.
void SolidIterate::seed() {
  if (system_.free() == 0) return;
  for (std::size_t c = 0; c < place_.size(); ++c) {
    const auto& place = place_[c];
    const Points3 w = contact::relative(place, positions(system_, old_.u));
    const auto gap = [&](int j) { return -place.frame[j].normal.dot(w[j]); };
    double least = std::numeric_limits<double>::infinity();
    bool closed = false;
    for (int j = 0; j < place.count(); ++j) {
      if (!place.carries[j]) continue;
      least = std::min(least, gap(j));
      closed = closed || now_.status[c][j] != Status::open;
    }
    if (closed) continue;
    for (int j = 0; j < place.count(); ++j) {
      const double size = std::sqrt(place.area[j]);
      if (place.carries[j] && gap(j) <= least + 0.02 * size) now_.status[c][j] = Status::stick;
    }
  }
}

SolidIterate::Status SolidIterate::decide(int c, int j) const {
  const auto& place = place_[c];
  const auto& node = nodes_[c][j];
  const double stiffness = system_.contacts[c].stiffness[j];
  const bool closed = as_before_ ? now_.status[c][j] != Status::open : contact::closed(node, place.frame[j], stiffness);
  if (!place.carries[j] || !closed) return Status::open;
  if (stick_all_ || friction(c) == 0.0) return Status::stick;
  const Status status = contact::tangential_status(node, place.frame[j], friction(c), stiffness);
  // Slip that turns back sticks first: beyond the far side of the cone it would jump to and fro. Where the pressure has
  // become a pull, as of a point that is about to open, the shear points against the slip and says nothing.
  const bool back = now_.status[c][j] == Status::slip && contact::pressure(node, place.frame[j]) > 0.0 &&
                    contact::trial(node, place.frame[j], stiffness).dot(contact::shear(node, place.frame[j])) < 0.0;
  return back ? Status::stick : status;
}

bool SolidIterate::project() {
  bool any = false;
  for (std::size_t c = 0; c < place_.size(); ++c)
    for (int j = 0; j < place_[c].count(); ++j) {
      Vec3& z = now_.traction[c][j];
      const auto& frame = place_[c].frame[j];
      const Vec3 before = z;
      if (now_.status[c][j] == Status::open) z.setZero();
      if (now_.status[c][j] == Status::slip) {
        const double mu = friction(static_cast<int>(c));
        const auto slip = contact::slip_step(nodes_[c][j], frame, mu, system_.contacts[c].stiffness[j]);
        const double p = z.dot(frame.normal);
        const Vec3 across = frame.free == 2 ? Vec3(frame.across(z).dot(slip.e) * slip.e) : Vec3(Vec3::Zero());
        z = p * frame.normal + mu * std::max(0.0, p) * slip.d + across;
      }
      any = any || z != before;
    }
  return any;
}

std::vector<double> SolidIterate::present_friction() const {
  std::vector<double> mu;
  for (std::size_t c = 0; c < place_.size(); ++c) mu.push_back(friction(static_cast<int>(c)));
  return mu;
}

bool SolidIterate::classify(bool with_care) {
  bool changed = false;
  std::vector<std::vector<Status>> fresh = now_.status;
  int closed = 0;
  for (std::size_t c = 0; c < place_.size(); ++c)
    for (int j = 0; j < place_[c].count(); ++j) {
      fresh[c][j] = decide(static_cast<int>(c), j);
      closed += fresh[c][j] != Status::open;
    }
  if (closed == 0 && system_.free() > 0) {
    ++came_apart_;
    now_.status = fresh;
    seed();
    fresh = now_.status;
    changed = true;
  }
  stick_all_ = as_before_ = false;
  changed = changed || fresh != now_.status;
  if (with_care) keep_the_most_due(system_, place_, nodes_, present_friction(), now_.status, fresh);
  now_.status = std::move(fresh);
  if (project()) evaluate();
  return changed;
}

SolidIterate::Error SolidIterate::error() const {
  Error error;
  for (std::size_t c = 0; c < place_.size(); ++c)
    for (int j = 0; j < place_[c].count(); ++j) {
      if (!place_[c].carries[j]) continue;
      const auto& node = nodes_[c][j];
      error.largest_MPa = std::max(error.largest_MPa, node.traction.norm());
      error.traction_MPa = std::max(
          error.traction_MPa, contact::violation(node, place_[c].frame[j], now_.status[c][j],
                                                 friction(static_cast<int>(c)), system_.contacts[c].stiffness[j]));
    }
  const double forces = force_.lpNorm<1>();
  const Vector left = imbalance(system_, force_, now_.s);
  if (left.size() > 0) error.balance = left.lpNorm<Eigen::Infinity>() / std::max(forces, 1e-300);
  return error;
}

std::vector<ReducedRow> SolidIterate::rows() const {
  std::vector<ReducedRow> rows;
  for (std::size_t c = 0; c < place_.size(); ++c)
    for (const int j : system_.contacts[c].order)
      if (now_.status[c][j] != Status::open)
        add_rows({static_cast<int>(c), j, system_.contacts[c].stiffness[j], friction(static_cast<int>(c))},
                 place_[c].frame[j], nodes_[c][j], now_.status[c][j], rows);
  return rows;
}

/// The change of displacements that a step brings.
Vector SolidIterate::moved_by(const std::vector<ReducedRow>& rows, const ReducedStep& step) const {
  std::vector<Points3> change;
  for (const auto& traction : now_.traction) change.emplace_back(traction.size(), Vec3::Zero());
  for (std::size_t k = 0; k < rows.size(); ++k) change[rows[k].contact][rows[k].point] += step.z[k] * rows[k].along;
  return displacement(system_, contact_forces(system_, place_, change), Vector::Zero(system_.driven()), step.a);
}

/// No step may carry the sides past each other: at most a quarter of the reach of the search.
double SolidIterate::step_share(const Vector& moved) const {
  double share = 1.0;
  for (std::size_t c = 0; c < place_.size(); ++c) {
    const Points3 w = contact::relative(place_[c], moved);
    for (const Vec3& change_of_w : w) {
      const double way = change_of_w.norm(), most = 0.25 * system_.contacts[c].search;
      if (way > most) share = std::min(share, most / way);
    }
  }
  return share;
}

void SolidIterate::step(bool same_matrix, bool near) {
  const Account account(interface_s);
  const auto rows = this->rows();
  if (!same_matrix || reduced_.count() != rows.size()) reduced_.factor(system_, place_, rows);
  apply(rows);
  if (!near) return;
  turn_normals();
  apply(this->rows());
}

void SolidIterate::apply(const std::vector<ReducedRow>& rows) {
  const ReducedStep step = reduced_.solve(rows, imbalance(system_, force_, now_.s));
  const Vector moved = moved_by(rows, step);
  const double share = step_share(moved);
  for (std::size_t k = 0; k < rows.size(); ++k)
    now_.traction[rows[k].contact][rows[k].point] += share * step.z[k] * rows[k].along;
  now_.a += share * step.a;
  now_.u += share * moved;
}

void SolidIterate::let_shear_go() {
  keep_shear_ = false;
  stick_all_ = true;
}

void SolidIterate::finish() {
  const Account account(interface_s);
  const auto rows = this->rows();
  if (rows.empty() || reduced_.count() != rows.size()) return;
  apply(rows);
  evaluate();
}

SolidSolution SolidIterate::take() {
  SolidSolution solution;
  solution.converged = true;
  solution.state = std::move(now_);
  solution.place = std::move(place_);
  solution.nodes = std::move(nodes_);
  return solution;
}

}  // namespace reye::solver
