#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

/// Fields carried from the mesh of a body to another mesh of the same body. What lives on nodes or Gauss points
/// registers itself by name; nothing here knows what it means.
namespace reye::adapt {

/// values[item * components + c]
struct Field {
  std::string name;
  int components = 1;
  std::vector<double> values;
};

/// Items of `nodal`: nodes of the mesh. Items of `gauss`: points of fem::stiffness_rule, cell by cell.
struct BodyFields {
  std::vector<Field> nodal, gauss;
};

struct Transferred {
  BodyFields fields;              ///< empty when it failed
  double largest_distance = 0.0;  ///< of a new node from the old mesh [mm]; 0 without nodal fields
  std::string failure;            ///< empty, or the new node that is farthest outside, and the bound
};

/// Nodal fields: interpolated in the old cell, sum_a w_a v_a (Locator); a new node on an old one takes its values bit
/// for bit, affine fields are exact, smooth ones lose at second order, a node outside takes the values of the
/// closest point and the transfer fails when that is farther than most_distance [mm].
/// Gauss fields: values of the nearest old Gauss point, so nothing is averaged and an admissible state stays one.
/// Nothing is built for a kind without fields.
Transferred transfer(const mesh::Mesh& from, const BodyFields& fields, const mesh::Mesh& to, double most_distance);

}  // namespace reye::adapt
