#include <algorithm>
#include <cmath>

#include "contact/interface.hpp"

namespace reye::contact {

/// Volumes and work of one slipping node go to the nodes that wear with it, on either side.
void Interface::book(int node, ContactState& next) const {
  const auto j = static_cast<std::size_t>(node);
  const auto& c = condition_[j];
  const auto& law = setup_->options.wear;
  const auto& area = setup_->secondary.area;
  const double friction_work = options_.jump * std::abs(c.drag * c.slip);
  const auto spread = [&](auto add) {
    add(j, area[j] / worn_length_[j]);
    for (const auto& [k, per_volume] : between_[j]) add(static_cast<std::size_t>(k), 0.5 * area[k] / worn_length_[j]);
  };
  next.slip[j] += options_.jump * std::abs(c.slip) / (at_.rows[j].D + shares_between(node));
  next.frictional_work += friction_work;
  spread([&](std::size_t k, double share) { next.energy_secondary[k] += share * friction_work; });
  if (!options_.wear || !law.wears()) return;
  next.worn_work += friction_work;
  next.law_volume += c.worn.secondary + c.worn.primary;
  spread([&](std::size_t k, double share) {
    next.pending_secondary[k] += share * c.worn.secondary;
    next.removed_secondary[k] += share * c.worn.secondary;
  });
  if (law.primary == 0.0) return;
  for (const auto& [l, T] : at_.cover[j]) {
    const double volume = primary_volume(node, T, c.worn.primary);
    next.pending_primary[l] += volume;
    next.removed_primary[l] += volume;
  }
}

/// The coefficient of friction that the next increment finds: where it follows a formula, that of each active node.
void Interface::note_friction(ContactState& next) const {
  next.friction = friction_;
  if (!setup_->options.friction_formula || options_.held) return;
  next.nodal_friction.resize(at_.rows.size(), friction_);
  for (std::size_t j = 0; j < at_.rows.size(); ++j)
    if (active(static_cast<int>(j))) next.nodal_friction[j] = condition_[j].friction;
  next.friction = *std::max_element(next.nodal_friction.begin(), next.nodal_friction.end());
}

ContactState Interface::accepted(const std::vector<Vec2>& lambda) const {
  ContactState next = *before_;
  next.lambda = lambda;
  next.normal = at_.normal;
  next.status = decision_.status;
  next.reference = at_.rows;
  note_friction(next);
  for (std::size_t j = 0; j < lambda.size(); ++j)
    if (lambda[j].norm() <= setup_->faint) next.lambda[j].setZero();
  if (options_.held || setup_->options.bonded) return next;
  for (std::size_t j = 0; j < at_.rows.size(); ++j)
    if (decision_.status[j] == ContactStatus::slip && !next.lambda[j].isZero(0.0)) book(static_cast<int>(j), next);
  return next;
}

}  // namespace reye::contact
