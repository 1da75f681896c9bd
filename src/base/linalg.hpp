#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

/// Vectors and matrices shared by all rooms.
namespace reye::base {

using Vec2 = Eigen::Vector2d;
using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
using SparseMatrix = Eigen::SparseMatrix<double>;
using Triplet = Eigen::Triplet<double>;
using Points = std::vector<Vec2>;

inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The vector turned by -90 degrees: outward normal of an edge whose body lies on the left.
inline Vec2 right_of(const Vec2& t) { return {t.y(), -t.x()}; }

}  // namespace reye::base
