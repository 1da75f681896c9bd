#pragma once
#include <string>
#include <vector>

#include "base/issue.hpp"
#include "body/shape.hpp"
#include "cad/build/geometry.hpp"
#include "contact/setup.hpp"
#include "scene/scene.hpp"

namespace reye::sim {

/// Finds in the geometry what a scene names: boundaries, "name" or "body.name", and bodies at points. Collects what it
/// cannot find.
class Resolver {
 public:
  Resolver(const scene::Scene& scene, const std::vector<body::ShapePtr>& shapes,
           const std::vector<cad::BodyFacts>& facts)
      : scene_(scene), shapes_(shapes), facts_(facts) {}

  std::vector<base::Issue> issues;

  /// The one boundary of this name. Its `body` is -1 when none or several fit; an issue is noted under `key`.
  contact::BoundaryRef boundary(const std::string& name, const std::string& key);

  /// The body whose node lies nearest to a point, or the one named; -1: none.
  int body_at(const std::string& named, const base::Vec2& point) const;

 private:
  std::string cut_off(const std::string& name) const;

  const scene::Scene& scene_;
  const std::vector<body::ShapePtr>& shapes_;
  const std::vector<cad::BodyFacts>& facts_;
};

}  // namespace reye::sim
