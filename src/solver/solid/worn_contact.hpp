#pragma once
#include <vector>

#include "contact/solid/skin_wear.hpp"
#include "solver/solid/increment_state.hpp"
#include "solver/solid/reduced_system.hpp"

/// Wear of one contact while its increment is being solved.
namespace reye::solver {

/// What the two sides have lost: before the increment, as the gaps see it, and in it, point by point. Empty where the
/// contact does not wear.
struct WornContact {
  contact::SkinOpenings openings;
  Vector opened_before;                 ///< per secondary point [mm]
  std::vector<contact::SkinWorn> worn;  ///< per secondary point
};

/// The openings where the sides are now, by what waits in the gap, or is seen there.
WornContact worn_contact(const contact::SkinSetup& setup, const contact::SkinPlace& place,
                         const contact::SkinWear& before, const contact::SkinWearing& wearing = {});

/// Wears the points that slide and opens the gaps of `nodes` by it. `wears` says which may.
void wear_points(const contact::SkinSetup& setup, const contact::SkinPlace& place, const contact::SkinWear& before,
                 const contact::SkinWearing& wearing, const std::vector<char>& wears,
                 std::vector<contact::SkinNode>& nodes, WornContact& contact);

/// Adds the rows of wear of one contact. `normal_row` per secondary point: the place of its equation of normal contact
/// among the rows, -1 where it is open.
void add_wear_rows(const contact::SkinSetup& setup, const WornContact& contact, int number,
                   const std::vector<int>& normal_row, std::vector<WearRow>& rows);

}  // namespace reye::solver
