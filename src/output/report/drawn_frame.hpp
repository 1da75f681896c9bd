#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/linalg.hpp"

/// Frames read back as drawings.
namespace reye::output {

/// An edge of an element, or of a rigid body's outline: corner, mid node (-1: none), corner.
struct DrawnEdge {
  int from = 0, mid = -1, to = 0;
  int body = 0;
  bool outline = false;  ///< of one element only
};

struct DrawnFrame {
  double cycle = 0.0;
  base::Points x;                     ///< deformed [mm]
  std::vector<double> von_mises_MPa;  ///< at the same nodes
  std::vector<int> body;              ///< of each node
  std::vector<DrawnEdge> edges;
  std::vector<std::array<int, 3>> triangles;  ///< the elements, those of second order along their mid nodes
  std::vector<std::vector<int>> rigid;        ///< outlines of rigid bodies
};

/// A chain of one side of a contact.
struct DrawnLine {
  std::string contact;
  bool secondary = true;
  int body = 0;
  bool body_on_left = true;        ///< seen along the line
  std::size_t begin = 0, end = 0;  ///< its points
};

/// Points of all contact surfaces.
struct DrawnSurfaces {
  double cycle = 0.0;
  base::Points x, X;  ///< deformed, and of the stress-free bodies [mm]
  std::vector<double> pressure_MPa, wear_depth_mm;
  std::vector<DrawnLine> lines;
};

/// Reads a .vtu that `bodies_vtu` made; throws base::InputError when it cannot.
DrawnFrame read_drawn(const std::string& path);

/// Likewise a .vtp that `surfaces_vtp` made.
DrawnSurfaces read_drawn_surfaces(const std::string& path);

}  // namespace reye::output
