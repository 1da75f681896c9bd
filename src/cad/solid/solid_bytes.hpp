#pragma once
#include <string>
#include <string_view>

#include "cad/solid/raw_solid.hpp"
#include "cad/solid/skin_surface.hpp"

/// What passes between the importer and the program, as bytes. Those of answers are not trusted: counts within their
/// size, finite coordinates below 1e9 mm, known kinds and nodes; what fails throws std::runtime_error naming the check.
namespace reye::cad {

std::string bytes_of(const SolidQuery& query);
std::string bytes_of(const SolidOrder& order);
std::string bytes_of(const SkinFilling& filling);
std::string bytes_of(const SolidAnswer& answer);
std::string bytes_of(const SolidMeshAnswer& answer);

SolidQuery solid_query_of(std::string_view bytes);
SolidOrder solid_order_of(std::string_view bytes);
SkinFilling skin_filling_of(std::string_view bytes);

/// Also: for each probe a distance of each face and whether it is inside each solid.
SolidAnswer solid_answer_of(std::string_view bytes, std::size_t probes);

/// Also: facets of a face below `faces`.
SolidMeshAnswer solid_mesh_answer_of(std::string_view bytes, std::size_t faces);

}  // namespace reye::cad
