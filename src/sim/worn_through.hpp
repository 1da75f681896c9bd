#pragma once
#include <optional>

#include "sim/problem.hpp"
#include "sim/state.hpp"

namespace reye::sim {

/// Where a worn body is thinnest against what it was there: along the inward normal of its worn side, to its outline
/// beyond.
struct Thinnest {
  int body = 0;
  double left_mm = 0.0, worn_mm = 0.0;  ///< together what it was at cycle 0

  double share_left() const { return left_mm / (left_mm + worn_mm); }
};

/// Less than this share of what a body was is too thin to be meshed: the run ends before.
inline constexpr double thinnest_share = 0.05;

/// Over all nodes of worn sides on these shapes; empty where nothing is worn.
std::optional<Thinnest> thinnest(const Problem& problem, const std::vector<body::ShapePtr>& shapes);

/// What ends a run there, with what to change.
std::string in_words(const Problem& problem, const Thinnest& thinnest, double cycle);

/// The message where a body of the state has lost a fifth of its thickness, so that a failure is due to it. Else
/// empty.
std::string worn_through(const Problem& problem, const State& last);

}  // namespace reye::sim
