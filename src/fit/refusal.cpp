#include "fit/refusal.hpp"

#include <cmath>

#include "algebra/decompose.hpp"

namespace reye::fit {

namespace {

bool finite(const Series& series) {
  for (const Vec2& p : series.at)
    if (!p.allFinite()) return false;
  return series.value.allFinite() && series.scatter.allFinite();
}

std::string numbers(Eigen::Index count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

std::string refusal_of(const std::vector<Series>& series, Eigen::Index parameters) {
  Eigen::Index values = 0, unknowns = parameters;
  for (const Series& one : series) {
    if (!finite(one)) return one.name + " holds a value that is not finite";
    const Eigen::Index count = one.value.size(),
                       own = (one.level ? (one.map ? 3 : 2) : 0) + (one.moved ? (one.map ? 2 : 1) : 0);
    if (count == 0) return one.name + " holds no value";
    if (one.scatter.size() > 0 && !(one.scatter.minCoeff() > 0.0))
      return one.name + " has a scatter that is not above zero";
    if (one.scatter.size() == 0 && count <= own + parameters)
      return one.name + " has no scatter, and " + numbers(count, "value") + " for " +
             numbers(own + parameters, "unknown") +
             " (parameters, offset, tilt, place) leave nothing to find it from: give its scatter";
    values += count;
    unknowns += own;
  }
  if (values < unknowns)
    return numbers(values, "value") + " cannot give " + numbers(unknowns, "unknown") +
           " (parameters, and offset, tilt and place of each series)";
  return {};
}

std::string undetermined(const std::vector<Scores>& scores, const std::vector<std::string>& names) {
  constexpr double least = 1e-8;
  const auto p = static_cast<Eigen::Index>(names.size());
  Matrix information = Matrix::Zero(p, p);
  for (const Scores& one : scores) information += one.information;
  for (Eigen::Index k = 0; k < p; ++k)
    if (!(information(k, k) > 0.0)) return names[k] + " is not determined: nothing that was measured changes with it";
  const Vector scale = information.diagonal().cwiseSqrt().cwiseInverse();
  const auto [values, vectors] = algebra::eigenpairs(scale.asDiagonal() * information * scale.asDiagonal());
  if (values[0] > least) return {};
  std::string involved;
  for (Eigen::Index k = 0; k < p; ++k)
    if (std::abs(vectors(k, 0)) > 0.1) involved += (involved.empty() ? "" : " and ") + names[k];
  return involved + " are not determined: what was measured changes with one combination of them alone";
}

std::string unbounded(const std::string& name, bool below) {
  return name + " is not determined: at 95 % what was measured allows a value a thousand times " +
         (below ? "smaller, as without any wear" : "larger");
}

}  // namespace reye::fit
