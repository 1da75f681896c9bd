#pragma once
#include <gtest/gtest.h>

#include <numbers>

#include "base/errors.hpp"
#include "cad/solid/skin_of.hpp"
#include "cad/solid/solid_geometry.hpp"
#include "cad/solid/solid_shape.hpp"

/// What the tests of solids share.
namespace reye::cad {

inline constexpr double solid_pi = std::numbers::pi;

inline std::string solid_data(const std::string& name) { return REYE_SOURCE_DIR "/tests/cad/data/solid/" + name; }
inline std::string solid_scene(const std::string& name) { return REYE_SOURCE_DIR "/geo/" + name; }

inline SolidBodyOptions solid_body(const std::string& name, mesh::SolidKind kind = mesh::SolidKind::tet10) {
  SolidBodyOptions options;
  options.name = name;
  options.mesh.element = kind;
  return options;
}

inline SolidGeometryOptions solid_options(std::vector<std::string> files, std::vector<SolidBodyOptions> bodies) {
  SolidGeometryOptions options;
  options.files = std::move(files);
  options.bodies = std::move(bodies);
  return options;
}

inline FaceOptions face_of(const std::string& name, const std::string& body) {
  FaceOptions options;
  options.name = name;
  options.body = body;
  return options;
}

inline double meshed_volume(const mesh::SolidMesh& mesh) { return enclosed_volume(mesh.X, mesh.skin); }
inline double meshed_area(const mesh::SolidMesh& mesh, const std::string& face) {
  return facets_area(mesh.X, mesh.skin, mesh.faces.at(face));
}

inline double poorest_jacobian(const mesh::SolidMesh& mesh) {
  double least = 1.0;
  for (const mesh::SolidCell& cell : mesh.cells) least = std::min(least, least_jacobian(mesh.X, mesh.kind, cell));
  return least;
}

/// The issues build_solids raises, as "key = value: rule" lines; "" if it raises none.
inline std::string solid_issues(const SolidGeometryOptions& options) {
  try {
    build_solids(options);
    return "";
  } catch (const base::InputError& error) {
    return error.what();
  }
}

}  // namespace reye::cad
