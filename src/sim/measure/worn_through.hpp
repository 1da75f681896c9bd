#pragma once
#include <optional>

#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"

namespace reye::sim {

/// The place where a worn body is thinnest against its first thickness there, along the inward normal of its worn side
/// to the outline beyond.
struct Thinnest {
  int body = 0;
  double left_mm = 0.0, worn_mm = 0.0;  ///< their sum is the thickness at cycle 0

  double share_left() const { return left_mm / (left_mm + worn_mm); }
};

/// Share of its first thickness below which a body is too thin to be meshed, so that the run ends before.
inline constexpr double thinnest_share = 0.05;

/// The thinnest place over all nodes of worn sides on these shapes; empty where nothing is worn.
std::optional<Thinnest> thinnest(const Problem& problem, const std::vector<body::ShapePtr>& shapes);

/// The message of a run that ends there, with what to change.
std::string in_words(const Problem& problem, const Thinnest& thinnest, double cycle);

/// The message where a body of the state has lost a fifth of its thickness, so that a failure is due to it. Else
/// empty.
std::string worn_through(const Problem& problem, const State& last);

}  // namespace reye::sim
