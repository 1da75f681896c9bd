#include "mortar/integrate.hpp"

#include <algorithm>

namespace reye::mortar {

namespace {

/// The nodes whose motion turns the normals of a facet: neighbour before, its two nodes, neighbour after.
std::array<int, 4> stencil_of(const Surface& s, int facet) {
  const auto [a, b] = s.facets[facet];
  std::array<int, 4> nodes{-1, a, b, -1};
  if (s.before[a] >= 0 && !s.corner[a]) nodes[0] = s.facets[s.before[a]][0];
  if (s.after[b] >= 0 && !s.corner[b]) nodes[3] = s.facets[s.after[b]][1];
  return nodes;
}

std::vector<int> dofs_of(const Placement& p, const FacetRecord& record) {
  std::vector<int> dofs;
  for (int node : stencil_of(*p.secondary, record.facet))
    if (node >= 0) dofs.insert(dofs.end(), {2 * node, 2 * node + 1});
  for (int l : record.primaries) dofs.insert(dofs.end(), {p.secondary_dofs() + 2 * l, p.secondary_dofs() + 2 * l + 1});
  return dofs;
}

/// Hands out the positions of a facet as scalars T; `make(value, local dof)` decides on the seed.
template <class T, class Make>
void load(const Placement& p, const FacetRecord& record, FacetInput<T>& in, Make make) {
  const Surface& s = *p.secondary;
  int dof = 0;
  const auto next = [&](const Vec2& x) {
    Pair<T> result{make(x.x(), dof), make(x.y(), dof + 1)};
    dof += 2;
    return result;
  };
  const auto nodes = stencil_of(s, record.facet);
  std::array<Pair<T>, 4> x;
  for (int i = 0; i < 4; ++i)
    if (nodes[i] >= 0) x[i] = next(p.xs[nodes[i]]);
  const Pair<T> own = facet_normal(x[1], x[2]);
  in.x = {x[1], x[2]};
  in.n = {nodes[0] < 0 ? own : averaged(facet_normal(x[0], x[1]), own),
          nodes[3] < 0 ? own : averaged(own, facet_normal(x[2], x[3]))};
  for (int j = 0; j < 2; ++j) {
    in.X[j] = s.X[nodes[1 + j]];
    in.x_before[j] = p.xs_before[nodes[1 + j]];
    in.cut[j] = p.cut[nodes[1 + j]] != 0;
  }
  in.xm.clear();
  in.xm_before.clear();
  for (int l : record.primaries) {
    in.xm.push_back(next(p.xm[l]));
    in.xm_before.push_back(p.xm_before[l]);
  }
  in.pairs = record.pairs;
  in.analysis = p.analysis;
  in.search = p.search;
}

double plain_value(double x, int) { return x; }

}  // namespace

NormalStencil normal_stencil(const Surface& s, int node, int at_corner) {
  NormalStencil stencil;
  stencil.nodes[1] = node;
  const bool before = s.before[node] >= 0 && !(s.corner[node] && at_corner == 1);
  const bool after = s.after[node] >= 0 && !(s.corner[node] && at_corner == 0);
  if (before) stencil.nodes[0] = s.facets[s.before[node]][0];
  if (after) stencil.nodes[2] = s.facets[s.after[node]][1];
  return stencil;
}

/// Finds the primary facets that may lie opposite: near, and not wholly on one side of the facet's two rays.
bool Integrator::pair_up(const Placement& p, int facet, FacetRecord& record) {
  record.facet = facet;
  record.primaries.clear();
  record.pairs.clear();
  record.slope.clear();
  load<double>(p, record, plain_.in, plain_value);
  const auto& in = plain_.in;
  const Surface& m = *p.primary;
  const Vec2 x0 = plain(in.x[0]), x1 = plain(in.x[1]), n0 = plain(in.n[0]), n1 = plain(in.n[1]);
  const Vec2 middle = 0.5 * (x0 + x1);
  const double reach = p.search + 0.5 * (x1 - x0).norm();
  local_.resize(m.X.size(), -1);
  for (const auto& pair_nodes : m.facets) {
    if (!p.near(p.primary_near, pair_nodes)) continue;
    const auto [a, b] = pair_nodes;
    const Vec2 edge = p.xm[b] - p.xm[a];
    if ((p.xm[a] + 0.5 * edge - middle).norm() > reach + 0.5 * edge.norm()) continue;
    if ((x1 - x0).dot(edge) >= 0.0) continue;
    if (base::cross(n0, p.xm[a] - x0) <= 0.0 || base::cross(n1, p.xm[b] - x1) >= 0.0) continue;
    std::array<int, 2> pair{};
    for (int e = 0; e < 2; ++e) {
      const int node = e == 0 ? a : b;
      if (local_[node] < 0) {
        local_[node] = static_cast<int>(record.primaries.size());
        record.primaries.push_back(node);
      }
      pair[e] = local_[node];
    }
    record.pairs.push_back(pair);
  }
  for (int node : record.primaries) local_[node] = -1;
  return !record.pairs.empty();
}

std::vector<FacetRecord>& Integrator::values(const Placement& p) {
  records_.resize(p.secondary->facets.size());
  used_ = 0;
  for (int facet = 0; facet < p.secondary->facet_count(); ++facet) {
    if (!p.near(p.secondary_near, p.secondary->facets[facet])) continue;
    FacetRecord& record = records_[used_];
    if (!pair_up(p, facet, record)) continue;
    load<double>(p, record, plain_.in, plain_value);
    integrate(plain_);
    if (plain_.points.empty()) continue;
    std::swap(record.value, plain_.out);
    ++used_;
  }
  records_.resize(used_);
  return records_;
}

void Integrator::renew(const Placement& p, FacetRecord& record) {
  load<double>(p, record, plain_.in, plain_value);
  integrate(plain_);
  std::swap(record.value, plain_.out);
}

void Integrator::differentiate(const Placement& p, FacetRecord& record) {
  using Scalar = base::Dual<width>;
  record.dofs = dofs_of(p, record);
  const int dofs = static_cast<int>(record.dofs.size()), primaries = static_cast<int>(record.primaries.size());
  record.slope.resize(static_cast<std::size_t>(record.outputs()) * dofs);
  for (int first = 0; first < dofs; first += width) {
    load<Scalar>(p, record, dual_.in, [first](double x, int dof) {
      return dof >= first && dof < first + width ? Scalar::variable(x, dof - first) : Scalar(x);
    });
    integrate(dual_);
    const int count = std::min(width, dofs - first);
    const auto store = [&](int output, const Scalar& q) {
      std::copy_n(q.d.begin(), count, record.slope.begin() + output * dofs + first);
    };
    const auto& out = dual_.out;
    for (int j = 0; j < 2; ++j) {
      store(FacetRecord::D(j), out.D[j]);
      store(FacetRecord::off(j), out.off[j]);
      store(FacetRecord::gap(j), out.gap[j]);
      store(FacetRecord::offset(j), out.offset[j].x);
      store(FacetRecord::offset(j) + 1, out.offset[j].y);
      store(FacetRecord::drift(j), out.drift[j].x);
      store(FacetRecord::drift(j) + 1, out.drift[j].y);
      for (int l = 0; l < primaries; ++l) {
        store(record.M(j, l), out.M[j][l]);
        store(record.cover(j, l), out.cover[j][l]);
      }
    }
  }
}

}  // namespace reye::mortar
