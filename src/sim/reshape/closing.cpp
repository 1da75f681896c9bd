#include "sim/reshape/closing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algebra/factor.hpp"
#include "algebra/product.hpp"

namespace reye::sim {

namespace {

using Values = std::vector<double>;

/// The weighted gaps of a contact, and the moves of both sides so far.
struct Gaps {
  const contact::Setup& setup;
  const std::vector<contact::MortarRow>& rows;
  Values gap;    ///< weighted
  Values rates;  ///< closing of a node's gap per length of a motion of the whole secondary side
  SideShift secondary, primary;

  /// The weighted gap of a node that the moves have not closed.
  double left(std::size_t j) const {
    double sum = gap[j] - rows[j].D * secondary.by[j];
    for (const auto& [k, share] : rows[j].off) sum -= share * secondary.by[k];
    for (const auto& [l, M] : rows[j].M) sum -= M * primary.by[l];
    return sum;
  }
};

SideShift side_of(const mortar::Surface& surface, const Values& removed, double coefficient) {
  SideShift side;
  const std::size_t n = surface.X.size();
  side.room.assign(n, 0.0);
  side.loaded.assign(n, 0);
  side.by.assign(n, 0.0);
  side.free.assign(n, 0.0);
  if (coefficient == 0.0) return side;
  const auto depth = [&](int k) {
    return removed[static_cast<std::size_t>(k)] / surface.area[static_cast<std::size_t>(k)];
  };
  for (const auto& facet : surface.facets)
    for (int k : facet)
      for (int beside : facet)
        if (k >= 0 && beside >= 0) side.room[k] = std::max(side.room[k], depth(beside));
  return side;
}

double limited(double by, const SideShift& side, std::size_t k) { return std::clamp(by, -side.room[k], side.room[k]); }

/// Control points without multiplier move by the mean of the nodes beside them.
void fill_between(const contact::Setup& setup, SideShift& side) {
  for (const auto& [a, b, c] : setup.secondary.facets) {
    if (c < 0 || !setup.between(c)) continue;
    side.by[c] = limited(0.5 * (side.by[a] + side.by[b]), side, static_cast<std::size_t>(c));
    side.loaded[c] = side.loaded[a] && side.loaded[b];
  }
}

/// Each loaded node closes its own gap: D is diagonal but for control points, hence the turns.
void close_by_secondary(Gaps& c) {
  constexpr int turns = 8;
  for (int turn = 0; turn < turns; ++turn) {
    for (std::size_t j = 0; j < c.rows.size(); ++j)
      if (c.secondary.loaded[j] && !c.setup.between(static_cast<int>(j)))
        c.secondary.by[j] = limited(c.secondary.by[j] + c.left(j) / c.rows[j].carried(), c.secondary, j);
    fill_between(c.setup, c.secondary);
  }
}

std::vector<std::size_t> loaded_nodes(const Gaps& c) {
  std::vector<std::size_t> nodes;
  for (std::size_t j = 0; j < c.rows.size(); ++j)
    if (c.secondary.loaded[j] && !c.setup.between(static_cast<int>(j))) nodes.push_back(j);
  return nodes;
}

/// M_jl of these nodes and of the primary nodes that have room, each row over the root of its length.
base::Matrix scaled_M(const Gaps& c, const std::vector<std::size_t>& nodes) {
  base::Matrix B =
      base::Matrix::Zero(static_cast<Eigen::Index>(nodes.size()), static_cast<Eigen::Index>(c.primary.by.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (const auto& [l, M] : c.rows[nodes[i]].M)
      if (c.primary.room[l] > 0.0) B(static_cast<Eigen::Index>(i), l) = M / std::sqrt(c.rows[nodes[i]].carried());
  return B;
}

/// B^T B, damped, so that it is regular.
base::Matrix damped_normal_matrix(const base::Matrix& B) {
  constexpr double damping = 1e-3;
  Vector diagonal = damping * B.colwise().squaredNorm().transpose();
  for (double& d : diagonal)
    if (d == 0.0) d = 1.0;
  base::Matrix normal = algebra::transposed_product(B, B);
  normal.diagonal() += diagonal;
  return normal;
}

/// The least moves of the primary that close the gap left by the secondary, sum_l M_jl b_l = left_j in least squares.
void close_by_primary(Gaps& c) {
  const auto nodes = loaded_nodes(c);
  const base::Matrix B = scaled_M(c, nodes);
  const algebra::DenseCholesky factor(damped_normal_matrix(B));
  constexpr int turns = 3;  // each closes the part that damping has left
  for (int turn = 0; turn < turns; ++turn) {
    Vector r(B.rows());
    for (std::size_t i = 0; i < nodes.size(); ++i)
      r[static_cast<Eigen::Index>(i)] = c.left(nodes[i]) / std::sqrt(c.rows[nodes[i]].carried());
    const Vector b = factor.solve(B.transpose() * r);
    for (Eigen::Index l = 0; l < b.size(); ++l)
      c.primary.by[l] = limited(c.primary.by[l] + b[l], c.primary, static_cast<std::size_t>(l));
  }
}

contact::Interface meeting(const contact::Setup& setup, const contact::ContactState& contact, const solver::Sides& at) {
  contact::IncrementOptions options;
  options.held = true;
  contact::Interface face;
  face.begin(setup, contact, at.secondary, at.primary, options);
  face.integrate(at.secondary, at.primary);
  return face;
}

/// The direction in which the secondary is pressed, the axis in axisymmetry; zero where the contact goes round the
/// body, so that all nodes count alike.
Vec2 pressed_along(const contact::Interface& face, const HeldTraction& held) {
  Vec2 load = Vec2::Zero();
  double all = 0.0;
  for (std::size_t j = 0; j < held.normal.size(); ++j) {
    const double force = std::max(held.normal[j], 0.0);
    load += force * face.normal()[j];
    all += force;
  }
  if (face.setup().analysis == base::Analysis::axisymmetric) load.x() = 0.0;
  constexpr double least = 0.2;
  return load.norm() > least * all ? Vec2(load.normalized()) : Vec2(Vec2::Zero());
}

/// Closing of the gap of each secondary node when its whole side moves along e, per length: n . e, except beside a
/// corner, where n is not that of the facets it meets.
Values closed_by(const Vec2& e, const contact::Interface& face, const contact::ContactState& contact,
                 solver::Sides at) {
  const auto& setup = face.setup();
  double length = 0.0;
  for (double A : setup.secondary.area) length = std::max(length, A);
  const double step = 1e-5 * length;
  for (Vec2& x : at.secondary) x += step * e;
  const auto moved = meeting(setup, contact, at);
  Values rates;
  for (std::size_t j = 0; j < face.rows().size(); ++j) {
    const double D = face.rows()[j].carried();
    rates.push_back(D > 0.0 ? (face.gap()[j] - moved.gap()[j]) / (D * step) : 0.0);
  }
  return rates;
}

/// Subtracts the distance of the sides as a whole from the gaps: it belongs to the support, and moves no content.
void bring_together(Gaps& c) {
  double apart = 0.0, closed = 0.0;
  for (std::size_t j = 0; j < c.rows.size(); ++j) {
    if (!c.secondary.loaded[j]) continue;
    apart += c.gap[j];
    closed += c.rows[j].carried() * c.rates[j];
  }
  if (!(closed > 0.0)) return;
  for (std::size_t j = 0; j < c.rows.size(); ++j) c.gap[j] -= apart / closed * c.rows[j].carried() * c.rates[j];
}

/// The free motion that restores the content: under the contact a motion of the whole side against its load, which
/// changes no pressure.
void free_motion(Gaps& c) {
  Values met(c.primary.by.size(), 0.0), sum = met;
  for (std::size_t j = 0; j < c.rows.size(); ++j) {
    if (!c.secondary.loaded[j]) continue;
    const double along = std::max(0.0, c.rates[j]);
    if (c.secondary.room[j] > 0.0) c.secondary.free[j] = along;
    for (const auto& [l, M] : c.rows[j].M) {
      met[l] += std::abs(M);
      sum[l] += std::abs(M) * along;
    }
  }
  for (std::size_t l = 0; l < met.size(); ++l) {
    c.primary.loaded[l] = met[l] > 0.0;
    if (met[l] > 0.0 && c.primary.room[l] > 0.0) c.primary.free[l] = sum[l] / met[l];
  }
}

/// Nodes of a surface chain by chain, control points in their places.
std::vector<std::vector<int>> lines(const mortar::Surface& surface) {
  std::vector<std::vector<int>> all;
  for (int f = 0; f < surface.facet_count(); ++f) {
    const auto [a, b, c] = surface.facets[f];
    if (all.empty() || all.back().back() != a) all.push_back({a});
    if (c >= 0) all.back().push_back(c);
    all.back().push_back(b);
  }
  return all;
}

/// Beyond its ends a motion continues for a facet, so that an open gap beside it stays as open, and fades out over two
/// more.
void fade_out(const mortar::Surface& surface, SideShift& side) {
  const int whole = surface.order, reach = 3 * surface.order;
  for (const auto& line : lines(surface))
    for (int way : {1, -1})
      for (int i = 0; i < static_cast<int>(line.size()); ++i) {
        if (!side.loaded[line[i]]) continue;
        for (int k = 1; k <= reach; ++k) {
          const int at = i + way * k;
          if (at < 0 || at >= static_cast<int>(line.size()) || side.loaded[line[at]]) break;
          const double share = k <= whole ? 1.0 : 1.0 - (k - whole) / (reach - whole + 1.0);
          const auto node = static_cast<std::size_t>(line[at]);
          if (side.room[node] == 0.0) continue;
          side.by[node] = limited(share * side.by[line[i]], side, node);
          side.free[node] = share * side.free[line[i]];
        }
      }
}

/// Keeps open nodes of the secondary open, and moves overlapping ones back.
void keep_open(Gaps& c) {
  for (std::size_t j = 0; j < c.rows.size(); ++j) {
    const double D = c.rows[j].carried();
    if (c.secondary.loaded[j] || c.setup.cut[j] || D <= 0.0) continue;
    const double room = c.left(j) / D;
    if (room < 0.0) c.secondary.by[j] = limited(c.secondary.by[j] + room, c.secondary, j);
  }
}

void close(Gaps& c) {
  bring_together(c);
  if (any_moved(c.secondary.room)) close_by_secondary(c);
  if (any_moved(c.primary.room)) close_by_primary(c);
  free_motion(c);
  fade_out(c.setup.secondary, c.secondary);
  fade_out(c.setup.primary, c.primary);
  keep_open(c);
}

Gaps gaps_of(const contact::Interface& face, const contact::ContactState& contact, const solver::Sides& at,
             const HeldTraction& held) {
  const auto& setup = face.setup();
  const auto& law = setup.options.wear;
  const Vec2 e = pressed_along(face, held);
  Gaps c{setup,
         face.rows(),
         face.gap(),
         e.isZero() ? Values(face.gap().size(), 1.0) : closed_by(e, face, contact, at),
         side_of(setup.secondary, contact.removed_secondary, law.secondary),
         side_of(setup.primary, contact.removed_primary, law.primary)};
  for (std::size_t j = 0; j < c.rows.size(); ++j)
    c.secondary.loaded[j] = held.normal[j] > 0.0 && !setup.cut[j] && face.touching(static_cast<int>(j));
  return c;
}

}  // namespace

bool any_moved(const Values& v) {
  return std::any_of(v.begin(), v.end(), [](double x) { return x != 0.0; });
}

Closing closing_of(const contact::Setup& setup, const contact::ContactState& contact, const solver::Sides& at,
                   const HeldTraction& held) {
  const auto face = meeting(setup, contact, at);
  Gaps c = gaps_of(face, contact, at, held);
  close(c);
  Closing closing;
  for (std::size_t j : loaded_nodes(c))
    closing.left_mm = std::max(closing.left_mm, std::abs(c.left(j)) / c.rows[j].carried());
  for (const auto* side : {&c.secondary, &c.primary})
    for (double by : side->by) closing.moved_mm = std::max(closing.moved_mm, std::abs(by));
  closing.secondary = std::move(c.secondary);
  closing.primary = std::move(c.primary);
  return closing;
}

}  // namespace reye::sim
