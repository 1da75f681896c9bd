#include "fit/linear.hpp"

namespace reye::fit {

Normal normal_at(const std::vector<Record>& records, const Model& model, const Unknowns& at) {
  const Eigen::Index p = at.theta.size();
  Eigen::Index size = p;
  for (const Record& record : records) size += record.shifts();
  Normal normal{Matrix::Zero(size, size), Vector::Zero(size)};
  Eigen::Index first = p;
  for (const Record& record : records) {
    const int shifts = record.shifts();
    const Matrix gram = gram_of(record, columns_of(record, model, at));
    const auto theta = gram.middleRows(shifts, p);
    normal.H.topLeftCorner(p, p) += theta.middleCols(shifts, p);
    normal.H.block(0, first, p, shifts) = theta.leftCols(shifts);
    normal.H.block(first, 0, shifts, p) = theta.leftCols(shifts).transpose();
    normal.H.block(first, first, shifts, shifts) = gram.topLeftCorner(shifts, shifts);
    normal.g.head(p) += theta.rightCols(1);
    normal.g.segment(first, shifts) = gram.topRightCorner(shifts, 1);
    normal.S += gram(shifts + p, shifts + p);
    first += shifts;
  }
  return normal;
}

Unknowns moved(const std::vector<Record>& records, Unknowns at, const Vector& step) {
  at.theta += step.head(at.theta.size());
  Eigen::Index i = at.theta.size();
  for (const Record& record : records)
    for (int j = 0; j < record.shifts(); ++j) at.shift[record.number][j] += step[i++];
  return at;
}

}  // namespace reye::fit
