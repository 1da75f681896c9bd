#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/errors.hpp"
#include "cad/build/geometry.hpp"
#include "mesh/measure.hpp"
#include "mesh/quality.hpp"
#include "support/temporary_folder.hpp"

/// What the tests of the cad room share.
namespace reye::cad {

inline std::string data(const std::string& name) { return REYE_SOURCE_DIR "/tests/cad/data/" + name; }
inline std::string scene_file(const std::string& name) { return REYE_SOURCE_DIR "/geo/" + name; }

inline BodyOptions body(const std::string& name) {
  BodyOptions options;
  options.name = name;
  return options;
}

inline BodyOptions body_at(const std::string& name, double x, double y) {
  BodyOptions options = body(name);
  options.at = Vec2(x, y);
  return options;
}

inline BoundaryOptions boundary(const std::string& name, const std::string& of) {
  BoundaryOptions options;
  options.name = name;
  options.body = of;
  return options;
}

/// Punch [-1, 1] x [0, 2] on a block [-3, 3] x [-2, 0].
inline GeometryOptions punch_on_block() {
  GeometryOptions options;
  options.files = {data("named.step")};
  options.bodies = {body("punch"), body("block")};
  return options;
}

/// Half disc R = 6 on a block [-6, 6] x [-6, 0] with its usual boundaries.
inline GeometryOptions cylinder_on_flat(mesh::CellKind kind, double far_size, double fine_size) {
  GeometryOptions options;
  options.files = {scene_file("hertz/cylinder_on_flat.step")};
  options.bodies = {body_at("cylinder", 0, 3), body_at("flat", 0, -3)};
  for (BodyOptions& each : options.bodies) each.mesh = {kind, far_size, 1.3};
  options.boundaries = {boundary("top", "cylinder"), boundary("round", "cylinder"), boundary("face", "flat"),
                        boundary("bottom", "flat")};
  options.boundaries[0].box_mm = {-6.1, 5.9, 6.1, 6.1};
  options.boundaries[1].type = "circle";
  options.boundaries[2].nearest_mm = Vec2(0, 0);
  options.boundaries[3].box_mm = {-6.1, -6.1, 6.1, -5.9};
  if (fine_size > 0.0) options.fine_zones = {{{"cylinder", "flat"}, {0, 0}, 0.5, 0.2, fine_size, 0.0}};
  return options;
}

/// The issues build raises, as "key = value: rule" lines; "" if it raises none.
inline std::string issues_of(const GeometryOptions& options) {
  try {
    build(options);
    return "";
  } catch (const base::InputError& error) {
    return error.what();
  }
}

/// What a file is refused with whose only body lies at (x, y); "" if it is accepted.
inline std::string refusal_of_file(const std::string& path, double x = 0.5, double y = 0.5) {
  GeometryOptions options;
  options.files = {path};
  options.bodies = {body_at("body", x, y)};
  return issues_of(options);
}

/// A file in the folder of this test.
inline std::string temporary_file(const std::string& name, const std::string& content) {
  const std::string path = support::temporary_folder() + name;
  std::ofstream(path) << content;
  return path;
}

}  // namespace reye::cad
