#pragma once
#include <string>
#include <vector>

#include "cad/part/plane_face.hpp"

namespace reye::cad {

/// The faces as text of a STEP file in mm, without a time in it, whose description is `note`. Throws base::MeshError
/// where OpenCASCADE makes no faces of them.
std::string step_text(const std::vector<PlaneFace>& faces, const std::string& note);

}  // namespace reye::cad
