#include "solver/solid/solid_iterate.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

#include "solver/solid/carry_along.hpp"

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

}  // namespace

SolidIterate::SolidIterate(const SolidSystem& system, const SolidState& old, const SolidTarget& target,
                           SolidStart start)
    : system_(system),
      old_(old),
      target_(target),
      now_(old),
      keep_shear_(start == SolidStart::settled),
      stick_all_(start == SolidStart::sticking) {
  standing_.old_poses = poses_of(system, old);
  standing_.x_old = places_of(system, old.u);
  drive();
  integrate();
  seed();
}

/// What is driven moves at once, and carries along what sticks to it; the rest follows by Newton.
void SolidIterate::drive() {
  now_.s = target_.s;
  pairs_.resize(system_.contacts.size());
  stand();
  now_.u = carried_displacements(system_, old_, now_.s, standing_);
  if (system_.turns() && system_.free() > 0 && touched(old_)) {
    std::vector<contact::SkinPlace> places;
    for (std::size_t c = 0; c < system_.contacts.size(); ++c)
      places.push_back(contact::place_skins(system_.contacts[c], old_.u, system_.held, system_.points(), pairs_[c]));
    now_.a = carried_along_motions(system_, old_, target_, standing_.poses, now_.u, places);
    stand();
    now_.u = carried_displacements(system_, old_, now_.s, standing_);
  }
  now_.traction = carried_tractions(system_, old_, standing_);
}

void SolidIterate::stand() {
  standing_.poses = poses_between(system_, old_, now_.a, now_.s);
  standing_.twist = relative_twists(system_, standing_.old_poses, standing_.poses);
}

void SolidIterate::integrate() {
  const Account account(mortar_s);
  const auto before = std::move(place_);
  place_.clear();
  for (std::size_t c = 0; c < system_.contacts.size(); ++c)
    place_.push_back(contact::place_skins(system_.contacts[c], now_.u, system_.held, system_.points(), pairs_[c]));
  for (std::size_t c = 0; c < place_.size(); ++c)
    for (int j = 0; j < place_[c].count(); ++j) {
      Vec3& z = now_.traction[c][j];
      const auto& frame = place_[c].frame[j];
      const auto& known = before.empty() ? frame : before[c].frame[j];  // pressure stays pressure as normals turn
      if (!place_[c].carries[j])
        z.setZero();
      else if (target_.friction[c] == 0.0)
        z = z.dot(known.normal) * frame.normal;
      else
        z = z.dot(known.normal) * frame.normal + frame.across(known.across(z));
    }
  evaluate();
}

void SolidIterate::evaluate() {
  force_ = contact_forces(system_, place_, now_.traction);
  stand();
  now_.u = displacement(system_, motion());
  standing_.x = places_of(system_, now_.u);
  const Vector moved = now_.u - old_.u;
  nodes_.resize(place_.size());
  for (std::size_t c = 0; c < place_.size(); ++c) {
    const auto& place = place_[c];
    const bool turns = !standing_.twist[c].empty();
    const Points3 w = contact::relative(place, standing_.x),
                  slip = contact::relative(place, turns ? seen_motion(system_, standing_, c) : moved);
    nodes_[c].resize(w.size());
    for (std::size_t j = 0; j < w.size(); ++j) {
      const auto& frame = place.frame[j];
      nodes_[c][j] = {now_.traction[c][j], -frame.normal.dot(w[j]), frame.across(slip[j] + target_.slip[c][j])};
    }
  }
}

