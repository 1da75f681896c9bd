#pragma once
#include <string>

#include "scene/check.hpp"
#include "scene/measured_scars.hpp"

/// Tables of a profilometer and of a force sensor.
namespace reye::scene {

/// Reads a profile, or a map, from a CSV file; what it breaks is added to `issues` under `key`.
void read_scar_file(const std::string& path, bool map, const std::string& key, MeasuredScar& scar, Issues& issues);

/// The energy in a loop of tangential force over stroke, one cycle in the order of time: |sum of (F_i + F_i+1)/2
/// (x_i+1 - x_i)|, closed by its first row [mJ; in plane scenes per mm]. 0, and an issue under `key`, where the file
/// cannot serve. `whole`: forces are in N, not per mm.
double energy_of_loop(const std::string& path, bool whole, const std::string& key, Issues& issues);

}  // namespace reye::scene
