#include "fit/pairs.hpp"

#include <algorithm>

namespace reye::fit {

Pairs pairs_of(const Blocks& blocks, const Matrix& u) {
  const Eigen::Index n = u.rows(), p = u.cols();
  const double extent = extent_of(blocks.at).norm();
  const Eigen::Index steps = std::max<Eigen::Index>(n - 1, 1);
  Pairs pairs{extent > 0.0 ? extent / static_cast<double>(steps) : 1.0, {}, Matrix::Zero(p, p)};
  pairs.apart.assign(static_cast<std::size_t>(steps) + 2, Matrix::Zero(p, p));
  for (Eigen::Index i = 0; i < n; ++i) {
    const Matrix square = u.row(i).transpose() * u.row(i);
    pairs.own += square / blocks.count[i];
    pairs.apart[0] += square;
  }
  for (Eigen::Index a = 0; a < p; ++a)
    for (Eigen::Index b = 0; b <= a; ++b)
      for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < i; ++j) {
          const double distance = (blocks.at[i] - blocks.at[j]).norm() / pairs.width;
          const auto step = static_cast<std::size_t>(distance);
          const double part = distance - static_cast<double>(step);
          const double product = u(i, a) * u(j, b) + u(j, a) * u(i, b);
          pairs.apart[step](a, b) += (1.0 - part) * product;
          pairs.apart[step + 1](a, b) += part * product;
        }
  for (std::size_t step = 1; step < pairs.apart.size(); ++step) {
    Matrix& sum = pairs.apart[step];
    sum.triangularView<Eigen::StrictlyUpper>() = sum.transpose();
  }
  pairs.apart[0].triangularView<Eigen::StrictlyUpper>() = pairs.apart[0].transpose();
  return pairs;
}

Matrix variance_of(const Pairs& pairs, const Noise& noise) {
  if (noise.order < 0) return noise.nugget * pairs.own;
  Matrix variance = noise.nugget * pairs.own;
  for (std::size_t step = 0; step < pairs.apart.size(); ++step)
    variance += correlation(noise, pairs.width * static_cast<double>(step)) * pairs.apart[step];
  return variance;
}

}  // namespace reye::fit
