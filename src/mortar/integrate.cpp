#include "mortar/integrate.hpp"

#include <algorithm>
#include <iterator>

namespace reye::mortar {

namespace {

/// The nodes whose motion moves a facet or turns its normals.
enum Place { before, first, last, after, control, places };
using Stencil = std::array<int, places>;

Stencil stencil_of(const Surface& s, int facet) {
  const auto [a, b, c] = s.facets[facet];
  Stencil nodes{-1, a, b, -1, c};
  if (s.before[a] >= 0 && !s.corner[a]) nodes[before] = s.beside(s.before[a], 1);
  if (s.after[b] >= 0 && !s.corner[b]) nodes[after] = s.beside(s.after[b], 0);
  return nodes;
}

std::vector<int> dofs_of(const Placement& p, const FacetRecord& record) {
  std::vector<int> dofs;
  for (int node : stencil_of(*p.secondary, record.facet))
    if (node >= 0) dofs.insert(dofs.end(), {2 * node, 2 * node + 1});
  for (int l : record.primaries) dofs.insert(dofs.end(), {p.secondary_dofs() + 2 * l, p.secondary_dofs() + 2 * l + 1});
  return dofs;
}

/// Coefficients of the normal field: straight facets hold the nodal normals at their ends; curved ones also their own
/// normal n_0 at xi = 0, where n(0) = (n_1 + n_2) / 4 + n_c / 2.
template <class T>
std::array<Pair<T>, 3> normals_of(const Stencil& nodes, const std::array<Pair<T>, places>& x) {
  const bool curved = nodes[control] >= 0;
  const Pair<T> own = facet_normal(x[first], x[last]);
  const Pair<T> start = curved ? facet_normal(x[first], x[control]) : own;
  const Pair<T> end = curved ? facet_normal(x[control], x[last]) : own;
  std::array<Pair<T>, 3> n{nodes[before] < 0 ? start : averaged(facet_normal(x[before], x[first]), start),
                           nodes[after] < 0 ? end : averaged(end, facet_normal(x[last], x[after]))};
  if (curved) n[2] = own * 2.0 - (n[0] + n[1]) * 0.5;
  return n;
}

Pair<double> pair_of(const Vec2& x) { return {x.x(), x.y()}; }

/// A pair of scalars from two local dofs.
template <class T, class Make>
Pair<T> scalars(const Vec2& x, int& dof, Make make) {
  dof += 2;
  return {make(x.x(), dof - 2), make(x.y(), dof - 1)};
}

/// The secondary side of a facet as scalars T; `make(value, local dof)` decides on the seed. Returns the number of
/// dofs.
template <class T, class Make>
int load_secondary(const Placement& p, const FacetRecord& record, FacetInput<T>& in, Make make) {
  const Surface& s = *p.secondary;
  int dof = 0;
  const auto nodes = stencil_of(s, record.facet);
  std::array<Pair<T>, places> x;
  for (std::size_t i = 0; i < places; ++i)
    if (nodes[i] >= 0) x[i] = scalars<T>(p.xs[nodes[i]], dof, make);
  in.kind = mesh::kind_of(s.facets[record.facet]);
  in.x = {x[first], x[last], x[control]};
  in.n = normals_of(nodes, x);
  for (std::size_t j = 0; j < static_cast<std::size_t>(in.count()); ++j) {
    const int node = s.facets[record.facet][j];
    in.X[j] = pair_of(s.X[node]);
    in.x_before[j] = pair_of(p.xs_before[node]);
    in.cut[j] = p.cut[node] != 0;
  }
  in.analysis = p.analysis;
  in.measure = p.measure;
  in.search = p.search;
  return dof;
}

/// The primary facets opposite, from local dof `dof` on.
template <class T, class Make>
void load_primary(const Placement& p, const FacetRecord& record, FacetInput<T>& in, Make make, int dof = 0) {
  in.xm.clear();
  in.xm_before.clear();
  for (int l : record.primaries) {
    in.xm.push_back(scalars<T>(p.xm[l], dof, make));
    in.xm_before.push_back(pair_of(p.xm_before[l]));
  }
  in.pairs = record.pairs;
}

template <class T, class Make>
void load(const Placement& p, const FacetRecord& record, FacetInput<T>& in, Make make) {
  load_primary<T>(p, record, in, make, load_secondary<T>(p, record, in, make));
}

constexpr std::size_t bundle = 8;  ///< primary facets that are judged by one circle before each is by its own

double plain_value(double x, int) { return x; }

/// Distance of a curve from its chord.
double sag(const Points& x, const LineFacet& f) {
  return f[2] < 0 ? 0.0 : 0.5 * (x[f[2]] - 0.5 * (x[f[0]] + x[f[1]])).norm();
}

}  // namespace

NormalStencil normal_stencil(const Surface& s, int node, int at_corner) {
  NormalStencil stencil;
  if (s.is_control_point(node)) {
    const auto& facet = s.facets[s.before[node]];
    stencil.nodes = {facet[0], -1, facet[1]};
    return stencil;
  }
  stencil.nodes[1] = node;
  const bool has_before = s.before[node] >= 0 && !(s.corner[node] && at_corner == 1);
  const bool has_after = s.after[node] >= 0 && !(s.corner[node] && at_corner == 0);
  if (has_before) stencil.nodes[0] = s.beside(s.before[node], 1);
  if (has_after) stencil.nodes[2] = s.beside(s.after[node], 0);
  return stencil;
}

void Integrator::list_opposites(const Placement& p) {
  opposites_.clear();
  bundles_.clear();
  for (const auto& facet : p.primary->facets) {
    if (!p.near(p.primary_near, facet)) continue;
    const Vec2 edge = p.xm[facet[1]] - p.xm[facet[0]];
    opposites_.push_back({facet, {p.xm[facet[0]] + 0.5 * edge, 0.5 * edge.norm() + sag(p.xm, facet)}});
  }
  for (std::size_t first = 0; first < opposites_.size(); first += bundle) {
    const std::size_t end = std::min(first + bundle, opposites_.size());
    Circle round{opposites_[first + (end - first) / 2].round.middle};
    for (std::size_t i = first; i < end; ++i)
      round.radius =
          std::max(round.radius, (opposites_[i].round.middle - round.middle).norm() + opposites_[i].round.radius);
    round.radius *= 1.0 + 1e-9;  // rounding leaves none out
    bundles_.push_back(round);
  }
}

/// Finds the primary facets that may lie opposite: near, and not wholly on one side of the facet's two rays. What holds
/// for a circle round several facets holds for each.
bool Integrator::pair_up(const Placement& p, int facet, FacetRecord& record) {
  record.facet = facet;
  record.count = mesh::node_count(mesh::kind_of(p.secondary->facets[facet]));
  record.primaries.clear();
  record.pairs.clear();
  record.slope.clear();
  load_secondary<double>(p, record, plain_.in, plain_value);
  const auto& in = plain_.in;
  const Vec2 x0 = plain(in.x[0]), x1 = plain(in.x[1]), n0 = plain(in.n[0]), n1 = plain(in.n[1]);
  const Vec2 middle = 0.5 * (x0 + x1);
  const double reach = p.search + 0.5 * (x1 - x0).norm() + sag(p.xs, p.secondary->facets[facet]);
  const double length0 = n0.norm(), length1 = n1.norm();
  const auto is_near = [&](const Circle& round) {
    const double far = reach + round.radius;
    return !((round.middle - middle).squaredNorm() > far * far);
  };
  const auto between_rays = [&](const Circle& round) {
    return base::cross(n0, round.middle - x0) > -round.radius * length0 &&
           base::cross(n1, round.middle - x1) < round.radius * length1;
  };
  local_.resize(p.primary->X.size(), -1);
  for (std::size_t k = 0; k < bundles_.size(); ++k) {
    if (!is_near(bundles_[k]) || !between_rays(bundles_[k])) continue;
    const std::size_t end = std::min((k + 1) * bundle, opposites_.size());
    for (std::size_t i = k * bundle; i < end; ++i) {
      const auto& [a, b, c] = opposites_[i].nodes;
      if (!is_near(opposites_[i].round) || (x1 - x0).dot(p.xm[b] - p.xm[a]) >= 0.0) continue;
      if (base::cross(n0, p.xm[a] - x0) <= 0.0 || base::cross(n1, p.xm[b] - x1) >= 0.0) continue;
      add_pair(opposites_[i].nodes, record);
    }
  }
  for (int node : record.primaries) local_[node] = -1;
  if (record.pairs.empty()) return false;
  load_primary<double>(p, record, plain_.in, plain_value);
  return true;
}

void Integrator::add_pair(const LineFacet& opposite, FacetRecord& record) {
  LineFacet pair{-1, -1, -1};
  for (std::size_t e = 0; e < 3; ++e) {
    const int node = opposite[e];
    if (node < 0) continue;
    if (local_[node] < 0) {
      local_[node] = static_cast<int>(record.primaries.size());
      record.primaries.push_back(node);
    }
    pair[e] = local_[node];
  }
  record.pairs.push_back(pair);
}

FacetRecord& Integrator::next_record() {
  if (spare_.empty()) return records_.emplace_back();
  records_.push_back(std::move(spare_.back()));
  spare_.pop_back();
  return records_.back();
}

std::vector<FacetRecord>& Integrator::values(const Placement& p) {
  list_opposites(p);
  std::move(records_.begin(), records_.end(), std::back_inserter(spare_));
  records_.clear();
  for (int facet = 0; facet < p.secondary->facet_count(); ++facet) {
    if (!p.near(p.secondary_near, p.secondary->facets[facet])) continue;
    FacetRecord& record = next_record();
    const bool faced = pair_up(p, facet, record);
    if (faced) integrate(plain_);
    if (faced && !plain_.points.empty()) {
      std::swap(record.value, plain_.out);
    } else {
      spare_.push_back(std::move(record));
      records_.pop_back();
    }
  }
  return records_;
}

void Integrator::renew(const Placement& p, FacetRecord& record) {
  load<double>(p, record, plain_.in, plain_value);
  integrate(plain_);
  std::swap(record.value, plain_.out);
}

/// Derivatives along the dofs from `from` on, which the last pass took.
void Integrator::store(FacetRecord& record, int from) const {
  const int dofs = static_cast<int>(record.dofs.size()), primaries = static_cast<int>(record.primaries.size());
  const int count = std::min(width, dofs - from);
  const auto put = [&](int output, const base::Dual<width>& q) {
    std::copy_n(q.d.begin(), count, record.slope.begin() + output * dofs + from);
  };
  const auto& out = dual_.out;
  for (int j = 0; j < record.count; ++j) {
    put(record.D(j), out.D[j]);
    for (int k = 0; k < record.count; ++k)
      if (k != j) put(record.off(j, k), out.off[j][k]);
    put(record.gap(j), out.gap[j]);
    put(record.offset(j), out.offset[j].x);
    put(record.offset(j) + 1, out.offset[j].y);
    put(record.drift(j), out.drift[j].x);
    put(record.drift(j) + 1, out.drift[j].y);
    for (int l = 0; l < primaries; ++l) {
      put(record.M(j, l), out.M[j][l]);
      put(record.cover(j, l), out.cover[j][l]);
    }
  }
}

void Integrator::differentiate(const Placement& p, FacetRecord& record) {
  using Scalar = base::Dual<width>;
  record.dofs = dofs_of(p, record);
  const int dofs = static_cast<int>(record.dofs.size());
  record.slope.resize(static_cast<std::size_t>(record.outputs()) * dofs);
  for (int first_dof = 0; first_dof < dofs; first_dof += width) {
    load<Scalar>(p, record, dual_.in, [first_dof](double x, int dof) {
      return dof >= first_dof && dof < first_dof + width ? Scalar::variable(x, dof - first_dof) : Scalar(x);
    });
    integrate(dual_);
    store(record, first_dof);
  }
}

}  // namespace reye::mortar
