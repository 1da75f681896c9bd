#include "adapt/transfer/projection.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <numeric>
#include <optional>

#include "adapt/transfer/locate.hpp"
#include "adapt/transfer/overlap.hpp"
#include "algebra/decompose.hpp"
#include "fem/element.hpp"

namespace reye::adapt {

namespace {

using base::Matrix;

/// c0 + c1 (x - centre)_1 + c2 (x - centre)_2, all components: rows of c.
struct Affine {
  Vec2 centre{0.0, 0.0};
  Matrix c;

  Eigen::RowVectorXd at(const Vec2& x) const {
    const Vec2 d = x - centre;
    return c.row(0) + d.x() * c.row(1) + d.y() * c.row(2);
  }
};

Eigen::Vector3d monomials(const Vec2& d) { return {1.0, d.x(), d.y()}; }

bool degenerate(const Eigen::Matrix2d& S) { return S.determinant() <= 1e-14 * S.trace() * S.trace(); }

Vec2 centre_of(const GaussPoints& points, int cell) {
  Vec2 sum = Vec2::Zero();
  double volume = 0.0;
  for (int i = cell * points.per_cell; i < (cell + 1) * points.per_cell; ++i) {
    sum += points.volume[i] * points.x[i];
    volume += points.volume[i];
  }
  return sum / volume;
}

double volume_of(const GaussPoints& points, int cell) {
  const auto begin = points.volume.begin() + cell * points.per_cell;
  return std::accumulate(begin, begin + points.per_cell, 0.0);
}

/// About the centre of volume the mean and the slopes are independent.
Affine fitted(const GaussPoints& points, int cell, const Matrix& values) {
  Affine f{centre_of(points, cell), Matrix::Zero(3, values.cols())};
  Eigen::Matrix2d S = Eigen::Matrix2d::Zero();
  Matrix b = Matrix::Zero(2, values.cols());
  for (int i = cell * points.per_cell; i < (cell + 1) * points.per_cell; ++i) {
    const Vec2 d = points.x[i] - f.centre;
    f.c.row(0) += points.volume[i] * values.row(i);
    S += points.volume[i] * d * d.transpose();
    b += points.volume[i] * d * values.row(i);
  }
  f.c.row(0) /= volume_of(points, cell);
  if (!degenerate(S)) f.c.bottomRows(2) = S.inverse() * b;
  return f;
}

/// Scales the slopes of one component until it is nowhere negative at the places.
void keep_nonnegative(Affine& f, int component, const Points& places) {
  const double mean = f.c(0, component);
  double least = mean;
  for (const Vec2& x : places) least = std::min(least, f.at(x)[component]);
  if (least < 0.0) f.c.col(component).tail(2) *= mean > 0.0 ? mean / (mean - least) : 0.0;
}

Points nodes_of_cell(const mesh::Mesh& mesh, int cell) {
  Points nodes;
  for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a) nodes.push_back(mesh.X[mesh.cells[cell][a]]);
  return nodes;
}

std::vector<Affine> fitted(const GaussMesh& from, const Matrix& values, const std::vector<int>& nonnegative) {
  std::vector<Affine> result;
  for (int cell = 0; cell < from.mesh.cell_count(); ++cell) {
    result.push_back(fitted(from.points, cell, values));
    for (int component : nonnegative) keep_nonnegative(result.back(), component, nodes_of_cell(from.mesh, cell));
  }
  return result;
}

/// int m m^T (2 pi r) dA over a polygon, m = (1, x - centre); its first row is exact, the rest too in a plane.
Eigen::Matrix3d moments(const Points& polygon, const Vec2& centre, base::Analysis analysis) {
  constexpr auto triangle = mesh::CellKind::tri3;
  Eigen::Matrix3d result = Eigen::Matrix3d::Zero();
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const Vec2 a = polygon[0] - centre, e = polygon[k] - polygon[0], f = polygon[k + 1] - polygon[0];
    const double doubled = base::cross(e, f);
    for (const auto& at : fem::volume_rule(triangle)) {
      const Vec2 d = a + at.xi.x() * e + at.xi.y() * f;
      const double volume = at.weight * doubled * base::out_of_plane(analysis, centre.x() + d.x());
      result += volume * monomials(d) * monomials(d).transpose();
    }
  }
  return result;
}

