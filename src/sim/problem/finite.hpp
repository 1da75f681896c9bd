#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "contact/state.hpp"

/// What a state that was read from a file is checked by.
namespace reye::sim {

/// Throws std::runtime_error with the contradiction where this does not hold.
inline void require(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error("altered: " + what);
}

template <class Number>
bool counted(Number value, Number most) {
  return value >= 0 && value <= most;
}

/// Whether there are as many as there must be; none is none at all.
inline bool optional(std::size_t size, std::size_t full) { return size == 0 || size == full; }

inline bool finite(double value) { return std::isfinite(value); }
template <class Values>
bool finite(const Eigen::DenseBase<Values>& values) {
  return values.derived().array().isFinite().all();
}
inline bool finite(const std::optional<double>& value) { return !value || std::isfinite(*value); }
inline bool finite(const std::pair<int, double>& share) { return std::isfinite(share.second); }
inline bool finite(const contact::MortarRow& row);
template <class T>
bool finite(const std::vector<T>& list);
template <class T, std::size_t N>
bool finite(const std::array<T, N>& list) {
  return std::all_of(list.begin(), list.end(), [](const auto& v) { return finite(v); });
}
template <class T>
bool finite(const std::vector<T>& list) {
  return std::all_of(list.begin(), list.end(), [](const auto& v) { return finite(v); });
}
inline bool finite(const contact::MortarRow& row) {
  return finite(row.D) && finite(row.cover) && finite(row.covered) && finite(row.off) && finite(row.M);
}

}  // namespace reye::sim
