#include "body/superelement.hpp"

#include <algorithm>
#include <cmath>

namespace reye::body {

using base::Vector;

Superelement::Superelement(const SparseMatrix& K, const std::vector<char>& inside, bool symmetric, Tangent tangent) {
  std::vector<char> touched(inside.size(), 0);
  for (int c = 0; c < K.outerSize(); ++c)
    for (SparseMatrix::InnerIterator e(K, c); e; ++e)
      if (e.value() != 0.0) touched[static_cast<std::size_t>(e.row())] = 1;
  std::vector<int> place(inside.size(), -1);
  for (const bool is_inside : {true, false})
    for (std::size_t c = 0; c < inside.size(); ++c) {
      if (!touched[c] || (inside[c] != 0) != is_inside) continue;
      place[c] = static_cast<int>(inside_.size() + shared_.size());
      (is_inside ? inside_ : shared_).push_back(static_cast<int>(c));
    }
  std::vector<base::Triplet> entries;
  entries.reserve(static_cast<std::size_t>(K.nonZeros()));
  for (int c = 0; c < K.outerSize(); ++c)
    for (SparseMatrix::InnerIterator e(K, c); e; ++e) {
      const int row = place[static_cast<std::size_t>(e.row())], column = place[static_cast<std::size_t>(c)];
      if (row >= 0 && column >= 0) entries.emplace_back(row, column, e.value());
    }
  const auto size = static_cast<Eigen::Index>(inside_.size() + shared_.size());
  SparseMatrix own(size, size);
  own.setFromTriplets(entries.begin(), entries.end());
  condensation_.factorise(own, static_cast<int>(shared_.size()), symmetric, tangent);
}

/// r of the columns inside, in the order of the factor, and nothing on those that are shared.
Vector Superelement::loads_inside(const Vector& r) const {
  Vector own = Vector::Zero(static_cast<Eigen::Index>(inside_.size() + shared_.size()));
  for (std::size_t k = 0; k < inside_.size(); ++k) own[static_cast<Eigen::Index>(k)] = r[inside_[k]];
  return own;
}

void Superelement::condense(Vector& r, double negligible) const {
  const auto small = [&](int column) { return std::abs(r[column]) <= negligible; };
  if (std::all_of(inside_.begin(), inside_.end(), small)) return;
  const Vector condensed = condensation_.condense(loads_inside(r));
  for (std::size_t k = 0; k < shared_.size(); ++k) r[shared_[k]] += condensed[static_cast<Eigen::Index>(k)];
}

void Superelement::recover(const Vector& r, Vector& u) const {
  Vector at(shared_.size());
  for (std::size_t k = 0; k < shared_.size(); ++k) at[static_cast<Eigen::Index>(k)] = u[shared_[k]];
  const Vector all = condensation_.recover(loads_inside(r), at);
  for (std::size_t k = 0; k < inside_.size(); ++k) u[inside_[k]] = all[static_cast<Eigen::Index>(k)];
}

}  // namespace reye::body
