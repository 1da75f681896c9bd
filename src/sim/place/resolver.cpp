#include "sim/place/resolver.hpp"
#include "base/formatted.hpp"

namespace reye::sim {

namespace {}  // namespace

contact::BoundaryRef Resolver::boundary(const std::string& name, const std::string& key) {
  std::vector<contact::BoundaryRef> found;
  std::string known;
  for (int b = 0; b < static_cast<int>(shapes_.size()); ++b)
    for (const auto& [own, chains] : shapes_[b]->mesh.boundaries) {
      const std::string full = scene_.geometry.bodies[b].name + "." + own;
      if (own == name || full == name) found.push_back({b, own});
      known += (known.empty() ? "" : ", ") + full;
    }
  if (found.size() == 1) return found.front();
  issues.push_back({key, base::quoted(name),
                    found.empty()
                        ? "no boundary has this name; there are " + (known.empty() ? "none" : known) + cut_off(name)
                        : "more than one body has a boundary of this name; write body.name"});
  return {-1, name};
}

int Resolver::body_at(const std::string& named, const base::Vec2& point) const {
  int best = -1;
  double distance = 0.0;
  for (int b = 0; b < static_cast<int>(shapes_.size()); ++b) {
    if (!named.empty() && scene_.geometry.bodies[b].name != named) continue;
    for (const auto& X : shapes_[b]->mesh.X)
      if (const double d = (X - point).norm(); best < 0 || d < distance) {
        best = b;
        distance = d;
      }
  }
  return best;
}

/// Why a curve of this name is not a boundary.
std::string Resolver::cut_off(const std::string& name) const {
  for (const auto& facts : facts_)
    for (const auto& own : facts.cut_off)
      if (own == name || facts.name + "." + own == name)
        return "; its curve lies at x < 0, which is cut away, and its mirror image does not have this name: the "
               "half x >= 0 of body " +
               base::quoted(facts.name) + " is taken";
  return {};
}

}  // namespace reye::sim
