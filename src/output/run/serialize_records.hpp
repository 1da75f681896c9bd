#pragma once
#include "sim/problem/records.hpp"
#include "sim/problem/watch.hpp"

/// cereal functions for the records that states of every kind of run carry. A member that is added to one of them and
/// not to its list here does not compile.
namespace reye::sim {

template <class Archive>
void serialize(Archive& archive, Counts& c) {
  auto& [blocks, increments, newton, factorisations, remeshes, cutbacks, cycles_solved, refused_blocks, equilibria] = c;
  archive(blocks, increments, newton, factorisations, remeshes, cutbacks, cycles_solved, refused_blocks, equilibria);
}

template <class Archive>
void serialize(Archive& archive, Warning& w) {
  auto& [kind, about, text, severity] = w;
  archive(kind, about, text, severity);
}

template <class Archive>
void serialize(Archive& archive, StickZone& z) {
  auto& [stick, contact, element] = z;
  archive(stick, contact, element);
}

}  // namespace reye::sim
