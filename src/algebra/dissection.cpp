#include <cholmod.h>

#include <cstdint>
#include <mutex>
#include <numeric>

#include "algebra/supernodal.hpp"

namespace reye::algebra {

namespace {

/// A number that looks random and is a function of k: splitmix64.
std::uint64_t scrambled(std::uint64_t k) {
  k = (k + 1) * 0x9e3779b97f4a7c15u;
  k = (k ^ (k >> 30)) * 0xbf58476d1ce4e5b9u;
  k = (k ^ (k >> 27)) * 0x94d049bb133111ebu;
  return k ^ (k >> 31);
}

/// The point of the graph to which each row belongs: the next one where its entries differ from those of the row
/// before. They are compared by the sum of the scrambled numbers of all columns; two rows that agree by chance would
/// cost fill, not correctness.
std::vector<int> points_of(const base::SparseMatrix& K, int count) {
  std::vector<std::uint64_t> sum(static_cast<size_t>(count));
  for (int j = 0; j < count; ++j) {
    sum[j] += scrambled(static_cast<std::uint64_t>(j));
    for (base::SparseMatrix::InnerIterator it(K, j); it && it.index() < j; ++it) {
      sum[j] += scrambled(static_cast<std::uint64_t>(it.index()));
      sum[it.index()] += scrambled(static_cast<std::uint64_t>(j));
    }
  }
  std::vector<int> point(sum.size(), 0);
  for (int j = 1; j < count; ++j) point[j] = point[j - 1] + (sum[j] != sum[j - 1]);
  return point;
}

/// Upper triangle of the graph, by columns.
struct Graph {
  std::vector<int> start{0}, row;

  Graph(const base::SparseMatrix& K, const std::vector<int>& point) {
    for (int j = 0; j < static_cast<int>(point.size()); ++j) {
      if (j > 0 && point[j] == point[j - 1]) continue;
      for (base::SparseMatrix::InnerIterator it(K, j); it && it.index() <= j; ++it)
        if (row.size() == static_cast<size_t>(start.back()) || row.back() != point[it.index()])
          row.push_back(point[it.index()]);
      start.push_back(static_cast<int>(row.size()));
    }
  }

  cholmod_sparse view() {
    cholmod_sparse A{};
    A.nrow = A.ncol = start.size() - 1;
    A.nzmax = row.size();
    A.p = start.data();
    A.i = row.data();
    A.stype = 1;
    A.itype = CHOLMOD_INT;
    A.xtype = CHOLMOD_PATTERN;
    A.dtype = CHOLMOD_DOUBLE;
    A.sorted = A.packed = 1;
    return A;
  }
};

}  // namespace

std::vector<int> nested_dissection(const base::SparseMatrix& K, int count) {
  std::vector<int> order;
  if (count == 0) return order;
  const std::vector<int> point = points_of(K, count);
  Graph graph(K, point);
  cholmod_sparse A = graph.view();
  std::vector<int> of_points(A.ncol);
  Workspace workspace;
  static std::mutex one_at_a_time;  // METIS draws its random numbers from a sequence of the whole process
  const std::lock_guard lock(one_at_a_time);
  cholmod_metis(&A, nullptr, 0, 1, of_points.data(), &workspace.common);
  workspace.check("nested dissection");
  std::vector<int> first(A.ncol + 1, 0);
  for (int p : point) ++first[p + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  order.reserve(point.size());
  for (int p : of_points)
    for (int j = first[p]; j < first[p + 1]; ++j) order.push_back(j);
  return order;
}

}  // namespace reye::algebra
