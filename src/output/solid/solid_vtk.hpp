#pragma once
#include <array>
#include <string>
#include <vector>

#include "sim/solid/solid_records.hpp"

/// ParaView files of one state of solids, and their contact surfaces read back.
namespace reye::output {

/// All bodies as one unstructured grid (.vtu, inline binary) on x = X + u: tetrahedra of first or second order or
/// hexahedra; a rigid body is its skin. Points: displacement, reference_position (X) [mm], stress (XX, YY, ZZ, XY, YZ,
/// XZ), von_mises [MPa]; zero stress where a body has none. Cells: body (index in the frame). Field data: TimeValue =
/// cycles, body_names, units.
std::string solid_bodies_vtu(const sim::SolidFrame& frame);

/// All contact surfaces as triangles and quadrilaterals (.vtp) on x; a facet of second order is four triangles.
/// Points: reference_position [mm], pressure_MPa, shear_MPa, slip_mm, normal (three components each but pressure),
/// turn_rad (rotation vector of a body that turns), area_mm2, status. Cells: surface (index in the frame), side (0
/// secondary, 1 primary), body. Field data as above, and of each surface contact_names, surface_side, surface_points
/// (how many points it has; they follow one another).
std::string skins_vtp(const sim::SolidFrame& frame);

/// One side of a contact, as a frame holds it, on X: vectors of a body that has turned are turned back.
struct DrawnSkin {
  std::string contact;
  bool secondary = true;
  base::Points3 X, shear_MPa, slip_mm, normal;
  std::vector<double> pressure_MPa, area_mm2, wear_depth_mm;
  std::vector<int> status;
  std::vector<std::vector<int>> facets;  ///< corners over the rows, three or four, counter-clockwise from outside
};

struct DrawnSkins {
  double cycle = 0.0;
  std::vector<DrawnSkin> all;
};

/// Reads a .vtp that `skins_vtp` made; throws base::InputError when it cannot.
DrawnSkins read_drawn_skins(const std::string& path);

}  // namespace reye::output
