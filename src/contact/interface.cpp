#include "contact/interface.hpp"

#include <cmath>

namespace reye::contact {

using mortar::FacetRecord;

namespace {

/// Adds value to the entry of `node` in a short list.
void gather(std::vector<std::pair<int, double>>& list, int node, double value) {
  for (auto& [l, sum] : list)
    if (l == node) {
      sum += value;
      return;
    }
  list.emplace_back(node, value);
}

}  // namespace

void Interface::begin(const Setup& setup, const ContactState& before, Points xs, Points xm,
                      const IncrementOptions& options) {
  setup_ = &setup;
  before_ = &before;
  options_ = options;
  placement_.secondary = &setup.secondary;
  placement_.primary = &setup.primary;
  placement_.xs = placement_.xs_before = std::move(xs);
  placement_.xm = placement_.xm_before = std::move(xm);
  placement_.cut = setup.cut;
  placement_.analysis = setup.analysis;
  placement_.search = setup.search;
  status_ = before.status;
  const auto nm = static_cast<std::size_t>(setup.primary_count());
  primary_start_.resize(nm);
  for (std::size_t l = 0; l < nm; ++l) primary_start_[l] = before.pending_primary[l] / setup.primary.area[l];
  primary_depth_ = primary_start_;
  sign_.assign(setup.secondary.X.size(), 0.0);
  condition_.assign(setup.secondary.X.size(), {});
}

void Interface::integrate(const Points& xs, const Points& xm) {
  placement_.xs = xs;
  placement_.xm = xm;
  placement_.cut = setup_->cut;
  records_ = &integrator_.values(placement_);
  differentiated_.assign(records_->size(), 0);
  sum_rows();
  if (leave_out_slivers()) sum_rows();
  sum_start_of_increment();
}

/// A node of which hardly anything is covered carries no multiplier; its share goes to the other node of the
/// facet, or forces would be lost there: the dual functions of the others alone do not add up to one.
bool Interface::leave_out_slivers() {
  bool found = false;
  for (std::size_t j = 0; j < rows_.size(); ++j) {
    const int node = static_cast<int>(j);
    if (placement_.cut[j] || record_of_[node] == std::array{-1, -1} || touching(node)) continue;
    placement_.cut[j] = found = true;
    for (int r : record_of_[node])
      if (r >= 0) integrator_.renew(placement_, (*records_)[r]);
  }
  return found;
}

void Interface::sum_rows() {
  const auto ns = setup_->secondary.X.size();
  record_of_.assign(ns, {-1, -1});
  rows_.resize(ns);
  cover_.resize(ns);
  gap_.assign(ns, 0.0);
  offset_.assign(ns, Vec2::Zero());
  drift_.assign(ns, Vec2::Zero());
  for (std::size_t j = 0; j < ns; ++j) {
    rows_[j].D = rows_[j].off = 0.0;
    rows_[j].off_node = -1;
    rows_[j].M.clear();
    cover_[j].clear();
  }
  const bool spread = setup_->options.wear.primary > 0.0;
  for (std::size_t r = 0; r < records_->size(); ++r) {
    const auto& record = (*records_)[r];
    for (int e = 0; e < 2; ++e) {
      const int node = setup_->secondary.facets[record.facet][e];
      record_of_[node][1 - e] = static_cast<int>(r);
      auto& row = rows_[node];
      row.D += record.value.D[e];
      if (record.value.off[e] != 0.0) {
        row.off += record.value.off[e];
        row.off_node = setup_->secondary.facets[record.facet][1 - e];
      }
      gap_[node] += record.value.gap[e];
      offset_[node] += plain(record.value.offset[e]);
      drift_[node] += plain(record.value.drift[e]);
      for (std::size_t l = 0; l < record.primaries.size(); ++l) {
        gather(row.M, record.primaries[l], record.value.M[e][l]);
        if (spread) gather(cover_[node], record.primaries[l], record.value.cover[e][l]);
      }
    }
  }
}

/// Normals, and the gap that earlier wear has opened.
void Interface::sum_start_of_increment() {
  const auto ns = static_cast<int>(rows_.size());
  normal_.resize(ns);
  worn_before_.assign(ns, 0.0);
  for (int j = 0; j < ns; ++j) {
    const auto st = stencil(j);
    std::array<Pair<double>, 3> x;
    for (int i = 0; i < 3; ++i)
      if (st.nodes[i] >= 0) x[i] = {placement_.xs[st.nodes[i]].x(), placement_.xs[st.nodes[i]].y()};
    normal_[j] = plain(mortar::nodal_normal(st, x));
    worn_before_[j] = rows_[j].D * before_->pending_secondary[j] / setup_->secondary.area[j];
    for (const auto& [l, M] : rows_[j].M) worn_before_[j] += M * primary_start_[l];
  }
}

/// At a corner the facet with more cover decides.
mortar::NormalStencil Interface::stencil(int node) const {
  const auto cover = [&](int side) {
    const int r = record_of_[node][side];
    return r < 0 ? 0.0 : (*records_)[r].value.D[1 - side];
  };
  return mortar::normal_stencil(setup_->secondary, node, cover(1) > cover(0) ? 1 : 0);
}

/// Where the covered length changed, the difference of D and M is no measure of slip; the motion itself is.
bool Interface::uses_drift(int node) const {
  if (options_.held) return true;  // the reference belongs to the shape before
  const double D = before_->reference[node].D;
  const double change = std::abs(rows_[node].D - D) + std::abs(rows_[node].off - before_->reference[node].off);
  return D <= 0.0 || change > 1e-6 * setup_->secondary.area[node];
}

/// Weighted motion of the secondary against the primary in this increment: the objective form
/// (D_n - D) x_s - (M_n - M) x_m taken about x_j, or the drift.
Vec2 Interface::motion(int node) const {
  if (uses_drift(node)) return drift_[node];
  const auto& reference = before_->reference[node];
  const Vec2& x = placement_.xs[node];
  Vec2 earlier = Vec2::Zero();
  if (reference.off_node >= 0) earlier += reference.off * (placement_.xs[reference.off_node] - x);
  for (const auto& [l, M] : reference.M) earlier += M * (x - placement_.xm[l]);
  return earlier - offset_[node];
}

/// What the anchor carries beyond its held shear, per pressure, times this node's pressure.
double Interface::share(int node, const std::vector<Vec2>& lambda) const {
  const int k = options_.anchor;
  if (k < 0) return 0.0;
  const Vec2 tangent(-normal_[k].y(), normal_[k].x());
  return (lambda[k].dot(tangent) - options_.held_shear[k]) / options_.held_pressure[k] * options_.held_pressure[node];
}

NodeConstants Interface::constants(int node) const {
  NodeConstants c;
  const auto& o = setup_->options;
  c.friction = o.friction;
  c.sign = sign_[node];
  c.depth = before_->pending_secondary[node] / setup_->secondary.area[node];
  c.law = o.wear;
  if (!options_.wear) c.law.kind = wear::LawKind::none;
  if (o.implicit_wear) c.depth_per_work = o.wear.secondary * options_.jump / setup_->secondary.area[node];
  c.imposed = o.imposed;
  c.imposed_slip = options_.imposed_slip;
  c.held = options_.held;
  c.anchor = node == options_.anchor;
  if (c.held) c.held_shear = options_.held_shear[node];
  return c;
}

/// Primary depth per node from the works of all slip nodes: dw_l = coefficient / A_l sum_j T_jl E_j / D_j.
void Interface::spread_wear() {
  primary_depth_ = primary_start_;
  const double coefficient = setup_->options.wear.primary * options_.jump;
  if (coefficient == 0.0 || !options_.wear || options_.held || !setup_->options.implicit_wear) return;
  for (std::size_t j = 0; j < rows_.size(); ++j) {
    if (condition_[j].work == 0.0) continue;
    for (const auto& [l, T] : cover_[j])
      primary_depth_[l] += coefficient * T * condition_[j].work / (rows_[j].D * setup_->primary.area[l]);
  }
}

void Interface::evaluate(const std::vector<Vec2>& lambda) {
  const auto at = [&](std::size_t j) {
    const int node = static_cast<int>(j);
    NodeScalars<double> s;
    const Vec2 v = motion(node);
    s.lambda = {lambda[j].x(), lambda[j].y()};
    s.normal = {normal_[j].x(), normal_[j].y()};
    s.gap = gap_[j];
    s.motion = {v.x(), v.y()};
    s.D = rows_[j].D;
    for (const auto& [l, M] : rows_[j].M) s.worn_primary += M * primary_depth_[l];
    s.share = share(node, lambda);
    return conditions(s, constants(node), status_[j]);
  };
  for (std::size_t j = 0; j < rows_.size(); ++j)
    condition_[j] = active(static_cast<int>(j)) ? at(j) : NodeConditions<double>{};
  if (setup_->options.wear.primary == 0.0) return;
  spread_wear();
  for (std::size_t j = 0; j < rows_.size(); ++j)
    if (active(static_cast<int>(j))) condition_[j] = at(j);
}

Vector Interface::forces(const std::vector<Vec2>& lambda) const {
  Vector f = Vector::Zero(placement_.dofs());
  const int shift = placement_.secondary_dofs();
  for (std::size_t j = 0; j < rows_.size(); ++j) {
    if (lambda[j].isZero(0.0)) continue;
    f.segment<2>(2 * static_cast<int>(j)) += rows_[j].D * lambda[j];
    if (rows_[j].off_node >= 0) f.segment<2>(2 * rows_[j].off_node) += rows_[j].off * lambda[j];
    for (const auto& [l, M] : rows_[j].M) f.segment<2>(shift + 2 * l) -= M * lambda[j];
  }
  return f;
}

ContactState Interface::accepted(const std::vector<Vec2>& lambda) const {
  ContactState next = *before_;
  next.lambda = lambda;
  next.normal = normal_;
  next.status = status_;
  next.reference = rows_;
  if (options_.held) return next;
  const auto& law = setup_->options.wear;
  for (std::size_t j = 0; j < rows_.size(); ++j) {
    const auto& c = condition_[j];
    if (!active(static_cast<int>(j)) || status_[j] != ContactStatus::slip) continue;
    next.slip[j] += options_.jump * std::abs(c.slip) / rows_[j].D;
    const double friction_work = options_.jump * std::abs(c.lambda_t * c.slip);
    next.frictional_work += friction_work;
    if (!options_.wear || !law.wears()) continue;
    const double work = options_.jump * c.work;
    next.worn_work += friction_work;
    next.law_work += work;
    next.pending_secondary[j] += law.secondary * work;
    next.removed_secondary[j] += law.secondary * work;
    if (law.primary == 0.0) continue;
    for (const auto& [l, T] : cover_[j]) {
      next.pending_primary[l] += law.primary * work * T / rows_[j].D;
      next.removed_primary[l] += law.primary * work * T / rows_[j].D;
    }
  }
  return next;
}

}  // namespace reye::contact
