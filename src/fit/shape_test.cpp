#include "fit/shape_test.hpp"

#include <algorithm>
#include <cmath>

#include "fit/basis.hpp"
#include "fit/quantiles.hpp"

namespace reye::fit {

namespace {

/// The depth at the places of a series, where it lies and how wide it is.
struct Depth {
  Vector value;
  Vec2 middle{0.0, 0.0}, width{1.0, 1.0};
};
Depth depth_of(const Record& record, const Model& model, const Unknowns& at) {
  const auto& places = record.series->at;
  Depth depth{model(at.theta, record.number, at.shift[record.number])};
  const Vector weight = depth.value.cwiseAbs() / std::max(depth.value.cwiseAbs().sum(), 1e-300);
  for (std::size_t i = 0; i < places.size(); ++i) depth.middle += weight[static_cast<Eigen::Index>(i)] * places[i];
  Vec2 square = Vec2::Zero();
  for (std::size_t i = 0; i < places.size(); ++i)
    square += weight[static_cast<Eigen::Index>(i)] * (places[i] - depth.middle).cwiseAbs2();
  for (int i : {0, 1})
    if (square[i] > 0.0) depth.width[i] = std::sqrt(square[i]);
  return depth;
}

/// The depth times the powers of the distance from its middle that a map or a line distinguishes, and scars of less and
/// more wear (a third, three and seven times), which are narrower and wider.
Matrix free_shapes(const Record& record, const Model& model, const Unknowns& at, const Depth& depth) {
  const int directions = record.series->map ? 2 : 1, most = record.series->map ? 2 : 4;
  const auto& places = record.series->at;
  const auto n = static_cast<Eigen::Index>(places.size());
  Matrix coordinates(n, 2);
  for (Eigen::Index i = 0; i < n; ++i)
    coordinates.row(i) = (places[i] - depth.middle).cwiseQuotient(depth.width).transpose();
  std::vector<Vector> shapes;
  for (int a = 0; a <= most; ++a)
    for (int b = 0; a + b <= most && b <= (directions - 1) * most; ++b)
      shapes.emplace_back(depth.value.array() * coordinates.col(0).array().pow(a) * coordinates.col(1).array().pow(b));
  for (const double growth : {-1.0, 1.0, 2.0}) {
    const Vector theta = at.theta.array() + growth;
    shapes.push_back(model(theta, record.number, at.shift[record.number]));
    if (!shapes.back().allFinite()) shapes.pop_back();
  }
  Matrix columns(n, static_cast<Eigen::Index>(shapes.size()));
  for (std::size_t j = 0; j < shapes.size(); ++j) columns.col(static_cast<Eigen::Index>(j)) = shapes[j];
  return columns;
}

/// Sums of squares without and with the free shapes, and what they take.
struct Squares {
  double before = 0.0, after = 0.0, log_weight = 0.0;
  int shapes = 0, freedom = 0;
};
Squares squares_of(const Record& record, const Noise& noise, const Matrix& columns, int taken) {
  auto [gram, log_determinant] = weigh(record.blocks, record.series->map, noise, columns);
  const Eigen::Index last = gram.cols() - 1;
  Eliminated first = eliminate(gram, taken);
  const double before = gram(last, last);
  Matrix rest = gram.bottomRightCorner(gram.cols() - taken, gram.cols() - taken);
  const Eliminated shapes = eliminate(rest, static_cast<int>(rest.cols()) - 1);
  const double after = std::max(rest(rest.cols() - 1, rest.cols() - 1), 1e-300);
  const int freedom = static_cast<int>(columns.rows()) - first.rank - shapes.rank;
  return {before, after,
          std::log(noise.prior) -
              0.5 * (log_determinant + first.log_pivots + shapes.log_pivots + freedom * std::log(after)),
          shapes.rank, freedom};
}

/// Of noise that the free shapes among the columns improve as much, a mean over what the noise may be.
double probability_of(const Record& record, const Matrix& means, int taken) {
  constexpr double nothing = 1e-6;
  std::vector<Squares> all;
  for (const Noise& noise : candidates(record.blocks, record.series->map))
    all.push_back(squares_of(record, noise, means, taken));
  if (all.front().shapes == 0 || all.front().freedom < 1) return 1.0;
  double best = all.front().log_weight, sum = 0.0, probability = 0.0;
  for (const Squares& one : all) best = std::max(best, one.log_weight);
  for (const Squares& one : all) {
    const double weight = std::exp(one.log_weight - best);
    const double F = std::max(one.before - one.after, 0.0) / one.shapes / (one.after / one.freedom);
    sum += weight;
    if (weight > nothing) probability += weight * fisher_tail(one.shapes, one.freedom, F);
  }
  return probability / sum;
}

}  // namespace

ShapeTest shape_test(const Record& record, const Model& model, const Unknowns& at, const Matrix& taken,
                     double noticeable) {
  const Depth depth = depth_of(record, model, at);
  const double depth_squares = depth.value.squaredNorm();
  if (!(depth_squares > 0.0)) return {};
  const Matrix means = record.blocks.averaged(taken);
  const Matrix basis = basis_of(means.leftCols(taken.cols() - 1));
  const auto own = static_cast<int>(basis.cols());
  Matrix left(means.rows(), own + 1);
  left << basis, means.rightCols(1);
  Matrix gram = weigh(record.blocks, record.series->map, {}, left).gram;
  eliminate(gram, own);
  const double width = 4.0 * depth.width.head(record.series->map ? 2 : 1).minCoeff();
  ShapeTest test{1.0, std::sqrt(gram(own, own) / depth_squares), width};
  if (test.part < noticeable) return test;
  constexpr double another = 1e-4;  // of a shape, below which it is the error of a difference quotient
  const Matrix shapes = basis_beside(basis, record.blocks.averaged(free_shapes(record, model, at, depth)), another);
  Matrix columns(means.rows(), left.cols() + shapes.cols());
  columns << basis, shapes, means.rightCols(1);
  test.probability = probability_of(record, columns, own);
  return test;
}

}  // namespace reye::fit