/// Where a body is free to move and touches nothing, the points nearest to the other side begin in contact.
void SolidIterate::seed() {
  if (system_.unheld == 0) return;
  for (std::size_t c = 0; c < place_.size(); ++c) {
    const auto& place = place_[c];
    const Points3 w = contact::relative(place, standing_.x_old);
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
  if (!place.carries[j] || !contact::closed(node, place.frame[j], stiffness)) return Status::open;
  if (stick_all_ || friction(c) == 0.0) return Status::stick;
  const Status status = contact::tangential_status(node, place.frame[j], friction(c), stiffness);
  // Slip that turns back sticks first: beyond the far side of the cone it would jump to and fro. A body that turns far
  // back, more than elasticity can take, slips on at once: its direction is beyond doubt.
  constexpr double far = 100.0;
  const Vec3 y = contact::trial(node, place.frame[j], stiffness);
  const double most = far * friction(c) * std::max(0.0, contact::pressure(node, place.frame[j]));
  const bool beyond = !standing_.twist[c].empty() && y.norm() > most;
  const bool back = now_.status[c][j] == Status::slip && !beyond && y.dot(contact::shear(node, place.frame[j])) < 0.0;
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

bool SolidIterate::classify() {
  bool changed = false;
  std::vector<std::vector<Status>> fresh = now_.status;
  int closed = 0;
  for (std::size_t c = 0; c < place_.size(); ++c)
    for (int j = 0; j < place_[c].count(); ++j) {
      fresh[c][j] = decide(static_cast<int>(c), j);
      closed += fresh[c][j] != Status::open;
    }
  if (closed == 0 && system_.unheld > 0) {
    ++came_apart_;
    now_.status = fresh;
    seed();
    fresh = now_.status;
    changed = true;
  }
  stick_all_ = false;
  changed = changed || fresh != now_.status;
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
  const double forces = force_scale(system_, motion());
  const Vector left = motion_scale(system_).cwiseProduct(imbalance(system_, motion()));
  if (left.size() > 0) error.balance = left.lpNorm<Eigen::Infinity>() / std::max(forces, 1e-300);
  return error;
}

void SolidIterate::add_rows(int c, int j, std::vector<ReducedRow>& rows) const {
  const auto& frame = place_[c].frame[j];
  const auto& node = nodes_[c][j];
  const double stiffness = system_.contacts[c].stiffness[j], mu = friction(c);
  const bool slips = now_.status[c][j] == Status::slip;
  const auto slip = slips ? contact::slip_step(node, frame, mu, stiffness) : contact::SlipStep{};
  const bool pressed = node.traction.dot(frame.normal) > 0.0;
  rows.push_back({c, j, frame.normal, stiffness * frame.normal, 0.0, -stiffness * node.gap});
  if (slips && (pressed || mu > 0.0)) rows.back().along += mu * slip.d;
  if (slips && frame.free == 2)
    rows.push_back({c, j, slip.e, -slip.share * stiffness * slip.e, 1.0 - slip.share, node.traction.dot(slip.e), true});
  if (!slips && mu > 0.0)
    for (int k = 0; k < frame.free; ++k)
      rows.push_back({c, j, frame.tangent[k], stiffness * frame.tangent[k], 0.0,
                      stiffness * frame.tangent[k].dot(node.slip), true});
}

std::vector<ReducedRow> SolidIterate::rows() const {
  std::vector<ReducedRow> rows;
  for (std::size_t c = 0; c < place_.size(); ++c)
    for (int j = 0; j < place_[c].count(); ++j)
      if (now_.status[c][j] != Status::open) add_rows(static_cast<int>(c), j, rows);
  return rows;
}

/// No step may carry the sides past each other: at most a quarter of the reach of the search.
double SolidIterate::step_share(const std::vector<ReducedRow>& rows, const ReducedStep& step,
                                const TurningTangent& tangent) const {
  std::vector<Points3> change;
  for (const auto& traction : now_.traction) change.emplace_back(traction.size(), Vec3::Zero());
  for (std::size_t k = 0; k < rows.size(); ++k) change[rows[k].contact][rows[k].point] += step.z[k] * rows[k].along;
  const Vector moved = change_of_places(system_, standing_, contact_forces(system_, place_, change), step.a, tangent);
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

void SolidIterate::apply(const std::vector<ReducedRow>& rows, const ReducedStep& step, double share) {
  for (std::size_t k = 0; k < rows.size(); ++k)
    now_.traction[rows[k].contact][rows[k].point] += share * step.z[k] * rows[k].along;
  now_.a += share * step.a;
  evaluate();
}

void SolidIterate::step() {
  const Account account(interface_s);
  const auto rows = this->rows();
  const auto tangent = turning_tangent(system_, standing_, force_, now_.s, now_.a - old_.a);
  const Vector left = imbalance(system_, motion());
  const ReducedStep step =
      solve_reduced(system_, {place_, standing_, tangent, left, force_scale(system_, motion())}, rows);
  apply(rows, step, step_share(rows, step, tangent));
}

void SolidIterate::let_shear_go() { keep_shear_ = false; }

SolidSolution SolidIterate::take() {
  SolidSolution solution;
  solution.converged = true;
  for (std::size_t b = 0; b < system_.bodies.size(); ++b)
    if (system_.turning[b])
      now_.turn[b] = body::turned(*system_.turning[b], old_.turn[b], system_.of_free(now_.a - old_.a, b));
  solution.state = std::move(now_);
  solution.place = std::move(place_);
  solution.nodes = std::move(nodes_);
  return solution;
}

}  // namespace reye::solver
