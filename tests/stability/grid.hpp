#pragma once
#include <string>

/// Two blocks of structured elements, written as gmsh files: the mesh is part of the member, to the last digit.
namespace reye::test {

enum class Element { quad4, quad8, tri3, tri6 };

/// A block [x0, x1] x [y0, y0 + height] of nx x ny elements.
struct Block {
  double x0 = 0.0, x1 = 1.0, y0 = 0.0, height = 1.0;
  int nx = 8, ny = 4;
  Element element = Element::quad4;
  double grade_x = 1.0;   ///< power by which columns crowd about the middle
  double grade_y = 1.0;   ///< power by which rows crowd at the contact
  double crown_mm = 0.0;  ///< radius of the contact edge; 0: straight
  double distort = 0.0;   ///< inner nodes are moved at random by so many times the size of their element
  double noise = 0.0;     ///< all nodes are moved at random by so many times the block's width
};

/// The slider lies on the base: its bottom meets the base's top.
struct Blocks {
  Block slider, base;
  unsigned seed = 1;
};

/// The gmsh files (2.2) of both, all coordinates times `length`: surface "slider" with curves "slider_bottom" and
/// "slider_top", the same of "base".
std::string slider_file(const Blocks& blocks, double length);
std::string base_file(const Blocks& blocks, double length);

}  // namespace reye::test
