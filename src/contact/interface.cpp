#include "contact/interface.hpp"

#include <algorithm>
#include <cmath>

#include "mortar/inset.hpp"

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
  friction_ = options.friction.value_or(setup.options.friction);
  placement_.secondary = &setup.secondary;
  placement_.primary = &setup.primary;
  placement_.xs = placement_.xs_before = std::move(xs);
  drawn_offset_.clear();
  inset_.clear();
  if (options.inset > 0.0) {
    inset_ = mortar::inset(setup.primary, xm, options.inset);
    for (std::size_t l = 0; l < xm.size(); ++l) inset_[l] -= xm[l];
  }
  place_primary(xm);
  placement_.xm_before = placement_.xm;
  placement_.cut = setup.cut;
  placement_.analysis = setup.analysis;
  placement_.measure = setup.measure;
  placement_.search = setup.search;
  decision_.status = before.status;
  decision_.sign.assign(setup.secondary.X.size(), 0.0);
  decision_.unmoved.assign(setup.secondary.X.size(), 0);
  left_.assign(setup.secondary.X.size(), 0);
  mobility_ = {};
  condition_.assign(setup.secondary.X.size(), {});
  begin_wear();
}

/// Places of primary nodes to which the gap is measured: inside their body while a drawn overlap remains.
void Interface::place_primary(const Points& xm) {
  placement_.xm = xm;
  for (std::size_t l = 0; l < inset_.size(); ++l) placement_.xm[l] += inset_[l];
}

void Interface::expect(const std::vector<ContactStatus>& status, const std::vector<Vec2>& lambda) {
  decision_.status = status;
  for (std::size_t j = 0; j < decision_.status.size(); ++j) {
    const Vec2& n = before_->normal[j];
    if (decision_.status[j] == ContactStatus::slip)
      decision_.sign[j] = n.x() * lambda[j].y() - n.y() * lambda[j].x() < 0.0 ? -1.0 : 1.0;
  }
}

void Interface::integrate(const Points& xs, const Points& xm) {
  if (setup_->options.bonded) return integrate_bond(xs, xm);
  placement_.xs = xs;
  place_primary(xm);
  integrate_here();
}

void Interface::integrate_here() {
  placement_.cut = setup_->cut;
  left_.assign(setup_->secondary.X.size(), 0);
  records_ = &integrator_.values(placement_);
  differentiated_.assign(records_->size(), 0);
  sum_rows();
  if (leave_out_slivers()) sum_rows();
  sum_start_of_increment();
}

void Interface::sum_rows() {
  const auto ns = setup_->secondary.X.size();
  record_of_.assign(ns, {-1, -1});
  at_.rows.resize(ns);
  at_.cover.resize(ns);
  at_.gap.assign(ns, 0.0);
  at_.offset.assign(ns, Vec2::Zero());
  at_.drift.assign(ns, Vec2::Zero());
  for (std::size_t j = 0; j < ns; ++j) {
    at_.rows[j].D = at_.rows[j].cover = at_.rows[j].covered = 0.0;
    at_.rows[j].off.clear();
    at_.rows[j].M.clear();
    at_.cover[j].clear();
  }
  const bool spread = setup_->options.wear.primary > 0.0;
  for (std::size_t r = 0; r < records_->size(); ++r) {
    const auto& record = (*records_)[r];
    const auto& facet = setup_->secondary.facets[record.facet];
    for (int e = 0; e < record.count; ++e) {
      const int node = facet[e];
      record_of_[node][e == 1 ? 0 : 1 - e / 2] = static_cast<int>(r);
      auto& row = at_.rows[node];
      row.D += record.value.D[e];
      row.cover += record.value.on_X[e];
      row.covered += record.value.on_X[e];
      for (int k = 0; k < record.count; ++k) {
        if (k == e || record.value.off[e][k] == 0.0) continue;
        gather(row.off, facet[k], record.value.off[e][k]);
        row.covered += record.value.on_X[k];
      }
      at_.gap[node] += record.value.gap[e];
      at_.offset[node] += plain(record.value.offset[e]);
      at_.drift[node] += plain(record.value.drift[e]);
      for (std::size_t l = 0; l < record.primaries.size(); ++l) {
        gather(row.M, record.primaries[l], record.value.M[e][l]);
        if (spread) gather(at_.cover[node], record.primaries[l], record.value.cover[e][l]);
      }
    }
  }
  at_.spread.assign(ns, 0.0);
  for (std::size_t j = 0; j < ns; ++j)
    if (setup_->secondary.order == 1)
      at_.spread[j] = at_.rows[j].D;
    else
      for (const auto& [l, T] : at_.cover[j]) at_.spread[j] += T;
}

/// Normals, and the gap that earlier wear has opened; of nodes in reach that meet nothing neither is needed.
void Interface::sum_start_of_increment() {
  const auto ns = static_cast<int>(at_.rows.size());
  const bool limited = !placement_.secondary_near.empty();
  at_.normal.resize(ns, Vec2::Zero());
  at_.worn_gap.assign(ns, 0.0);
  for (int j = 0; j < ns; ++j) {
    if (limited && !meets(j)) continue;
    const auto st = stencil(j);
    std::array<Pair<double>, 3> x;
    for (int i = 0; i < 3; ++i)
      if (st.nodes[i] >= 0) x[i] = {placement_.xs[st.nodes[i]].x(), placement_.xs[st.nodes[i]].y()};
    at_.normal[j] = plain(mortar::nodal_normal(st, x));
    at_.worn_gap[j] = at_.rows[j].D * start_.secondary[j];
    for (const auto& [l, M] : at_.rows[j].M) at_.worn_gap[j] += M * start_.primary[l];
    for (const auto& [k, share] : at_.rows[j].off)
      if (goes_with_neighbours(k)) at_.worn_gap[j] += share * start_.secondary[k];
  }
}

