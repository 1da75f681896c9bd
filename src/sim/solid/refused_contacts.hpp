#pragma once
#include <vector>

#include "base/issue.hpp"
#include "body/solid/solid_input.hpp"
#include "sim/solid/placed_skins.hpp"

namespace reye::sim {

/// What contacts of solids cannot do, with the keys of the scene: wear on the linear dual basis of curved facets, faces
/// that two contacts wear, and friction that slides across a plane of symmetry (`symmetry`: names of such faces).
std::vector<base::Issue> refused_contacts(const std::vector<body::SolidInput>& inputs,
                                          const std::vector<PlacedSkins>& contacts,
                                          const std::vector<std::string>& symmetry);

}  // namespace reye::sim
