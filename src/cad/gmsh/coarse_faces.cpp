#include <gmsh.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "cad/gmsh/open_solids.hpp"

namespace reye::cad {

namespace {

using NodeTag = std::size_t;

/// Nodes of a face with those of its edges, and the largest and smallest curvature [1/mm] at each.
struct CurvedNodes {
  Points3 X;
  std::vector<double> largest, smallest;
};

std::map<NodeTag, base::Vec3> positions_on(int face) {
  std::vector<NodeTag> tags;
  std::vector<double> x, parameters;
  gmsh::model::mesh::getNodes(tags, x, parameters, 2, face, true, false);
  std::map<NodeTag, base::Vec3> where;
  for (std::size_t i = 0; i < tags.size(); ++i) where[tags[i]] = {x[3 * i], x[3 * i + 1], x[3 * i + 2]};
  return where;
}

/// A face whose parametrisation knows no curvature has none here.
CurvedNodes curved_nodes(int face) {
  CurvedNodes nodes;
  std::vector<NodeTag> tags;
  std::vector<double> x, parameters, largest, smallest, d1, d2;
  try {
    gmsh::model::mesh::getNodes(tags, x, parameters, 2, face, true, true);
    if (parameters.size() != 2 * tags.size()) return nodes;
    gmsh::model::getPrincipalCurvatures(face, parameters, largest, smallest, d1, d2);
  } catch (const std::string&) {
    return nodes;
  }
  if (largest.size() != tags.size() || smallest.size() != tags.size()) return nodes;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    if (!std::isfinite(largest[i]) || !std::isfinite(smallest[i])) continue;
    nodes.X.emplace_back(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
    nodes.largest.push_back(std::max(std::abs(largest[i]), std::abs(smallest[i])));
    nodes.smallest.push_back(std::min(std::abs(largest[i]), std::abs(smallest[i])));
  }
  return nodes;
}

/// What a spline is, by its curvatures times the extent of its face.
FaceType type_by_curvature(int face) {
  const CurvedNodes nodes = curved_nodes(face);
  if (nodes.X.size() < 3) return FaceType::spline;
  double extent = 0.0;
  for (const base::Vec3& p : nodes.X) extent = std::max(extent, (p - nodes.X[0]).norm());
  constexpr double tolerance = 1e-5;
  const auto [low, high] = std::minmax_element(nodes.largest.begin(), nodes.largest.end());
  const auto [least, most] = std::minmax_element(nodes.smallest.begin(), nodes.smallest.end());
  if (*high * extent < tolerance) return FaceType::plane;
  if (*high - *low > tolerance * *high) return FaceType::spline;
  if (*most * extent < tolerance) return FaceType::cylinder;
  return *high - *least < tolerance * *high ? FaceType::sphere : FaceType::spline;
}

}  // namespace

bool has_cells() {
  std::vector<int> types;
  gmsh::model::mesh::getElementTypes(types, 3);
  return !types.empty();
}

bool has_quadrilaterals() {
  constexpr int triangles = 2;
  std::vector<int> types;
  gmsh::model::mesh::getElementTypes(types, 2);
  return std::any_of(types.begin(), types.end(), [](int type) { return type != triangles; });
}

void reset_mesh_options() {
  const std::pair<const char*, double> options[] = {
      {"General.AbortOnError", 0},  // errors inside the mesher are thrown in a parallel region and end the process
      {"General.NumThreads", 1},
      {"Mesh.Algorithm", 6},
      {"Mesh.AlgorithmSwitchOnFailure", 1},
      {"Mesh.CompoundClassify", 1},
      {"Mesh.ElementOrder", 1},
      {"Mesh.HighOrderOptimize", 0},
      {"Mesh.MaxNumThreads1D", 1},
      {"Mesh.MaxNumThreads2D", 1},
      {"Mesh.MaxNumThreads3D", 1},
      {"Mesh.MeshOnlyVisible", 0},
      {"Mesh.MeshOnlyEmpty", 0},
      {"Mesh.MeshSizeExtendFromBoundary", 0},
      {"Mesh.MeshSizeFactor", 1},
      {"Mesh.MeshSizeFromCurvature", 0},
      {"Mesh.MeshSizeFromPoints", 0},
      {"Mesh.MeshSizeMin", 0},
      {"Mesh.MeshSizeMax", 1e22},
      {"Mesh.MinimumCirclePoints", 7},
      {"Mesh.Optimize", 1},
      {"Mesh.OptimizeNetgen", 0},
      {"Mesh.OptimizeThreshold", 0.3},
      {"Mesh.RandomFactor", 1e-9},
      {"Mesh.RandomFactor3D", 1e-12},
      {"Mesh.RandomSeed", 1},
      {"Mesh.RecombineAll", 0},
      {"Mesh.Recombine3DAll", 0},
      {"Mesh.Renumber", 1},
      {"Mesh.SecondOrderIncomplete", 0},
      {"Mesh.SecondOrderLinear", 0},
      {"Mesh.Smoothing", 1},
      {"Mesh.SubdivisionAlgorithm", 0}};
  for (const auto& [name, value] : options) gmsh::option::setNumber(name, value);
}

void triangulate() {
  const int everywhere = gmsh::model::mesh::field::add("MathEval");  // in the place of one that a script may have set
  gmsh::model::mesh::field::setString(everywhere, "F", "1e22");
  gmsh::model::mesh::field::setAsBackgroundMesh(everywhere);
  double x0, y0, z0, x1, y1, z1;
  gmsh::model::getBoundingBox(-1, -1, x0, y0, z0, x1, y1, z1);
  reset_mesh_options();
  constexpr double elements_in_a_circle = 16.0;
  const double extent = std::hypot(x1 - x0, y1 - y0, z1 - z0);
  gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", elements_in_a_circle);
  gmsh::option::setNumber("Mesh.MeshSizeMax", 0.1 * extent);
  gmsh::option::setNumber("Mesh.MeshSizeMin", 1e-3 * extent);
  gmsh::model::mesh::generate(2);
}

std::vector<Triangle> triangles_of(int face) {
  std::vector<NodeTag> ids, nodes;
  gmsh::model::mesh::getElementsByType(2, ids, nodes, face);
  const std::map<NodeTag, base::Vec3> where = positions_on(face);
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i + 2 < nodes.size(); i += 3)
    triangles.push_back({where.at(nodes[i]), where.at(nodes[i + 1]), where.at(nodes[i + 2])});
  return triangles;
}

FaceType type_of_face(int face) {
  std::string word;
  gmsh::model::getType(2, face, word);
  for (FaceType type : {FaceType::plane, FaceType::cylinder, FaceType::sphere, FaceType::cone, FaceType::torus}) {
    std::string name = to_string(type);
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    if (word.starts_with(name)) return type;
  }
  return type_by_curvature(face);
}

std::vector<SizePoint> radii_of(int face) {
  const CurvedNodes nodes = curved_nodes(face);
  std::vector<SizePoint> points;
  for (std::size_t i = 0; i < nodes.X.size(); ++i)
    if (nodes.largest[i] > 0.0) points.push_back({nodes.X[i], 1.0 / nodes.largest[i]});
  return points;
}

std::map<int, std::vector<SizePoint>>& kept_radii() {
  static std::map<int, std::vector<SizePoint>> kept;
  return kept;
}

}  // namespace reye::cad
