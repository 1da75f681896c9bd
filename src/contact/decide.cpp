#include <cmath>

#include "contact/interface.hpp"

namespace reye::contact {

namespace {

constexpr double least_slip = 1e-9;  ///< of a facet's length: less is round-off of positions

/// Whether forces along d move a node.
bool yields_along(const body::NodeFreedom& freedom, const Vec2& d) {
  constexpr double share = 0.5;
  return freedom.free == 2 || (freedom.free == 1 && std::abs(freedom.direction.dot(d)) > share);
}

}  // namespace

/// The slip that supports impose on a node held along the surface, opposite to one that is held as well. Empty where
/// one of the two can move: there the node is judged like others.
std::optional<double> Interface::support_slip(int node) const {
  if (mobility_.secondary.empty() || !mobility_.secondary[node] || at_.rows[node].M.empty()) return std::nullopt;
  const Vec2& free = setup_->freedom[node].direction;
  const Vec2 held(-free.y(), free.x());
  const Vec2& x = placement_.xs[node];
  const auto& xm = placement_.xm;
  const auto aside = [&](int l) { return std::abs(held.dot(xm[l] - x)); };
  int opposite = at_.rows[node].M.front().first;
  for (const auto& [l, M] : at_.rows[node].M)
    if (aside(l) < aside(opposite)) opposite = l;
  if (yields_along(mobility_.primary[opposite], held)) return std::nullopt;
  const Vec2 moved = x - placement_.xs_before[node] - (xm[opposite] - placement_.xm_before[opposite]);
  const Vec2 tangent(-at_.normal[node].y(), at_.normal[node].x());
  return moved.dot(held) * held.dot(tangent);  // the motion that closes the gap is not slip
}

/// The shear that the node carried when the increment began.
double Interface::shear_before(int node) const {
  const Vec2& n = before_->normal[node];
  return n.x() * before_->lambda[node].y() - n.y() * before_->lambda[node].x();
}

/// The direction of imposed sliding; where nothing slides in this increment, the direction of the present friction.
double Interface::sliding_sign() const {
  double way = options_.imposed_slip;
  for (std::size_t j = 0; way == 0.0 && j < before_->lambda.size(); ++j) way = shear_before(static_cast<int>(j));
  if (way == 0.0) way = options_.first_way;
  return way < 0.0 ? -1.0 : 1.0;
}

/// Gap at a node opened by the wear that its neighbours cause in this increment: on the primary side, and at control
/// points between them.
double Interface::others_wear(int node) const {
  const auto& own_wear = condition_[node].worn;
  double others = 0.0;
  for (const auto& [l, M] : at_.rows[node].M) {
    others += M * (depth_.primary[l] - start_.primary[l]);
    for (const auto& [k, T] : at_.cover[node])
      if (k == l && at_.rows[node].D > 0.0)
        others -= M * primary_volume(node, T, own_wear.primary) * primary_opening(l);
  }
  for (const auto& [k, share] : at_.rows[node].off) {
    if (!setup_->between(k)) continue;
    others += share * (depth_.secondary[k] - start_.secondary[k]);
    for (const auto& [own, per_volume] : between_[node])
      if (own == k) others -= share * per_volume * own_wear.secondary;
  }
  return others;
}

void Interface::decide(const std::vector<Vec2>& lambda, int iteration, Start from) {
  last_.status = decision_.status;
  last_.sign = decision_.sign;
  const auto& o = setup_->options;
  const bool searching = iteration < 5;
  Judgement by{};
  by.from = from;
  by.unjudged = iteration == 0 && !is_predicted(from);
  const bool late = options_.wear && o.wear.wears() && !options_.held && o.implicit_wear && !searching;
  by.stays = late || (iteration == 0 && from == Start::continued);
  by.spread = late && wear_spreads();
  by.c_normal = searching ? o.c_normal : 1.0;
  by.c_tangential = searching ? o.c_tangential : 1.0;
  by.sliding = o.imposed ? sliding_sign() : 1.0;
  for (std::size_t j = 0; j < at_.rows.size(); ++j) {
    const int node = static_cast<int>(j);
    if (setup_->cut[j] || !touching(node)) {
      decision_.status[j] = ContactStatus::inactive;
    } else if (o.bonded) {
      decision_.status[j] = ContactStatus::stick;
      decision_.unmoved[j] = support_slip(node).has_value();
    } else if (const Pressed pressed = decide_normal(node, lambda[j], by); !pressed.active) {
      decision_.status[j] = ContactStatus::inactive;
    } else {
      decide_tangential(node, lambda[j], pressed, by);
    }
  }
}

/// Whether a node carries pressure.
Interface::Pressed Interface::decide_normal(int node, const Vec2& lambda, const Judgement& by) const {
  const double stiffness = setup_->stiffness[node], faint = setup_->faint;
  const double lambda_n = lambda.dot(at_.normal[node]);
  const double opened = (at_.gap[node] + at_.worn_gap[node] + (by.spread ? others_wear(node) : 0.0)) / at_.rows[node].D;
  const bool was = last_.status[node] != ContactStatus::inactive;
  // A node that has just closed has no pressure yet: its bound is the pressure that its overlap announces.
  // As a sticking node it would be dragged by the whole slip of the increment, and open and close for ever.
  const double bound = was ? lambda_n : lambda_n - by.c_normal * stiffness * opened;
  const bool springs = options_.compliance > 0.0;
  if (springs) return {options_.held_pressure[node] > 0.0, was, bound};
  // Nodes that touch at zero gap start active: the first matrix would be singular without them.
  if (by.unjudged && (was || opened <= 1e-9 * setup_->secondary.area[node])) return {true, was, bound};
  // In late iterations an active node stays active for its pressure alone: the wear that a node in tension ascribes to
  // itself would keep it active. A node with neither pressure nor gap keeps its status, as both are consistent there.
  const double closing = by.stays && was ? 0.0 : by.c_normal * stiffness * opened;
  return {!(lambda_n - closing <= (was ? -faint : faint)), was, bound};
}

/// Whether an active node sticks or slips, and in which direction.
void Interface::decide_tangential(int node, const Vec2& lambda, const Pressed& pressed, const Judgement& by) {
  decision_.unmoved[node] = 0;
  if (setup_->options.imposed || friction_ == 0.0) {
    decision_.status[node] = ContactStatus::slip;
    decision_.sign[node] = setup_->options.out_of_plane ? 0.0 : by.sliding;
  } else if (const auto slip = support_slip(node); slip && !options_.held) {
    decision_.unmoved[node] = std::abs(*slip) <= least_slip * setup_->length[node];
    decision_.status[node] = decision_.unmoved[node] ? ContactStatus::stick : ContactStatus::slip;
    decision_.sign[node] = *slip < 0.0 ? -1.0 : 1.0;
  } else if (by.unjudged || options_.held) {
    decision_.status[node] = ContactStatus::stick;
    decision_.unmoved[node] = by.from == Start::sheared && !options_.held;
  } else {
    decide_free(node, lambda, pressed, by.c_tangential);
  }
}

/// mu at a node, by its pressure and the slip of the iteration before.
double Interface::friction_at(int node, double pressure) const {
  if (!setup_->options.friction_formula) return friction_;
  return coefficient_of_friction(pressure, condition_[node].slip, at_.rows[node].D + shares_between(node),
                                 constants(node));
}

/// Coulomb's law where nothing imposes the motion.
void Interface::decide_free(int node, const Vec2& lambda, const Pressed& pressed, double c_tangential) {
  const Vec2 tangent(-at_.normal[node].y(), at_.normal[node].x());
  const double trial =
      lambda.dot(tangent) + c_tangential * setup_->stiffness[node] * tangent.dot(motion(node)) / at_.rows[node].D;
  const double bound = friction_at(node, pressed.bound) * pressed.bound;
  const double sign = trial < 0.0 ? -1.0 : 1.0;
  // Slip reverses through stick only: a large c would else throw a node from one sign to the other for ever.
  const bool reverses = last_.status[node] == ContactStatus::slip && decision_.sign[node] * sign < 0.0;
  const double yields = last_.status[node] == ContactStatus::stick ? bound + setup_->faint : bound;
  decision_.status[node] = reverses || std::abs(trial) < yields ? ContactStatus::stick : ContactStatus::slip;
  decision_.sign[node] = sign;
}

}  // namespace reye::contact
