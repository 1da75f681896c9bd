#include "contact/interface.hpp"

/// Depths of both sides in the gap, and the nodes that share them.
namespace reye::contact {

/// Depths at the start, in the gap's own measure, and which control points wear with a node.
void Interface::begin_wear() {
  const auto& s = setup_->secondary;
  const auto depths = [](const std::vector<double>& volume, const std::vector<double>& of_others,
                         const mortar::Surface& on, const std::vector<double>& factors) {
    std::vector<double> depth(volume.size());
    for (std::size_t k = 0; k < depth.size(); ++k)
      depth[k] = (volume[k] + elsewhere(of_others, k)) / on.area[k] * thickness(factors, static_cast<int>(k));
    return depth;
  };
  depth_.primary = start_.primary =
      depths(before_->pending_primary, options_.waiting_primary, setup_->primary, options_.thickness_primary);
  depth_.secondary = start_.secondary =
      depths(before_->pending_secondary, options_.waiting_secondary, s, options_.thickness_secondary);
  worn_length_ = s.area;
  between_.assign(s.X.size(), {});
  for (const auto& [a, b, c] : s.facets) {
    if (c < 0 || !setup_->between(c)) continue;
    for (int node : {a, b}) {
      worn_length_[node] += 0.5 * s.area[c];
      between_[node].emplace_back(c, 0.0);
    }
  }
  for (std::size_t j = 0; j < between_.size(); ++j)
    for (auto& [c, per_volume] : between_[j])
      per_volume = 0.5 / worn_length_[j] * thickness(options_.thickness_secondary, c);
}

/// True when work of this increment opens the gap of other nodes, too.
bool Interface::wear_spreads() const {
  const auto& o = setup_->options;
  const bool linear = setup_->secondary.order == 2 && o.dual == DualOrder::linear;
  const bool elsewhere = o.wear.primary > 0.0 || (linear && o.wear.secondary > 0.0);
  return options_.wear && !options_.held && o.implicit_wear && elsewhere;
}

/// Depth per node from the wear of all slip nodes: on the primary side dw_l = sum_j T_jl V_j / D_j / A_l,
/// at control points that wear with their neighbours the mean of theirs.
void Interface::spread_wear() {
  depth_.primary = start_.primary;
  depth_.secondary = start_.secondary;
  if (!wear_spreads()) return;
  for (std::size_t j = 0; j < at_.rows.size(); ++j) {
    const auto& worn = condition_[j].worn;
    if (worn.primary != 0.0)
      for (const auto& [l, T] : at_.cover[j])
        depth_.primary[l] += primary_volume(static_cast<int>(j), T, worn.primary) * primary_opening(l);
    if (worn.secondary != 0.0)
      for (const auto& [k, per_volume] : between_[j]) depth_.secondary[k] += worn.secondary * per_volume;
  }
}

/// The shares of control points without multiplier, and of nodes left to another contact, that a node's multiplier
/// carries.
double Interface::shares_between(int node) const {
  double sum = 0.0;
  for (const auto& [k, share] : at_.rows[node].off)
    if (goes_with_neighbours(k)) sum += share;
  return sum;
}

/// The opening of this node's gap by the depths of other nodes.
double Interface::worn_others(int node) const {
  double worn = 0.0;
  for (const auto& [l, M] : at_.rows[node].M) worn += M * depth_.primary[l];
  for (const auto& [k, share] : at_.rows[node].off)
    if (goes_with_neighbours(k)) worn += share * depth_.secondary[k];
  return worn;
}

}  // namespace reye::contact
