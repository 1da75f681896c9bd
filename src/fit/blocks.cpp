#include "fit/blocks.hpp"

#include <algorithm>
#include <cmath>

namespace reye::fit {

namespace {

constexpr int most_of_a_line = 256, most_of_a_side = 18;

/// Cell of each place of a map, numbered row by row; empty cells have a number, too.
std::vector<int> cells_of(const std::vector<Vec2>& at) {
  Vec2 low = at.front();
  for (const Vec2& p : at) low = low.cwiseMin(p);
  const Vec2 extent = extent_of(at);
  std::vector<int> cells;
  for (const Vec2& p : at) {
    int cell = 0;
    for (int i : {1, 0}) {
      const int step = extent[i] > 0.0 ? static_cast<int>(most_of_a_side * (p[i] - low[i]) / extent[i]) : 0;
      cell = cell * most_of_a_side + std::min(step, most_of_a_side - 1);
    }
    cells.push_back(cell);
  }
  return cells;
}

std::vector<int> stretches_of(int count) {
  std::vector<int> stretches(count);
  for (int i = 0; i < count; ++i)
    stretches[i] = static_cast<int>(static_cast<long>(i) * std::min(count, most_of_a_line) / count);
  return stretches;
}

/// Numbers without gaps, in their order.
void renumber(std::vector<int>& numbers) {
  std::vector<int> present = numbers;
  std::sort(present.begin(), present.end());
  present.erase(std::unique(present.begin(), present.end()), present.end());
  for (int& number : numbers)
    number = static_cast<int>(std::lower_bound(present.begin(), present.end(), number) - present.begin());
}

}  // namespace

Vec2 extent_of(const std::vector<Vec2>& at) {
  Vec2 low = at.front(), high = at.front();
  for (const Vec2& p : at) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return high - low;
}

Matrix Blocks::averaged(const Matrix& values) const {
  if (of.empty()) return values;
  Matrix means = Matrix::Zero(count.size(), values.cols());
  for (Eigen::Index j = 0; j < values.cols(); ++j)
    for (Eigen::Index i = 0; i < values.rows(); ++i) means(of[i], j) += values(i, j);
  return count.cwiseInverse().asDiagonal() * means;
}

Blocks blocks_of(const Series& series) {
  const int count = static_cast<int>(series.at.size());
  Blocks blocks;
  const bool few = count <= (series.map ? most_of_a_side * most_of_a_side : most_of_a_line);
  if (few || series.scatter.size() > 0) return {series.at, {}, Vector::Ones(count)};
  blocks.of = series.map ? cells_of(series.at) : stretches_of(count);
  renumber(blocks.of);
  const int last = *std::max_element(blocks.of.begin(), blocks.of.end());
  blocks.count = Vector::Zero(last + 1);
  for (const int block : blocks.of) blocks.count[block] += 1.0;
  Matrix places(count, 2);
  for (int i = 0; i < count; ++i) places.row(i) = series.at[i].transpose();
  const Matrix means = blocks.averaged(places);
  for (int i = 0; i <= last; ++i) blocks.at.emplace_back(means(i, 0), means(i, 1));
  return blocks;
}

}  // namespace reye::fit
