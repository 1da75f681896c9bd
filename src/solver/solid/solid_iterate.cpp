#include "solver/solid/solid_iterate.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "solver/solid/carry_along.hpp"
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
  standing_.old_poses = poses_of(system, old);
  standing_.x_old = positions(system, old.u);
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
  for (std::size_t c = 0; c < system_.contacts.size(); ++c) {
    const auto& setup = system_.contacts[c];
    const auto fresh =
        before.empty() ? std::vector<char>() : near_facets(setup, before[c], now_.status[c], whole_[c], now_.u);
    place_.push_back(contact::place_skins(setup, now_.u, system_.held, system_.points(), pairs_[c], fresh));
  }
  for (std::size_t c = 0; c < place_.size(); ++c) turn_tractions(c, before.empty() ? place_[c].frame : before[c].frame);
  worn_.assign(place_.size(), {});
  for (std::size_t c = 0; c < place_.size(); ++c)
    if (system_.contacts[c].options.wear.wears())
      worn_[c] = worn_contact(system_.contacts[c], place_[c], old_.wear[c], target_.wear[c]);
  evaluate();
  if (before.empty()) keep_whole();
}

void SolidIterate::keep_whole() {
  for (const auto& of_contact : nodes_) {
    auto& whole = whole_.emplace_back(WholeIntegrals{now_.u, {}});
    for (const auto& node : of_contact) whole.gap.push_back(node.gap);
  }
}

/// Pressure stays pressure as normals turn, and tangents turn with them.
void SolidIterate::turn_tractions(std::size_t c, const std::vector<contact::SkinFrame>& before) {
  for (int j = 0; j < place_[c].count(); ++j) {
    Vec3& z = now_.traction[c][j];
    auto& frame = place_[c].frame[j];
    const auto& known = before[j];
    frame = contact::turned_least(frame, known);
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
  stand();
  now_.u = displacement(system_, motion());
  standing_.x = positions(system_, now_.u);
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
      // Without friction the halves beside a plane of symmetry may slide across it alike.
      const Vec3& imposed = target_.slip[c][j];
      const Vec3 slid = target_.friction[c] > 0.0 ? frame.across(imposed) : frame.tangential(imposed);
      nodes_[c][j] = {now_.traction[c][j], -frame.normal.dot(w[j]), frame.across(slip[j]) + slid, 0.0};
      if (worn_[c].opened_before.size() > 0) nodes_[c][j].gap += worn_[c].opened_before[static_cast<Eigen::Index>(j)];
    }
  }
  wear();
}

/// Wear of the increment; none while shear is kept, for then nothing slides.
void SolidIterate::wear() {
  for (std::size_t c = 0; c < place_.size(); ++c) {
    if (!target_.wear[c].on || keep_shear_) continue;
    std::vector<char> slides;
    for (const Status status : now_.status[c]) slides.push_back(contact::slides(status, target_.friction[c]));
    wear_points(system_.contacts[c], place_[c], old_.wear[c], target_.wear[c], slides, nodes_[c], worn_[c]);
  }
}

bool SolidIterate::wears() const {
  return std::any_of(target_.wear.begin(), target_.wear.end(), [](const auto& wearing) { return wearing.on; });
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

std::vector<ReducedRow> SolidIterate::rows() const {
  std::vector<ReducedRow> rows;
  for (std::size_t c = 0; c < place_.size(); ++c)
    for (const int j : system_.contacts[c].order)
      if (now_.status[c][j] != Status::open)
        add_rows({static_cast<int>(c), j, system_.contacts[c].stiffness[j], friction(static_cast<int>(c))},
                 place_[c].frame[j], nodes_[c][j], now_.status[c][j], rows);
  return rows;
}

std::vector<WearRow> SolidIterate::wear_rows(const std::vector<ReducedRow>& rows) const {
  std::vector<WearRow> wear;
  if (keep_shear_ || !wears()) return wear;
  std::vector<std::vector<int>> normal_row;
  for (const auto& place : place_) normal_row.emplace_back(place.frame.size(), -1);
  for (int k = static_cast<int>(rows.size()) - 1; k >= 0; --k)  // of a point's rows the first is that of its gap
    normal_row[rows[k].contact][rows[k].point] = k;
  for (std::size_t c = 0; c < place_.size(); ++c)
    if (target_.wear[c].on) add_wear_rows(system_.contacts[c], worn_[c], static_cast<int>(c), normal_row[c], wear);
  return wear;
}

/// The change of displacements that a step brings, of turns to first order.
Vector SolidIterate::moved_by(const std::vector<ReducedRow>& rows, const ReducedStep& step) const {
  std::vector<Points3> change;
  for (const auto& traction : now_.traction) change.emplace_back(traction.size(), Vec3::Zero());
  for (std::size_t k = 0; k < rows.size(); ++k) change[rows[k].contact][rows[k].point] += step.z[k] * rows[k].along;
  return change_of_places(system_, standing_, contact_forces(system_, place_, change), step.a, tangent_);
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
  if (!same_matrix || system_.turns() || reduced_.count() != rows.size()) {
    tangent_ = turning_tangent(system_, standing_, force_, now_.s, now_.a - old_.a);
    reduced_.factor(system_, {place_, standing_, tangent_}, rows, wear_rows(rows));
  }
  apply(rows);
  if (!near) return;
  turn_normals();
  apply(this->rows());
}

void SolidIterate::apply(const std::vector<ReducedRow>& rows) {
  const ReducedStep step = reduced_.solve(rows, imbalance(system_, motion()), force_scale(system_, motion()));
  const Vector moved = moved_by(rows, step);
  const double share = step_share(moved);
  for (std::size_t k = 0; k < rows.size(); ++k)
    now_.traction[rows[k].contact][rows[k].point] += share * step.z[k] * rows[k].along;
  now_.a += share * step.a;
  if (!system_.turns()) {  // displacements are linear in the step
    now_.u += share * moved;
    return;
  }
  force_ = contact_forces(system_, place_, now_.traction);
  stand();
  now_.u = displacement(system_, motion());
}

void SolidIterate::let_shear_go() {
  keep_shear_ = false;
  stick_all_ = as_before_ = true;
}

void SolidIterate::finish() {
  const Account account(interface_s);
  const auto rows = this->rows();
  if (rows.empty() || reduced_.count() != rows.size()) return;
  apply(rows);
  evaluate();
}

SolidSolution SolidIterate::take() {
  for (std::size_t c = 0; c < place_.size(); ++c) {
    const auto& openings = worn_[c].openings;
    contact::book(system_.contacts[c], place_[c], openings, nodes_[c], now_.status[c], worn_[c].worn, target_.wear[c],
                  now_.wear[c]);
  }
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
