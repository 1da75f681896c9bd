#pragma once
#include <string>
#include <vector>

#include "base/part.hpp"
#include "base/space.hpp"
#include "mortar/solid/skin.hpp"
#include "wear/law.hpp"

namespace reye::contact {

/// Sliding that is imposed on a contact: a vector, or a turn about an axis; it slides the secondary side against the
/// primary.
struct ImposedSliding {
  base::Vec3 direction = base::Vec3::Zero();  ///< unit; zero: a turn
  base::Vec3 point_mm = base::Vec3::Zero(), axis = base::Vec3::Zero();
  base::Parts parts{};  ///< mm, or rad
};

/// A contact of a scene of solids: one secondary face (it carries the multipliers) against a list of primary ones.
struct SkinContactOptions {
  std::string name;
  std::string secondary;
  std::vector<std::string> primary;
  double friction = 0.0;  ///< Coulomb's coefficient mu >= 0
  std::vector<ImposedSliding> sliding{};
  wear::Law wear{};
  bool implicit_wear = true;  ///< wear enters the conditions of its own increment
  mortar::SkinDual dual = mortar::SkinDual::quadratic;
  double search_mm = 0.0;  ///< facets farther apart than this are not paired; 0: chosen from the bodies
};

}  // namespace reye::contact
