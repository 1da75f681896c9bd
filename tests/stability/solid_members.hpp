#pragma once
#include <string>
#include <vector>

#include "support/solid_problem.hpp"

/// Small scenes of two solids at the rim of what can be asked, each with how it must end.
namespace reye::test {

enum class SolidPath { to_and_fro, round, lift };

/// A block on a block: the upper one's rigid top is pressed down and moved, the lower one's bottom is fixed.
struct SolidMember {
  std::string group, name;
  mesh::SolidKind lower = mesh::SolidKind::hex8, upper = mesh::SolidKind::hex8;
  std::array<int, 3> lower_parts{6, 6, 2}, upper_parts{5, 5, 2};
  base::Vec3 lo{-0.4, -0.4, 0.0}, hi{0.4, 0.4, 0.5};  ///< of the upper block; the lower one is 1.2 x 1.2 x 0.5 mm
  double crown_mm = 0.0;                              ///< > 0: radius of the upper block's lower face
  double noise = 0.0;  ///< moves of inner nodes and of those on the faces, over an element
  double mu = 0.3, E_lower = 2e5, E_upper = 2e5, nu = 0.3;
  bool rigid_upper = false, lower_is_secondary = true, linear = false;
  double gap_mm = 0.0, press_mm = 1e-3, slide_mm = 1e-3;
  double force_N = 0.0;  ///< not zero: the top is pressed by a force and may turn
  SolidPath path = SolidPath::to_and_fro;
  int increments = 8;
  double wear_per_MPa =
      0.0;               ///< > 0: both sides wear by Archard's law over three blocks of a thousand cycles, and move
  int remesh_every = 0;  ///< > 0: bodies of tetrahedra are remeshed after each so many blocks
  double length = 1.0, force = 1.0;  ///< units: numbers are written in so many mm and N
  double balance = 1e-10;            ///< to which forces and moments balance
  std::string refusal;               ///< what the reason must say of a member that cannot be done
  std::string like;                  ///< the member whose figures this one must repeat
};

const std::vector<SolidMember>& solid_members();

/// The members that can be done, worn: those in other units and the linear dual basis, which does not wear, apart.
std::vector<SolidMember> worn_solid_members();

/// These of tetrahedra throughout, remeshed after every block: the load step and each thousand cycles.
std::vector<SolidMember> remeshed_solid_members();

}  // namespace reye::test