/// Equation (1) of one new cell: moments M p = b about its centre.
struct Equation {
  Eigen::Matrix3d M = Eigen::Matrix3d::Zero();
  Matrix b;
};

void add(Equation& e, const Overlap& overlap, const Affine& f, const Vec2& centre, base::Analysis analysis) {
  const Eigen::Matrix3d P = overlap.sign * moments(overlap.polygon, centre, analysis);
  Matrix c = f.c;
  c.row(0) = f.at(centre);
  e.M += P;
  e.b += P * c;
}

Affine solved(const Equation& e, const Vec2& centre, bool slopes) {
  Affine p{centre, Matrix::Zero(3, e.b.cols())};
  const Eigen::Matrix2d S =
      e.M.bottomRightCorner<2, 2>() - e.M.bottomLeftCorner<2, 1>() * e.M.topRightCorner<1, 2>() / e.M(0, 0);
  if (slopes && !degenerate(S))
    p.c = algebra::solve_symmetric(e.M, e.b);
  else
    p.c.row(0) = e.b.row(0) / e.M(0, 0);
  return p;
}

Points places_of(const GaussPoints& points, int cell) {
  const auto begin = points.x.begin() + cell * points.per_cell;
  return {begin, begin + points.per_cell};
}

/// Values of the old fields at places that the old mesh does not cover, or barely.
class Beside {
 public:
  Beside(const GaussMesh& from, const std::vector<Affine>& old) : from_(from.mesh), old_(old) {}

  Eigen::RowVectorXd at(const Vec2& x) {
    if (!locator_) locator_.emplace(from_);
    const auto place = locator_->find(x);
    Vec2 foot = Vec2::Zero();
    for (int a = 0; a < mesh::nodes_per_cell(from_.kind); ++a)
      foot += place.weights[a] * from_.X[from_.cells[place.cell][a]];
    return old_[place.cell].at(foot);
  }

 private:
  const mesh::Mesh& from_;
  const std::vector<Affine>& old_;
  std::optional<Locator> locator_;  ///< rarely needed
};

std::vector<Equation> equations(const GaussMesh& from, const std::vector<Affine>& old, const GaussMesh& to,
                                base::Analysis analysis) {
  const Eigen::Index components = old.front().c.cols();
  std::vector<Equation> result(to.mesh.cells.size(), {Eigen::Matrix3d::Zero(), Matrix::Zero(3, components)});
  for (const auto& overlap : overlaps(from.mesh, to.mesh))
    add(result[overlap.to], overlap, old[overlap.from], centre_of(to.points, overlap.to), analysis);
  return result;
}

}  // namespace

Matrix project(const GaussMesh& from, const Matrix& values, const GaussMesh& to, base::Analysis analysis,
               const std::vector<int>& nonnegative) {
  constexpr double least_cover = 0.5;
  constexpr int points_of_a_slope = 3;
  const auto old = fitted(from, values, nonnegative);
  const auto system = equations(from, old, to, analysis);
  Beside beside(from, old);
  Matrix result(static_cast<Eigen::Index>(to.points.x.size()), values.cols());
  for (int cell = 0; cell < to.mesh.cell_count(); ++cell) {
    const int first = cell * to.points.per_cell;
    const auto places = places_of(to.points, cell);
    const bool covered = system[cell].M(0, 0) >= least_cover * volume_of(to.points, cell);
    Affine p;
    if (covered) p = solved(system[cell], centre_of(to.points, cell), to.points.per_cell >= points_of_a_slope);
    if (covered)
      for (int component : nonnegative) keep_nonnegative(p, component, places);
    for (int g = 0; g < to.points.per_cell; ++g)
      result.row(first + g) = covered ? p.at(places[g]) : beside.at(places[g]);
  }
  for (int component : nonnegative) result.col(component) = result.col(component).cwiseMax(0.0);  // round-off
  return result;
}

}  // namespace reye::adapt
