#pragma once
#include <vector>

#include "mortar/solid/facet_integrals.hpp"
#include "mortar/solid/skin.hpp"

namespace reye::mortar {

/// Facets that may face each other: those whose boxes come within the search distance, and a margin. They serve until a
/// point of a side has moved so far that another pair might have come near; integrals over them are the same to the
/// last bit as over pairs found at each call.
struct SkinPairs {
  double margin_mm = 0.0;          ///< 0: half the mean size of the secondary facets; set before the first use
  double search_mm = 0.0;          ///< for which they were found
  double reach_mm = 0.0;           ///< the margin they were found with
  Skin secondary, primary;         ///< for which they were found
  Points3 normals;                 ///< of the secondary facets then
  std::vector<int> first;          ///< per secondary facet its first entry of `opposite`, and one past the last
  std::vector<int> opposite;       ///< primary facets, ascending per secondary facet
  std::vector<FacetBlock> blocks;  ///< the last integrals of each secondary facet over these pairs; none yet: empty
};

/// Finds the pairs; `margin_mm` of `pairs` is kept.
void find_pairs(const Skin& secondary, const Skin& primary, double search_mm, SkinPairs& pairs);

/// Whether no pair can be missing: the same facets, at least the same search, and the largest motions of a point of
/// each side add up to no more than the margin.
bool pairs_hold(const SkinPairs& pairs, const Skin& secondary, const Skin& primary, double search_mm);

}  // namespace reye::mortar
