#include <gmsh.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/errors.hpp"
#include "cad/gmsh/session.hpp"
#include "cad/meshing/kernel.hpp"

namespace reye::cad {

namespace {

namespace fs = std::filesystem;
namespace occ = gmsh::model::occ;

/// A folder for the file that gmsh writes, removed at the end: gmsh writes to paths alone.
class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "reye-XXXXXX").string();
    if (!::mkdtemp(name.data()))
      throw std::runtime_error("cannot make a folder in " + fs::temp_directory_path().string());
    folder_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  std::string file() const { return (folder_ / "shape.step").string(); }

 private:
  fs::path folder_;
};

/// A parabola through a, m and b; a line where m is their middle.
int add_edge(const Vec2& a, const Vec2& m, const Vec2& b, int from, int to) {
  const Vec2 middle = 0.5 * (a + b);
  if ((m - middle).norm() <= 1e-9 * (b - a).norm()) return occ::addLine(from, to);
  const Vec2 control = 2.0 * m - middle;
  const int point = occ::addPoint(control.x(), control.y(), 0.0);
  const int edge = occ::addBezier({from, point, to});
  occ::remove({{0, point}});
  return edge;
}

int add_loop(const std::vector<Vec2>& loop, int order) {
  const auto step = static_cast<std::size_t>(order);
  std::vector<int> points, edges;
  for (std::size_t i = 0; i < loop.size(); i += step) points.push_back(occ::addPoint(loop[i].x(), loop[i].y(), 0.0));
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::size_t next = (k + 1) % points.size();
    const Vec2 &a = loop[k * step], &b = loop[next * step];
    edges.push_back(add_edge(a, order == 2 ? loop[k * step + 1] : Vec2(0.5 * (a + b)), b, points[k], points[next]));
  }
  return occ::addCurveLoop(edges);
}

}  // namespace

std::string write_step_by_gmsh(const std::vector<PlaneFace>& faces) {
  return guarded([&] {
    const Session session;
    const Silence silence;
    const Scratch scratch;
    for (const auto& face : faces) {
      std::vector<int> loops;
      for (const auto& loop : face.loops) loops.push_back(add_loop(loop, face.order));
      occ::addPlaneSurface(loops);
    }
    occ::synchronize();
    gmsh::write(scratch.file());
    std::ifstream file(scratch.file(), std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    if (text.empty()) throw base::MeshError("gmsh: the faces could not be written");
    return text;
  });
}

}  // namespace reye::cad
