#include "adapt/solid/harmonic.hpp"

#include <algorithm>
#include <mutex>
#include <optional>

#include "algebra/factor.hpp"

namespace reye::adapt {

namespace {

using base::Matrix;
using base::SparseMatrix;
using base::Triplet;
using base::Vector;

Matrix rows_at(const Points3& motion, const std::vector<int>& nodes) {
  Matrix rows(static_cast<int>(nodes.size()), 3);
  for (std::size_t k = 0; k < nodes.size(); ++k) rows.row(static_cast<int>(k)) = motion[nodes[k]].transpose();
  return rows;
}

}  // namespace

struct HarmonicExtension::Impl {
  std::vector<int> inner, outer;  ///< nodes
  Vector height;                  ///< of inner nodes
  SparseMatrix K, coupling;       ///< inner rows; columns of inner and of outer nodes
  std::mutex solving;             ///< the factor has work space of its own
  std::optional<algebra::SchurFactor> factor;

  Matrix load(const Points3& motion) const { return -(coupling * rows_at(motion, outer)); }
};

HarmonicExtension::HarmonicExtension(const std::vector<char>& free, const std::vector<double>& height,
                                     const std::vector<Triplet>& k)
    : impl_(std::make_unique<Impl>()) {
  std::vector<int> number(free.size(), -1);
  std::vector<Triplet> inner, coupling;
  const auto number_of = [&](int node, std::vector<int>& list) {
    if (number[node] < 0) {
      number[node] = static_cast<int>(list.size());
      list.push_back(node);
    }
    return number[node];
  };
  for (const Triplet& entry : k) {
    if (!free[entry.row()]) continue;
    const int row = number_of(entry.row(), impl_->inner);
    const bool is_inner = free[entry.col()];
    (is_inner ? inner : coupling)
        .emplace_back(row, number_of(entry.col(), is_inner ? impl_->inner : impl_->outer), entry.value());
  }
  const int rows = static_cast<int>(impl_->inner.size());
  impl_->K.resize(rows, rows);
  impl_->K.setFromTriplets(inner.begin(), inner.end());
  impl_->coupling.resize(rows, static_cast<int>(impl_->outer.size()));
  impl_->coupling.setFromTriplets(coupling.begin(), coupling.end());
  impl_->height.resize(rows);
  for (int i = 0; i < rows; ++i) impl_->height[i] = height[impl_->inner[i]];
}

HarmonicExtension::~HarmonicExtension() = default;

double HarmonicExtension::unrest(const Points3& motion) const {
  if (impl_->inner.empty()) return 0.0;
  const Matrix residual = impl_->load(motion) - impl_->K * rows_at(motion, impl_->inner);
  return residual.rowwise().norm().cwiseQuotient(impl_->K.diagonal().cwiseProduct(impl_->height)).maxCoeff();
}

void HarmonicExtension::extend(Points3& motion) const {
  if (impl_->inner.empty()) return;
  const Matrix load = impl_->load(motion);
  const std::lock_guard lock(impl_->solving);
  if (!impl_->factor)
    impl_->factor.emplace(impl_->K, 0, algebra::SchurAnalysisPtr{}, algebra::Ordering::nested_dissection);
  for (int c = 0; c < 3; ++c) {
    if (load.col(c).isZero(0.0)) {
      for (int node : impl_->inner) motion[node][c] = 0.0;
      continue;
    }
    const Vector v = impl_->factor->recover(load.col(c), Vector(0));
    for (std::size_t k = 0; k < impl_->inner.size(); ++k) motion[impl_->inner[k]][c] = v[static_cast<int>(k)];
  }
}

}  // namespace reye::adapt
