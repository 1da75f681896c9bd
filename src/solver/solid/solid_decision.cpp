#include <algorithm>
#include <limits>
#include <numeric>

#include "solver/solid/solid_iterate.hpp"

/// Which points are open, stick or slip.
namespace reye::solver {

namespace {

constexpr int early_decisions = 5;  ///< as many as find the region of contact

}  // namespace

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

/// Whether a point is in contact. In late iterations a closed point of a contact that wears stays closed for its
/// pressure alone, since the wear that it ascribes to itself under tension would keep it closed, and the wear of others
/// counts.
bool SolidIterate::is_closed(int c, int j) const {
  const auto& node = nodes_[c][j];
  const auto& frame = place_[c].frame[j];
  const bool was = now_.status[c][j] != Status::open;
  if (as_before_) return was;
  const double stiffness = system_.contacts[c].stiffness[j];
  if (decisions_ <= early_decisions || !target_.wear[c].on) return contact::closed(node, frame, stiffness);
  if (was) return contact::pressure(node, frame) > 0.0;
  return contact::pressure(node, frame) - stiffness * (node.gap - node.own_worn) > 0.0;
}

/// In late iterations no point closes while another opens: they would change places for ever.
void SolidIterate::open_before_closing(std::vector<std::vector<Status>>& fresh) const {
  if (decisions_ <= early_decisions) return;
  const auto each = [&](auto visit) {
    for (std::size_t c = 0; c < fresh.size(); ++c)
      for (std::size_t j = 0; j < fresh[c].size(); ++j) visit(now_.status[c][j], fresh[c][j]);
  };
  bool opens = false;
  each([&](Status before, Status after) { opens = opens || (before != Status::open && after == Status::open); });
  if (opens)
    each([](Status before, Status& after) {
      if (before == Status::open) after = Status::open;
    });
}

SolidIterate::Status SolidIterate::decide(int c, int j) const {
  const auto& place = place_[c];
  const auto& node = nodes_[c][j];
  const double stiffness = system_.contacts[c].stiffness[j];
  if (!place.carries[j] || !is_closed(c, j)) return Status::open;
  if (stick_all_ || friction(c) == 0.0) return Status::stick;
  const Status status = contact::tangential_status(node, place.frame[j], friction(c), stiffness);
  // Slip that turns back sticks first: beyond the far side of the cone it would jump to and fro.
  const bool back = now_.status[c][j] == Status::slip &&
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

bool SolidIterate::classify() {
  ++decisions_;
  bool changed = false;
  std::vector<std::vector<Status>> fresh = now_.status;
  for (std::size_t c = 0; c < place_.size(); ++c)
    for (int j = 0; j < place_[c].count(); ++j) fresh[c][j] = decide(static_cast<int>(c), j);
  open_before_closing(fresh);
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
  const bool differs = fresh != now_.status;
  changed = changed || differs;
  now_.status = std::move(fresh);
  if (project() || (differs && wears())) evaluate();
  return changed;
}

}  // namespace reye::solver
