#pragma once
#include <string>

#include "cad/part/text.hpp"
#include "cad/solid/raw_solid.hpp"

/// Points, faces and solids as issues write them.
namespace reye::cad {

std::string text(const base::Vec3& p);
std::string text(const SolidBox& box);

/// "cylinder with box [...]", or with its physical names.
std::string describe(const RawFace& face);
/// "'punch' with box [...]"
std::string describe(const RawSolid& solid);

}  // namespace reye::cad
