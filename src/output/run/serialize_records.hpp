#pragma once
#include "sim/problem/block_wear.hpp"
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

template <class Archive>
void serialize(Archive& archive, WornUntil& w) {
  auto& [progress, volumes] = w;
  archive(progress, volumes);
}

template <class Archive>
void serialize(Archive& archive, CourseOfWear& w) {
  auto& [cycles, until] = w;
  archive(cycles, until);
}

template <class Archive, class Contact>
void serialize(Archive& archive, BlockWear<Contact>& w) {
  auto& [cycles, contacts, measures, course] = w;
  archive(cycles, contacts, measures, course);
}

}  // namespace reye::sim
