#pragma once
#include <string>
#include <vector>

#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"

/// Fine zones that follow the contact as wear widens and moves it.
namespace reye::sim {

/// The fine zones of a contact that a drawing has.
std::vector<const cad::FineZone*> zones_of(const cad::Drawing& drawing, const std::string& contact);

/// The zone as the scene asks for it, by its key; none for a zone that the program has added.
const cad::FineZone* asked_for(const Problem& problem, const cad::FineZone& zone);

/// "contact pad comes within ... of the end of its fine zone" when a node of the body that touches, or has worn in this
/// block, lies within three elements of an end of its zone or beyond; empty else. `shape`: the body after the move.
std::string leaves_zone(const Problem& problem, const State& state, int body, const body::Shape& shape);

/// The zones of a fresh mesh of the body. A zone that still contains the part of its contact nearest to it keeps its
/// width; one that does not gets 1.5 times the half width in use, and its size and depth grow in the same ratio to the
/// scene's, so that the number of elements across stays. Its centre moves to the outline.
std::vector<cad::FineZone> followed_zones(const Problem& problem, const State& state, int body,
                                          const body::Shape& shape);

}  // namespace reye::sim
