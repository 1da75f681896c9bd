#include "mortar/solid/skin.hpp"

#include <algorithm>
#include <sstream>

#include "base/cores.hpp"
#include "base/errors.hpp"
#include "mortar/solid/facet_geometry.hpp"
#include "mortar/solid/facet_integrals.hpp"
#include "mortar/solid/skin_pairs.hpp"

namespace reye::mortar {

namespace {

using base::SparseMatrix;
using base::Triplet;
using base::Vector;
using mesh::Facet;
using mesh::FacetKind;

constexpr int facets_at_once = 32;  ///< that share a work space

void check_side(const Skin& skin) {
  for (const auto& x : skin.x)
    if (!x.allFinite()) throw base::SolveError("a position of a contact is not finite");
  const int points = static_cast<int>(skin.x.size());
  for (const Facet& facet : skin.facets)
    for (int j = 0; j < facet.count(); ++j)
      if (facet.nodes[j] < 0 || facet.nodes[j] >= points)
        throw base::MeshError("a facet of a contact names a point that does not exist");
}

void check(const Skin& secondary, const Skin& primary, const SkinOptions& options) {
  if (!(options.search_mm > 0.0)) {
    std::ostringstream value;
    value << options.search_mm;
    throw base::InputError({{"search_mm", value.str(), "must be above 0"}});
  }
  check_side(secondary);
  check_side(primary);
}

Points3 middles(const Skin& skin) {
  Points3 result;
  result.reserve(skin.facets.size());
  for (const Facet& facet : skin.facets) {
    const int corners = mesh::facet_corners(facet.kind);
    Vec3 middle = Vec3::Zero();
    for (int j = 0; j < corners; ++j) middle += skin.x[facet.nodes[j]] / corners;
    result.push_back(middle);
  }
  return result;
}

/// Radii of spheres round the means of the corners that hold the facets.
Vector radii(const Skin& skin, const Points3& middles) {
  Vector result(static_cast<Eigen::Index>(skin.facets.size()));
  for (std::size_t f = 0; f < skin.facets.size(); ++f) {
    const Facet& facet = skin.facets[f];
    double square = 0.0;
    for (int j = 0; j < facet.count(); ++j)
      square = std::max(square, (skin.x[facet.nodes[j]] - middles[f]).squaredNorm());
    result[static_cast<Eigen::Index>(f)] = (1.0 + 1e-12) * std::sqrt(square);
  }
  return result;
}

FacetCut cut_of(const Facet& facet, const std::vector<char>& carries) {
  FacetCut cut{};
  for (int j = 0; j < facet.count(); ++j) cut[j] = !carries[facet.nodes[j]];
  return cut;
}

/// Points that may carry a multiplier at all.
std::vector<char> eligible(const Skin& skin, SkinDual dual) {
  std::vector<char> marks(skin.x.size(), 1);
  if (dual == SkinDual::quadratic) return marks;
  for (const Facet& facet : skin.facets)
    for (int j = mesh::facet_corners(facet.kind); j < facet.count(); ++j) marks[facet.nodes[j]] = 0;
  return marks;
}

std::span<const int> facets_opposite(const SkinPairs& pairs, int facet) {
  return std::span(pairs.opposite).subspan(pairs.first[facet], pairs.first[facet + 1] - pairs.first[facet]);
}

/// Integrates the facets that are asked for: all, where `fresh` marks none, or there are no integrals yet.
void integrate_facets(const SkinSides& sides, const std::vector<char>& carries, const std::vector<char>& fresh,
                      SkinPairs& pairs) {
  const auto count = sides.secondary.facets.size();
  const bool all = fresh.empty() || pairs.blocks.size() != count;
  pairs.blocks.resize(count);
  base::side_by_side(static_cast<int>(count), facets_at_once, [&](int first, int end) {
    SkinWorkspace w;
    for (int f = first; f < end; ++f) {
      if (!all && !fresh[static_cast<std::size_t>(f)]) continue;
      auto& block = pairs.blocks[static_cast<std::size_t>(f)];
      block.facet = -1;
      if (!place_points(sides, f, facets_opposite(pairs, f), w)) continue;
      integrate_points(sides, cut_of(sides.secondary.facets[f], carries), w);
      block = {f, covered_areas(w), w.D, w.columns};
    }
  });
}

/// Those that take part, in their order.
std::vector<FacetBlock> that_take_part(const std::vector<FacetBlock>& blocks) {
  std::vector<FacetBlock> all;
  for (const auto& block : blocks)
    if (block.facet >= 0) all.push_back(block);
  return all;
}

/// int N_j over the covered part of the side.
Vector covered_by(const Skin& secondary, const std::vector<FacetBlock>& all) {
  Vector covered = Vector::Zero(static_cast<Eigen::Index>(secondary.x.size()));
  for (const auto& block : all) {
    const Facet& facet = secondary.facets[block.facet];
    for (int j = 0; j < facet.count(); ++j) covered[facet.nodes[j]] += block.covered[j];
  }
  return covered;
}

/// Integrates facets again of which a point turned out to be hardly covered.
void renew(const SkinSides& sides, const SkinPairs& pairs, const std::vector<char>& before,
           const std::vector<char>& carries, std::vector<FacetBlock>& all) {
  base::side_by_side(static_cast<int>(all.size()), facets_at_once, [&](int first, int end) {
    SkinWorkspace w;
    for (int k = first; k < end; ++k) {
      auto& block = all[static_cast<std::size_t>(k)];
      const Facet& facet = sides.secondary.facets[block.facet];
      const auto cut = cut_of(facet, carries);
      if (cut == cut_of(facet, before)) continue;
      if (!place_points(sides, block.facet, facets_opposite(pairs, block.facet), w)) {
        block.facet = -1;  // its kept integrals are of a part that has been left since
        continue;
      }
      integrate_points(sides, cut, w);
      block.D = w.D;
      block.columns = w.columns;
    }
  });
  std::erase_if(all, [](const FacetBlock& block) { return block.facet < 0; });
}

/// One matrix from its entries per facet: `entries(block, j, add)` adds those of row j.
template <class Entries>
SparseMatrix assembled(const SkinSides& sides, const std::vector<FacetBlock>& all, const std::vector<char>& carries,
                       std::size_t columns, Entries entries) {
  std::vector<Triplet> triplets;
  for (const auto& block : all) {
    const Facet& facet = sides.secondary.facets[block.facet];
    for (int j = 0; j < facet.count(); ++j)
      if (carries[facet.nodes[j]])
        entries(block, j, [&](int column, double value) { triplets.emplace_back(facet.nodes[j], column, value); });
  }
  SparseMatrix matrix(static_cast<Eigen::Index>(sides.secondary.x.size()), static_cast<Eigen::Index>(columns));
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

/// Takes away the multipliers of points that are hardly covered; whether there were any.
bool drop_bare(const Vector& covered, const Vector& area, std::vector<char>& carries) {
  bool dropped = false;
  for (std::size_t j = 0; j < carries.size(); ++j) {
    const auto i = static_cast<Eigen::Index>(j);
    if (!carries[j] || (covered[i] >= least_covered * area[i] && covered[i] > 0.0)) continue;
    carries[j] = 0;
    dropped = true;
  }
  return dropped;
}

void assemble(const SkinSides& sides, const std::vector<FacetBlock>& all, SkinIntegrals& out) {
  const std::size_t own = sides.secondary.x.size(), others = sides.primary.x.size();
  out.D = assembled(sides, all, out.carries, own, [&](const FacetBlock& block, int j, auto add) {
    const Facet& facet = sides.secondary.facets[block.facet];
    for (int k = 0; k < facet.count(); ++k)
      if (k == j || !out.carries[facet.nodes[k]]) add(facet.nodes[k], block.D[j][k]);
  });
  const auto over_columns = [&](FacetValues SkinColumn::*values) {
    return assembled(sides, all, out.carries, others, [&, values](const FacetBlock& block, int j, auto add) {
      for (const auto& column : block.columns) add(column.primary, (column.*values)[j]);
    });
  };
  out.M = over_columns(&SkinColumn::M);
  out.T = over_columns(&SkinColumn::T);
  out.covered = out.D * Vector::Ones(out.D.cols());
}

}  // namespace

SkinIntegrals integrate(const Skin& secondary, const Skin& primary, const SkinOptions& options) {
  SkinPairs pairs;
  return integrate(secondary, primary, options, pairs);
}

SkinIntegrals integrate(const Skin& secondary, const Skin& primary, const SkinOptions& options, SkinPairs& pairs,
                        const std::vector<char>& fresh) {
  check(secondary, primary, options);
  if (!pairs_hold(pairs, secondary, primary, options.search_mm))
    find_pairs(secondary, primary, options.search_mm, pairs);
  const Points3 normals = facet_normals(primary);
  const Points3 means = middles(primary);
  const Vector around = radii(primary, means);
  const SkinSides sides{secondary, primary, normals, means, around, options.search_mm};
  SkinIntegrals out;
  out.carries = eligible(secondary, options.dual);
  out.area = nodal_areas(secondary);
  integrate_facets(sides, out.carries, fresh, pairs);
  auto all = that_take_part(pairs.blocks);
  auto before = out.carries;
  bool bare = drop_bare(covered_by(secondary, all), out.area, out.carries);
  for (;;) {
    if (bare) renew(sides, pairs, before, out.carries, all);
    assemble(sides, all, out);
    before = out.carries;
    // The basis beside a point that lost its multiplier is another one, and may leave its neighbours bare.
    bare = drop_bare(out.covered, out.area, out.carries);
    if (!bare) break;
  }
  out.covers.assign(secondary.facets.size(), 0);
  for (const auto& block : all) out.covers[block.facet] = 1;
  out.normal = nodal_normals(secondary, out.covers);
  return out;
}

}  // namespace reye::mortar
