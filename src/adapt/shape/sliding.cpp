#include "adapt/shape/sliding.hpp"

#include <algorithm>
#include <cmath>

namespace reye::adapt {

namespace {

struct Marks {
  std::vector<char> stop;  ///< ends of straight sides
  std::vector<char> worn;
  double slack = 0.0;  ///< round-off of a position [mm]
};

Marks marks_of(const mesh::Mesh& born, const std::vector<WornNode>& worn) {
  Marks marks{std::vector<char>(born.X.size(), 0), std::vector<char>(born.X.size(), 0)};
  for (const auto& [name, boundary] : born.boundaries)
    for (const auto& chain : boundary)
      if (chain.front() != chain.back()) marks.stop[chain.front()] = marks.stop[chain.back()] = 1;
  for (const auto& loop : born.outline)
    for (std::size_t k = 0; k + 1 < loop.size(); ++k) {
      const int before = loop[k == 0 ? loop.size() - 2 : k - 1];
      const Vec2 in = born.X[loop[k]] - born.X[before], out = born.X[loop[k + 1]] - born.X[loop[k]];
      if (std::abs(base::cross(in, out)) > 1e-9 * in.norm() * out.norm()) {
        marks.stop[loop[k]] = 1;
        if (mesh::order(born.kind) == 2 && k % 2 == 1) marks.stop[before] = marks.stop[loop[k + 1]] = 1;  // a curve
      }
      marks.slack = std::max(marks.slack, 1e-14 * born.X[loop[k]].cwiseAbs().maxCoeff());
    }
  for (int node : born.points) marks.stop[node] = 1;
  for (const auto& node : worn) marks.worn[node.node] = 1;
  return marks;
}

/// The nodes from `start` on, around the loop, up to and including the next stop.
std::vector<int> side_from(const mesh::Chain& loop, std::size_t start, const Marks& marks) {
  std::vector<int> side{loop[start]};
  const std::size_t n = loop.size() - 1;
  for (std::size_t k = 1; k <= n; ++k) {
    side.push_back(loop[(start + k) % n]);
    if (marks.stop[side.back()]) break;
  }
  return side;
}

void slide(mesh::Mesh& mesh, const mesh::Mesh& born, const std::vector<int>& side, const Marks& marks) {
  const Vec2& origin = born.X[side.front()];
  const double length = (born.X[side.back()] - origin).norm();
  const Vec2 t = (born.X[side.back()] - origin) / length;
  const auto moved = [&](int node) -> Vec2 { return mesh.X[node] - born.X[node]; };
  const auto off = [&](int node) { return std::abs(base::cross(t, moved(node))); };
  for (int end : {side.front(), side.back()})  // the corner reached its place in many steps
    if (off(end) > marks.slack + 1e-9 * moved(end).norm()) return;
  for (std::size_t k = 1; k + 1 < side.size(); ++k)
    if (marks.worn[side[k]] || off(side[k]) > marks.slack) return;
  const double first = t.dot(moved(side.front())), last = t.dot(moved(side.back()));
  if (std::max(std::abs(first), std::abs(last)) <= marks.slack) return;
  for (std::size_t k = 1; k + 1 < side.size(); ++k) {
    const double s = t.dot(born.X[side[k]] - origin) / length;
    mesh.X[side[k]] = born.X[side[k]] + ((1.0 - s) * first + s * last) * t;
  }
}

}  // namespace

void slide_sides(mesh::Mesh& mesh, const mesh::Mesh& born, const std::vector<WornNode>& worn) {
  const auto marks = marks_of(born, worn);
  for (const auto& loop : born.outline)
    for (std::size_t k = 0; k + 1 < loop.size(); ++k)
      if (marks.stop[loop[k]])
        if (const auto side = side_from(loop, k, marks); side.size() > 2 && side.front() != side.back())
          slide(mesh, born, side, marks);
}

}  // namespace reye::adapt
