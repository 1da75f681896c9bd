#include <utility>

#include "contact/interface.hpp"

namespace reye::contact {

using mortar::FacetRecord;

namespace {

/// Order of the scalars of a node in its dual numbers.
enum Direction { lambda_x, lambda_y, normal_x, normal_y, gap_, motion_x, motion_y, cover_D, off_, worn_, share_ };

}  // namespace

template <class Visit>
void Interface::for_records(int node, Visit visit) const {
  for (int side = 0; side < 2; ++side)
    if (const int r = record_of_[node][side]; r >= 0)
      visit((*records_)[r], setup_->secondary.is_control_point(node) ? 2 : 1 - side);
}

NodeConditions<Interface::Eleven> Interface::node_duals(int node, const std::vector<Vec2>& lambda) const {
  const Vec2 v = motion(node);
  NodeScalars<Eleven> s;
  s.lambda = {Eleven::variable(lambda[node].x(), lambda_x), Eleven::variable(lambda[node].y(), lambda_y)};
  s.normal = {Eleven::variable(at_.normal[node].x(), normal_x), Eleven::variable(at_.normal[node].y(), normal_y)};
  s.gap = Eleven::variable(at_.gap[static_cast<std::size_t>(node)], Direction::gap_);
  s.motion = {Eleven::variable(v.x(), motion_x), Eleven::variable(v.y(), motion_y)};
  s.D = Eleven::variable(at_.rows[node].D, cover_D);
  s.off = Eleven::variable(shares_between(node), off_);
  s.worn_others = Eleven::variable(worn_others(node), worn_);
  s.share = Eleven::variable(share(node, lambda), share_);
  return conditions(s, constants(node), decision_.status[node]);
}

/// add(column, value) for slope . d(normal)/dx.
template <class Add>
void Interface::chain_normal(int node, double slope_x, double slope_y, Add add) const {
  using Six = base::Dual<6>;
  if (slope_x == 0.0 && slope_y == 0.0) return;
  const auto st = stencil(node);
  std::array<Pair<Six>, 3> x;
  for (int i = 0; i < 3; ++i)
    if (st.nodes[i] >= 0)
      x[i] = {Six::variable(placement_.xs[st.nodes[i]].x(), 2 * i),
              Six::variable(placement_.xs[st.nodes[i]].y(), 2 * i + 1)};
  const auto n = mortar::nodal_normal(st, x);
  for (int i = 0; i < 6; ++i)
    if (st.nodes[i / 2] >= 0) add(2 * st.nodes[i / 2] + i % 2, slope_x * n.x.d[i] + slope_y * n.y.d[i]);
}

/// add(column, value) for slope . d(sum_k off_jk (x_k - x_j) + sum_l M_jl (x_j - x_l))/dx at fixed integrals.
template <class Add>
void Interface::chain_relative(int node, const MortarRow& row, const Vec2& slope, Add add) const {
  if (slope.isZero(0.0)) return;
  const auto both = [&](int first, double factor) {
    add(first, factor * slope.x());
    add(first + 1, factor * slope.y());
  };
  double own = 0.0;
  for (const auto& [k, share] : row.off) {
    own -= share;
    both(2 * k, share);
  }
  for (const auto& [l, M] : row.M) {
    own += M;
    both(placement_.secondary_dofs() + 2 * l, -M);
  }
  both(2 * node, own);
}

/// add(column, value) for slope . d(motion)/dx, in the form that `motion` uses.
template <class Add>
void Interface::chain_motion(int node, double slope_x, double slope_y, Add add) const {
  if (slope_x == 0.0 && slope_y == 0.0) return;
  const bool drift = uses_drift(node);
  for_records(node, [&](const FacetRecord& record, int e) {
    const int output = drift ? record.drift(e) : record.offset(e);
    const double *dx = record.row(output), *dy = record.row(output + 1), sign = drift ? 1.0 : -1.0;
    for (std::size_t i = 0; i < record.dofs.size(); ++i)
      add(record.dofs[i], sign * (slope_x * dx[i] + slope_y * dy[i]));
  });
  if (!drift) chain_relative(node, before_->reference[node], {slope_x, slope_y}, add);
}

/// add(column, value) for all dependencies of a node's scalar except the wear of others.
template <class Add>
void Interface::chain(int node, const Eleven& quantity, Add add) const {
  const auto& d = quantity.d;
  const int multipliers = placement_.dofs() + 2 * node;
  add(multipliers, d[lambda_x]);
  add(multipliers + 1, d[lambda_y]);
  if (derivatives_ == Derivatives::held_integrals)
    return chain_relative(node, at_.rows[node], Vec2(d[motion_x], d[motion_y]) - d[Direction::gap_] * at_.normal[node],
                          add);
  chain_normal(node, d[normal_x], d[normal_y], add);
  chain_motion(node, d[motion_x], d[motion_y], add);
  if (d[Direction::gap_] == 0.0 && d[cover_D] == 0.0) return;
  for_records(node, [&](const FacetRecord& record, int e) {
    const double *g = record.row(record.gap(e)), *D = record.row(record.D(e));
    for (std::size_t i = 0; i < record.dofs.size(); ++i)
      add(record.dofs[i], d[Direction::gap_] * g[i] + d[cover_D] * D[i]);
    for (int k = 0; k < record.count; ++k) {
      if (d[off_] == 0.0 || k == e || !goes_with_neighbours(setup_->secondary.facets[record.facet][k])) continue;
      const double* off = record.row(record.off(e, k));
      for (std::size_t i = 0; i < record.dofs.size(); ++i) add(record.dofs[i], d[off_] * off[i]);
    }
  });
}

/// d(force) from the derivatives of D and M at fixed lambda.
void Interface::force_entries(int node, const Vec2& lambda, std::vector<Entry>& out) const {
  const int shift = placement_.secondary_dofs();
  const auto push = [&](int row, double slope, int col) {
    if (slope == 0.0) return;
    out.push_back({row, col, slope * lambda.x()});
    out.push_back({row + 1, col, slope * lambda.y()});
  };
  for_records(node, [&](const FacetRecord& record, int e) {
    const auto& facet = setup_->secondary.facets[record.facet];
    for (std::size_t i = 0; i < record.dofs.size(); ++i) {
      push(2 * node, record.row(record.D(e))[i], record.dofs[i]);
      for (int k = 0; k < record.count; ++k)
        if (k != e && record.value.off[e][k] != 0.0)
          push(2 * facet[k], record.row(record.off(e, k))[i], record.dofs[i]);
      for (std::size_t l = 0; l < record.primaries.size(); ++l)
        push(shift + 2 * record.primaries[l], -record.row(record.M(e, static_cast<int>(l)))[i], record.dofs[i]);
    }
  });
}

/// Leaves one entry per column: every active node that a primary node meets repeats its list.
void Interface::add_up(std::vector<WearEntry>& entries) {
  column_sum_.resize(static_cast<std::size_t>(placement_.dofs()) + 2 * at_.rows.size(), 0.0);
  std::size_t kept = 0;
  for (const auto& entry : entries) {
    double& sum = column_sum_[entry.col];
    if (sum == 0.0) entries[kept++].col = entry.col;
    sum += entry.value;
  }
  entries.resize(kept);
  for (auto& entry : entries) entry.value = std::exchange(column_sum_[entry.col], 0.0);
}

/// Adds this node's share to d(primary depth): d(T_jl V_j / D_j) / A_l, where D_j = sum_l T_jl.
void Interface::collect_primary_wear(int node, const Eleven& volume) {
  const double D = at_.spread[node];
  const bool linear = setup_->secondary.order == 1;
  std::vector<WearEntry> own;
  chain(node, volume, [&](int col, double value) { own.push_back({col, value}); });
  add_up(own);
  for (const auto& [l, T] : at_.cover[node]) {
    const double factor = primary_volume(node, D, 1.0) * primary_opening(l);  // times T / D
    auto& slopes = primary_slope_[l];
    for (const auto& entry : own) slopes.push_back({entry.col, factor * T / D * entry.value});
    if (derivatives_ == Derivatives::held_integrals) continue;
    for_records(node, [&, l = l, T = T](const FacetRecord& record, int e) {
      for (std::size_t k = 0; k < record.primaries.size(); ++k) {
        if (record.primaries[k] != l) continue;
        const double* dT = record.row(record.cover(e, static_cast<int>(k)));
        for (std::size_t i = 0; i < record.dofs.size(); ++i)
          slopes.push_back({record.dofs[i], factor * volume.v / D * dT[i]});
      }
      const int parts = linear ? 1 : static_cast<int>(record.primaries.size());
      for (int part = 0; part < parts; ++part) {
        const double* dD = record.row(linear ? record.D(e) : record.cover(e, part));
        for (std::size_t i = 0; i < record.dofs.size(); ++i)
          slopes.push_back({record.dofs[i], -factor * T * volume.v / (D * D) * dD[i]});
      }
    });
  }
}

/// Adds this node's share to d(depth) of the control points that wear with it.
void Interface::collect_wear_between(int node, const Eleven& volume) {
  for (const auto& [k, per_volume] : between_[node]) {
    const double factor = per_volume;
    auto& slopes = secondary_slope_[k];
    chain(node, volume, [&](int col, double value) { slopes.push_back({col, factor * value}); });
  }
}

/// slope . d(worn_others) at fixed wear, by the derivatives of the integrals.
void Interface::cover_entries(int node, double slope, std::vector<Entry>& out) const {
  for_records(node, [&](const FacetRecord& record, int e) {
    for (int k = 0; k < record.count; ++k) {
      const int other = setup_->secondary.facets[record.facet][k];
      if (k == e || !goes_with_neighbours(other) || depth_.secondary[other] == 0.0) continue;
      const double* doff = record.row(record.off(e, k));
      for (std::size_t i = 0; i < record.dofs.size(); ++i)
        out.push_back({2 * node, record.dofs[i], slope * depth_.secondary[other] * doff[i]});
    }
    for (std::size_t l = 0; l < record.primaries.size(); ++l) {
      const double depth = depth_.primary[record.primaries[l]];
      if (depth == 0.0) continue;
      const double* dM = record.row(record.M(e, static_cast<int>(l)));
      for (std::size_t i = 0; i < record.dofs.size(); ++i)
        out.push_back({2 * node, record.dofs[i], slope * depth * dM[i]});
    }
  });
}

/// slope . d(worn_others).
void Interface::wear_entries(int node, double slope, std::vector<Entry>& out) {
  if (slope == 0.0) return;
  if (derivatives_ == Derivatives::all) cover_entries(node, slope, out);
  node_slope_.clear();
  for (const auto& [l, M] : at_.rows[node].M)
    for (const auto& entry : primary_slope_[l]) node_slope_.push_back({entry.col, slope * M * entry.value});
  for (const auto& [k, share] : at_.rows[node].off)
    if (setup_->between(k))
      for (const auto& entry : secondary_slope_[k]) node_slope_.push_back({entry.col, slope * share * entry.value});
  add_up(node_slope_);
  for (const auto& entry : node_slope_) out.push_back({2 * node, entry.col, entry.value});
}

void Interface::linearise(const std::vector<Vec2>& lambda, Linearised& out, Derivatives derivatives) {
  const bool all = derivatives == Derivatives::all;
  derivatives_ = derivatives;
  out.force.clear();
  out.rows.clear();
  if (setup_->options.bonded) return linearise_bond(out);
  primary_slope_.resize(setup_->primary.X.size());
  secondary_slope_.resize(setup_->secondary.X.size());
  for (auto* side : {&primary_slope_, &secondary_slope_})
    for (auto& slopes : *side) slopes.clear();
  std::vector<std::pair<int, NodeConditions<Eleven>>> duals;
  for (int node = 0; node < static_cast<int>(at_.rows.size()); ++node) {
    if (!active(node)) continue;
    for (int r : record_of_[node])
      if (all && r >= 0 && !differentiated_[r]) {
        integrator_.differentiate(placement_, (*records_)[r]);
        differentiated_[r] = 1;
      }
    duals.emplace_back(node, node_duals(node, lambda));
    if (all) force_entries(node, lambda[node], out.force);
  }
  if (wear_spreads())
    for (const auto& [node, c] : duals)
      if (decision_.status[node] == ContactStatus::slip) {
        if (setup_->options.wear.primary > 0.0) collect_primary_wear(node, c.worn.primary);
        collect_wear_between(node, c.worn.secondary);
      }
  for (auto* side : {&primary_slope_, &secondary_slope_})
    for (auto& slopes : *side) add_up(slopes);
  const Eleven anchor_shear = options_.anchor < 0 ? Eleven() : node_duals(options_.anchor, lambda).lambda_t;
  for (const auto& [node, c] : duals) {
    const auto into = [&](int row) {
      return [&out, row](int col, double value) {
        if (value != 0.0) out.rows.push_back({row, col, value});
      };
    };
    chain(node, c.normal, into(2 * node));
    chain(node, c.tangential, into(2 * node + 1));
    wear_entries(node, c.normal.d[worn_], out.rows);
    if (options_.anchor < 0 || c.tangential.d[share_] == 0.0) continue;
    const double factor =
        c.tangential.d[share_] * options_.held_pressure[node] / options_.held_pressure[options_.anchor];
    chain(options_.anchor, anchor_shear, [&](int col, double value) { into(2 * node + 1)(col, factor * value); });
  }
}

}  // namespace reye::contact
