#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

/// Nodal fields carried from the mesh of a body to another mesh of the same body. Fields are carried by name, whatever
/// they mean. State of Gauss points: gauss_transfer.hpp.
namespace reye::adapt {

/// values[node * components + c]
struct Field {
  std::string name;
  int components = 1;
  std::vector<double> values;
};

struct Transferred {
  std::vector<Field> fields;      ///< empty when it failed
  double largest_distance = 0.0;  ///< of a new node from the old mesh [mm]; 0 without fields
  std::string failure;            ///< empty, or the new node that is farthest outside, and the bound
};

/// Fields interpolated in the old cell, sum_a w_a v_a (Locator); a new node on an old one takes its values bit
/// for bit, affine fields are exact, smooth ones lose at second order, a node outside takes the values of the
/// closest point and the transfer fails when that is farther than most_distance [mm].
/// Nothing is built without fields.
Transferred transfer(const mesh::Mesh& from, const std::vector<Field>& fields, const mesh::Mesh& to,
                     double most_distance);

}  // namespace reye::adapt
