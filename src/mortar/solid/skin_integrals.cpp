#include "mortar/solid/skin.hpp"

#include <algorithm>
#include <sstream>

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

/// The integrals of one facet, whose columns stand in a list of all.
struct FacetBlock {
  int facet = 0;
  std::size_t first = 0, count = 0;
  std::array<FacetValues, mesh::most_facet_nodes> D{};
};

/// What the facets give, before they are added up.
struct FacetBlocks {
  std::vector<FacetBlock> blocks;
  std::vector<SkinColumn> columns;
  Vector covered;  ///< int N_j over the covered part
};

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

/// Radii of spheres round the means of the corners that hold the facets.
Vector radii(const Skin& skin) {
  Vector result(static_cast<Eigen::Index>(skin.facets.size()));
  for (std::size_t f = 0; f < skin.facets.size(); ++f) {
    const Facet& facet = skin.facets[f];
    const int corners = mesh::facet_corners(facet.kind);
    Vec3 middle = Vec3::Zero();
    for (int j = 0; j < corners; ++j) middle += skin.x[facet.nodes[j]] / corners;
    double square = 0.0;
    for (int j = 0; j < facet.count(); ++j) square = std::max(square, (skin.x[facet.nodes[j]] - middle).squaredNorm());
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

void take(const SkinWorkspace& w, FacetBlock& block, FacetBlocks& all) {
  block.D = w.D;
  std::copy(w.columns.begin(), w.columns.end(), all.columns.begin() + static_cast<std::ptrdiff_t>(block.first));
}

FacetBlocks all_facets(const SkinSides& sides, const SkinPairs& pairs, const std::vector<char>& carries,
                       SkinWorkspace& w) {
  FacetBlocks all;
  all.covered = Vector::Zero(static_cast<Eigen::Index>(sides.secondary.x.size()));
  for (int f = 0; f < static_cast<int>(sides.secondary.facets.size()); ++f) {
    const auto opposite = std::span(pairs.opposite).subspan(pairs.first[f], pairs.first[f + 1] - pairs.first[f]);
    if (!place_points(sides, f, opposite, w)) continue;
    const Facet& facet = sides.secondary.facets[f];
    const auto areas = covered_areas(w);
    for (int j = 0; j < facet.count(); ++j) all.covered[facet.nodes[j]] += areas[j];
    integrate_points(sides, cut_of(facet, carries), w);
    FacetBlock block{f, all.columns.size(), w.columns.size(), {}};
    all.columns.resize(block.first + block.count);
    take(w, block, all);
    all.blocks.push_back(block);
  }
  return all;
}

/// Integrates facets again of which a point turned out to be hardly covered.
void renew(const SkinSides& sides, const SkinPairs& pairs, const std::vector<char>& before,
           const std::vector<char>& carries, SkinWorkspace& w, FacetBlocks& all) {
  for (auto& block : all.blocks) {
    const Facet& facet = sides.secondary.facets[block.facet];
    const auto cut = cut_of(facet, carries);
    if (cut == cut_of(facet, before)) continue;
    const int first = pairs.first[block.facet];
    place_points(sides, block.facet, std::span(pairs.opposite).subspan(first, pairs.first[block.facet + 1] - first), w);
    integrate_points(sides, cut, w);
    take(w, block, all);
  }
}

/// One matrix from its entries per facet: `entries(block, j, add)` adds those of row j.
template <class Entries>
SparseMatrix assembled(const SkinSides& sides, const FacetBlocks& all, const std::vector<char>& carries,
                       std::size_t columns, Entries entries) {
  std::vector<Triplet> triplets;
  for (const auto& block : all.blocks) {
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

void assemble(const SkinSides& sides, const FacetBlocks& all, SkinIntegrals& out) {
  const std::size_t own = sides.secondary.x.size(), others = sides.primary.x.size();
  out.D = assembled(sides, all, out.carries, own, [&](const FacetBlock& block, int j, auto add) {
    const Facet& facet = sides.secondary.facets[block.facet];
    for (int k = 0; k < facet.count(); ++k)
      if (k == j || !out.carries[facet.nodes[k]]) add(facet.nodes[k], block.D[j][k]);
  });
  const auto over_columns = [&](FacetValues SkinColumn::*values) {
    return assembled(sides, all, out.carries, others, [&, values](const FacetBlock& block, int j, auto add) {
      for (std::size_t c = block.first; c < block.first + block.count; ++c)
        add(all.columns[c].primary, (all.columns[c].*values)[j]);
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

SkinIntegrals integrate(const Skin& secondary, const Skin& primary, const SkinOptions& options, SkinPairs& pairs) {
  check(secondary, primary, options);
  if (!pairs_hold(pairs, secondary, primary, options.search_mm))
    find_pairs(secondary, primary, options.search_mm, pairs);
  const Points3 normals = facet_normals(primary);
  const Vector around = radii(primary);
  const SkinSides sides{secondary, primary, normals, around, options.search_mm};
  SkinWorkspace w;
  SkinIntegrals out;
  out.carries = eligible(secondary, options.dual);
  out.area = nodal_areas(secondary);
  auto all = all_facets(sides, pairs, out.carries, w);
  auto before = out.carries;
  bool bare = drop_bare(all.covered, out.area, out.carries);
  for (;;) {
    if (bare) renew(sides, pairs, before, out.carries, w, all);
    assemble(sides, all, out);
    before = out.carries;
    // The basis beside a point that lost its multiplier is another one, and may leave its neighbours bare.
    bare = drop_bare(out.covered, out.area, out.carries);
    if (!bare) break;
  }
  out.covers.assign(secondary.facets.size(), 0);
  for (const auto& block : all.blocks) out.covers[block.facet] = 1;
  out.normal = nodal_normals(secondary, out.covers);
  return out;
}

}  // namespace reye::mortar
