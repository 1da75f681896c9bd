#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "solver/solid/most_due.hpp"
#include "solver/solid/solid_iterate.hpp"

/// Which points are open, stick or slip.
namespace reye::solver {

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

/// How far what decides is beyond the limit between two states of a point [MPa].
double SolidIterate::due(int c, int j, Status now, Status fresh) const {
  if (now == fresh || !place_[c].carries[j]) return 0.0;
  if (now == Status::open || fresh == Status::open)
    return std::abs(contact::trial_pressure(nodes_[c][j], place_[c].frame[j], system_.contacts[c].stiffness[j]));
  const auto& node = nodes_[c][j];
  const auto& frame = place_[c].frame[j];
  return std::abs(contact::trial(node, frame, system_.contacts[c].stiffness[j]).norm() -
                  friction(c) * std::max(0.0, contact::pressure(node, frame)));
}

SolidIterate::Status SolidIterate::decide(int c, int j) const {
  const auto& place = place_[c];
  const auto& node = nodes_[c][j];
  const double stiffness = system_.contacts[c].stiffness[j];
  const bool closed =
      as_before_ ? now_.status[c][j] != Status::open : contact::trial_pressure(node, place.frame[j], stiffness) > 0.0;
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

/// Takes back changes that round-off alone asks for, as of points that rest on the cone: both states are theirs.
void SolidIterate::keep_what_rests(std::vector<std::vector<Status>>& fresh) const {
  constexpr double round_off = 1e-12;
  double largest = 0.0;
  for (const auto& of_contact : now_.traction)
    for (const Vec3& z : of_contact) largest = std::max(largest, z.norm());
  for (std::size_t c = 0; c < fresh.size(); ++c)
    for (std::size_t j = 0; j < fresh[c].size(); ++j)
      if (place_[c].carries[j] &&
          due(static_cast<int>(c), static_cast<int>(j), now_.status[c][j], fresh[c][j]) <= round_off * largest)
        fresh[c][j] = now_.status[c][j];
}

/// Takes back the changes that are less due than others.
void SolidIterate::change_with_care(std::vector<std::vector<Status>>& fresh) const {
  std::vector<std::vector<double>> dues;
  for (std::size_t c = 0; c < fresh.size(); ++c) {
    auto& of_contact = dues.emplace_back();
    for (std::size_t j = 0; j < fresh[c].size(); ++j)
      of_contact.push_back(due(static_cast<int>(c), static_cast<int>(j), now_.status[c][j], fresh[c][j]));
  }
  keep_the_most_due(dues, now_.status, fresh);
}

bool SolidIterate::classify(bool with_care) {
  bool changed = false;
  std::vector<std::vector<Status>> fresh = now_.status;
  for (std::size_t c = 0; c < place_.size(); ++c)
    for (int j = 0; j < place_[c].count(); ++j) fresh[c][j] = decide(static_cast<int>(c), j);
  if (!stick_all_ && !as_before_) keep_what_rests(fresh);
  const auto closed =
      std::accumulate(fresh.begin(), fresh.end(), std::ptrdiff_t{0}, [](std::ptrdiff_t sum, const auto& of) {
        return sum + std::count_if(of.begin(), of.end(), [](Status status) { return status != Status::open; });
      });
  if (closed == 0 && system_.unheld > 0) {
    ++came_apart_;
    now_.status = fresh;
    seed();
    fresh = now_.status;
    changed = true;
  }
  stick_all_ = as_before_ = false;
  changed = changed || fresh != now_.status;
  if (with_care) change_with_care(fresh);
  const bool differs = fresh != now_.status;
  now_.status = std::move(fresh);
  if (project() || (differs && wears())) evaluate();
  return changed;
}

}  // namespace reye::solver
