#pragma once
#include "scene/check.hpp"
#include "scene/entry.hpp"
#include "scene/scene.hpp"

/// Loads as they were measured: histories and levels of a spectrum from CSV files.
namespace reye::scene {

/// The points that are left of a series when straight lines between them stay within `band` of all others, first and
/// last kept, and every turn that is deeper than the band: from each kept point the farthest one whose line passes all
/// bands between (swinging door).
History thinned(const History& all, double band);

/// Sum of the ways up and down of a history.
double way_of(const History& history);

/// The history of a table of keys: the file read, its time made progress, closed where that is asked for, and thinned.
/// Empty, and an issue, where the file cannot serve.
std::optional<Measured> measured_history(const Entry& entry, const std::string& scene_path, Issues& issues);

/// The levels of a spectrum and the cycles at each: rows of a CSV file headed `level,cycles`. None, and an issue, where
/// the file cannot serve.
std::vector<std::array<double, 2>> levels_of(const Entry& spectrum, const std::string& scene_path, Issues& issues);

}  // namespace reye::scene
