#pragma once
#include <cmath>
#include <cstdio>
#include <numbers>

#include "verification/wear_scene.hpp"

/// Scenes turned as a whole.
namespace reye::verification {

inline base::Vec2 turned(const base::Vec2& v, double degrees) {
  const double t = degrees * std::numbers::pi / 180.0;
  return {v.x() * std::cos(t) - v.y() * std::sin(t), v.x() * std::sin(t) + v.y() * std::cos(t)};
}

inline std::string pair_text(const base::Vec2& v) {
  char text[80];
  std::snprintf(text, sizeof text, "[%.17g, %.17g]", v.x(), v.y());
  return text;
}

/// A mesh of geo/ with all its nodes turned, as a file of its own.
inline std::string turned_mesh(const std::string& name, double degrees) {
  std::istringstream in(read_text(std::string(REYE_SOURCE_DIR) + "/geo/" + name));
  std::ostringstream out;
  bool nodes = false;
  for (std::string line; std::getline(in, line);) {
    nodes = line == "$Nodes" || (nodes && line != "$EndNodes");
    base::Vec2 x;
    double z = 0.0, more = 0.0;
    if (nodes && std::sscanf(line.c_str(), "%lf %lf %lf %lf", &x.x(), &x.y(), &z, &more) == 3) {
      const base::Vec2 y = turned(x, degrees);
      char text[80];
      std::snprintf(text, sizeof text, "%.17g %.17g 0", y.x(), y.y());
      line = text;
    }
    out << line << '\n';
  }
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string path =
      support::temporary_folder() + test->name() + "_" + std::to_string(static_cast<int>(degrees)) + ".msh";
  std::ofstream(path, std::ios::binary) << out.str();
  return path;
}

}  // namespace reye::verification
