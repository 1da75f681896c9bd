#include "body/translation.hpp"

#include <cmath>

#include "algebra/decompose.hpp"
#include "algebra/product.hpp"

namespace reye::body {

Translation::Translation(const Matrix& T) : T_(T) {
  mean_ = algebra::product_transposed(algebra::pseudo_inverse(algebra::transposed_product(T, T)), T);
}

Translation Translation::part(const std::vector<int>& columns) const { return Translation(T_(columns, Eigen::all)); }

Vec2 Translation::of(const Vector& q) const { return mean_ * q; }

Vector Translation::without(const TwoPart& q) const { return without(of(q.high), q); }

/// A row of T a, with twice the digits.
base::ExactSum Translation::moved(Eigen::Index column, const Vec2& a) const {
  const double x = T_(column, 0) * a.x(), y = T_(column, 1) * a.y();
  const auto [sum, rest] = base::exact_sum(x, y);
  return {sum, rest + std::fma(T_(column, 0), a.x(), -x) + std::fma(T_(column, 1), a.y(), -y)};
}

Vector Translation::without(const Vec2& a, const TwoPart& q) const {
  Vector v(q.high.size());
  for (Eigen::Index i = 0; i < v.size(); ++i) {
    const auto rigid = moved(i, a);
    const auto [difference, rest] = base::exact_sum(q.high[i], -rigid.sum);
    v[i] = difference + (rest + (q.low[i] - rigid.rest));
  }
  return v;
}

TwoPart Translation::with(const Vec2& a, const Vector& v) const {
  TwoPart q{v, Vector::Zero(v.size())};
  for (Eigen::Index i = 0; i < v.size(); ++i) {
    const auto rigid = moved(i, a);
    const auto [sum, rest] = base::exact_sum(rigid.sum, v[i]);
    const auto [high, low] = base::exact_sum(sum, rest + rigid.rest);
    q.high[i] = high;
    q.low[i] = low;
  }
  return q;
}

}  // namespace reye::body