/// The cosine between a facet and the line that its ends meet on the other side; one where an end carries no
/// multiplier.
double Interface::faces(const FacetRecord& record) const {
  const auto& facet = setup_->secondary.facets[record.facet];
  std::array<Vec2, 2> met{Vec2::Zero(), Vec2::Zero()};
  for (int e = 0; e < 2; ++e) {
    if (!(record.value.D[e] > 0.0)) return 1.0;
    for (std::size_t l = 0; l < record.primaries.size(); ++l)
      met[e] += record.value.M[e][l] / record.value.D[e] * placement_.xm[record.primaries[l]];
  }
  const Vec2 own = placement_.xs[facet[1]] - placement_.xs[facet[0]], opposite = met[1] - met[0];
  return std::max(0.0, own.dot(opposite)) / (own.norm() * opposite.norm());
}

/// At a corner the normal is that of the facet that covers more of what it faces: where wear has left a corner between
/// the worn surface and a flank, the flank is covered as well, but the node bears on the worn surface. With the flank's
/// normal its friction would pull it in: pressure there would close the gap, and no status would be consistent.
mortar::NormalStencil Interface::stencil(int node) const {
  const auto cover = [&](int side) {
    const int r = record_of_[node][side];
    return r < 0 ? 0.0 : (*records_)[r].value.D[1 - side] * faces((*records_)[r]);
  };
  const bool after = setup_->secondary.corner[node] && cover(1) > cover(0);
  return mortar::normal_stencil(setup_->secondary, node, after ? 1 : 0);
}

/// Where the covered length on X changed (on x stretch changes it too), the difference of D and M does not measure
/// slip; the motion itself is.
bool Interface::uses_drift(int node) const {
  if (options_.held) return true;  // the reference belongs to the shape before
  const auto& reference = before_->reference[node];
  return reference.D <= 0.0 ||
         std::abs(at_.rows[node].covered - reference.covered) > 1e-6 * setup_->secondary.area[node];
}

/// Weighted motion of the secondary against the primary in this increment: the objective form
/// (D_n - D) x_s - (M_n - M) x_m taken about x_j, or the drift.
Vec2 Interface::motion(int node) const {
  if (uses_drift(node)) return at_.drift[node];
  const auto& reference = before_->reference[node];
  const Vec2& x = placement_.xs[node];
  Vec2 earlier = Vec2::Zero();
  for (const auto& [k, share] : reference.off) earlier += share * (placement_.xs[k] - x);
  for (const auto& [l, M] : reference.M) earlier += M * (x - placement_.xm[l]);
  return earlier - at_.offset[node];
}

/// The traction of the anchor beyond its held shear, per pressure, times this node's pressure.
double Interface::share(int node, const std::vector<Vec2>& lambda) const {
  const int k = options_.anchor;
  if (k < 0) return 0.0;
  const Vec2 tangent(-at_.normal[k].y(), at_.normal[k].x());
  return (lambda[k].dot(tangent) - options_.held_shear[k]) / options_.held_pressure[k] * options_.held_pressure[node];
}

void Interface::evaluate(const std::vector<Vec2>& lambda) {
  if (setup_->options.bonded) return evaluate_bond(lambda);
  const auto at = [&](std::size_t j) {
    const int node = static_cast<int>(j);
    NodeScalars<double> s;
    const Vec2 v = motion(node);
    s.lambda = {lambda[j].x(), lambda[j].y()};
    s.normal = {at_.normal[j].x(), at_.normal[j].y()};
    s.gap = at_.gap[j];
    s.motion = {v.x(), v.y()};
    s.D = at_.rows[j].D;
    s.off = shares_between(node);
    s.worn_others = worn_others(node);
    s.share = share(node, lambda);
    return conditions(s, constants(node), decision_.status[j]);
  };
  for (std::size_t j = 0; j < at_.rows.size(); ++j)
    condition_[j] = active(static_cast<int>(j)) ? at(j) : NodeConditions<double>{};
  spread_wear();
  if (!wear_spreads()) return;
  for (std::size_t j = 0; j < at_.rows.size(); ++j)
    if (active(static_cast<int>(j))) condition_[j] = at(j);
}

Vector Interface::forces(const std::vector<Vec2>& lambda) const {
  Vector f = Vector::Zero(placement_.dofs());
  const int shift = placement_.secondary_dofs();
  for (std::size_t j = 0; j < at_.rows.size(); ++j) {
    if (lambda[j].isZero(0.0)) continue;
    f.segment<2>(2 * static_cast<int>(j)) += at_.rows[j].D * lambda[j];
    for (const auto& [k, share] : at_.rows[j].off) f.segment<2>(2 * k) += share * lambda[j];
    for (const auto& [l, M] : at_.rows[j].M) f.segment<2>(shift + 2 * l) -= M * lambda[j];
  }
  return f;
}

Interface::Interface() = default;
Interface::Interface(const Interface&) = default;
Interface::Interface(Interface&&) noexcept = default;
Interface& Interface::operator=(const Interface&) = default;
Interface& Interface::operator=(Interface&&) noexcept = default;
Interface::~Interface() = default;

}  // namespace reye::contact
