#include "body/motions.hpp"

#include <cmath>

#include "algebra/decompose.hpp"
#include "base/formatted.hpp"
#include "body/edges.hpp"
#include "body/resultant.hpp"

namespace reye::body {

namespace {

/// A rigid motion m = (a, b, w L): u(X) = (a, b) + w e_3 x (X - c), L the size of the body; all in mm.
using Row = Eigen::RowVector3d;

/// The constraints and loads on rigid motions, one linear form per row, scaled to order one.
class MotionSpace {
 public:
  MotionSpace(const mesh::Mesh& mesh, bool axisymmetric) : centre_(box_centre(mesh)) {
    for (const Vec2& X : mesh.X) size_ = std::max(size_, (X - centre_).norm());
    if (axisymmetric) rows_ = {Row{1, 0, 0}, Row{0, 0, 1}};  // only the motion along the axis remains
  }

  void hold(const Vec2& X, const Vec2& direction) {
    rows_.push_back(Row{direction.x(), direction.y(), base::cross(X - centre_, direction) / size_});
  }
  void hold_rotation() { rows_.push_back(Row{0, 0, 1}); }
  /// `scale`: force that counts as one, so that a resultant of pure round-off does not count as load.
  void add_work(const Resultant& load, double scale) {
    const Row row{load.force.x(), load.force.y(), load.moment() / size_};
    if (row.norm() > 1e-9 * scale) rows_.push_back(row.normalized());
  }
  const Vec2& centre() const { return centre_; }
  double size() const { return size_; }

  /// Motions on which every row vanishes, as orthonormal columns.
  Matrix left(bool translations_only) const {
    Matrix A = Matrix::Zero(static_cast<Eigen::Index>(rows_.size()) + 3, 3);  // never fewer rows than columns
    for (size_t i = 0; i < rows_.size(); ++i) A.row(i) = rows_[i];
    if (translations_only) A(A.rows() - 1, 2) = 1.0;
    const auto singular = algebra::right_singular_values(A);
    const auto rank = (singular.values.array() > 1e-8).count();
    return singular.V.rightCols(3 - rank);
  }

 private:
  Vec2 centre_;
  double size_ = 0.0;
  std::vector<Row> rows_;
};

void hold_support(const mesh::Mesh& mesh, const Support& support, MotionSpace& space) {
  const SupportPlace place = place_support(mesh, support);
  for (size_t k = 0; k < place.nodes.size(); ++k) {
    const Vec2 at = place.rigid ? place.centre : mesh.X[place.nodes[k]];
    if (holds(support.x)) space.hold(at, place.x_axis[k]);
    if (holds(support.y)) space.hold(at, place.y_axis[k]);
  }
  if (holds(support.rotation)) space.hold_rotation();
}

/// A loaded motion of a support as a resultant; only its direction matters here.
void add_loaded_support(const mesh::Mesh& mesh, const Support& support, MotionSpace& space) {
  const SupportPlace place = place_support(mesh, support);
  const auto force = [&](const Motion& m, const Vec2& direction) {
    if (m.drive != Drive::loaded || !nonzero(m)) return;
    space.add_work({direction, direction * (place.centre - space.centre()).transpose()}, 1.0);
  };
  force(support.x, place.x_axis.front());
  force(support.y, place.y_axis.front());
  if (support.rotation.drive != Drive::loaded || !nonzero(support.rotation)) return;
  space.add_work({Vec2{0.0, 0.0}, Eigen::Matrix2d{{0.0, 0.0}, {space.size(), 0.0}}}, 1.0);
}

void add_loads(const mesh::Mesh& mesh, const BodyInput& input, MotionSpace& space) {
  const auto add = [&](const auto& load) {
    const Resultant r = resultant(mesh, input.analysis, load, space.centre());
    space.add_work(r, r.force.norm() + r.spread.norm() / space.size());
  };
  for (const auto& load : input.boundary_loads) add(load);
  for (const auto& load : input.point_loads) add(load);
  for (const auto& load : input.body_forces) add(load);
  for (const auto& support : input.supports) add_loaded_support(mesh, support, space);
}

std::string name_of(const Eigen::Vector3d& translation) {
  if (std::abs(translation.y()) < 1e-6) return "translation along x";
  if (std::abs(translation.x()) < 1e-6) return "translation along y";
  const double sign = translation.x() < 0.0 ? -1.0 : 1.0;
  return base::formatted("translation along (%.3g, %.3g)", sign * translation.x(), sign * translation.y());
}

std::vector<std::string> names_of(const MotionSpace& space) {
  const Matrix all = space.left(false), translations = space.left(true);
  std::vector<std::string> names;
  if (translations.cols() == 2) names = {"translation along x", "translation along y"};
  if (translations.cols() == 1) names = {name_of(translations.col(0))};
  if (all.cols() > translations.cols()) names.push_back("rotation");
  return names;
}

}  // namespace

std::vector<std::string> unheld_motions(const mesh::Mesh& mesh, const BodyInput& input, bool friction) {
  MotionSpace space(mesh, input.analysis == base::Analysis::axisymmetric);
  for (const auto& support : input.supports) hold_support(mesh, support, space);
  if (!input.contact_boundaries.empty()) {
    if (friction) return {};
    add_loads(mesh, input, space);
  }
  return names_of(space);
}

std::vector<std::string> unheld_together(const std::vector<HeldBody>& bodies, bool axisymmetric) {
  MotionSpace space(*bodies.front().mesh, axisymmetric);
  for (const auto& [mesh, supports] : bodies)
    for (const auto& support : *supports) hold_support(*mesh, support, space);
  return names_of(space);
}

}  // namespace reye::body
