#pragma once
#include "scene/key.hpp"

/// Rows that the tables of plane scenes and of solids have in common, and the ranges that rows are written with.
namespace reye::scene::rows {

inline constexpr Range any{};
inline constexpr Range positive{.low = 0.0, .low_open = true};
constexpr Range at_least(double low) { return {.low = low}; }
constexpr Range from_to(double low, double high) { return {.low = low, .high = high}; }
constexpr Range one_of(std::string_view choices) { return {.choices = choices}; }

// clang-format off
inline constexpr Key title{
    "title", Type::text, "", "", any, "headline of the results; by default the scene's name"};
inline constexpr Key geometry{
    "geometry", Type::texts, "", "required", any,
    "geometry files in mm (.step .stp .iges .igs .brep .geo .msh .vtu); paths count from the scene file"};
inline constexpr Key modulus{
    "material.*.E_MPa", Type::number, "MPa", "required", positive, "Young's modulus"};
inline constexpr Key poisson{
    "material.*.nu", Type::number, "", "required",
    {.low = -1.0, .high = 0.5, .low_open = true, .high_open = true}, "Poisson's ratio"};
inline constexpr Key body_material{
    "body.*.material", Type::text, "", "", any, "one of the materials; none for a rigid body"};
inline constexpr Key body_rigid{
    "body.*.rigid", Type::flag, "", "false", any, "the body does not deform"};
inline constexpr Key mesh_growth{
    "body.*.mesh.growth", Type::number, "", "1.3", {.low = 1.0, .high = 3.0, .low_open = true},
    "ratio of neighbouring element sizes away from fine zones"};
inline constexpr Key search{
    "contact.*.search_mm", Type::number, "mm", "", positive,
    "facets farther apart are not paired; by default chosen from the size of the bodies"};
inline constexpr Key pressure{
    "load.*.pressure_MPa", Type::number, "MPa", "", any, "pressure, > 0 pushes on the body"};
inline constexpr Key load_history{
    "load.*.history", Type::text, "", "", any,
    "history of its factor over a step; without one the full value acts from the start"};
inline constexpr Key part_pressure{
    "load.*.parts[].pressure_MPa", Type::number, "MPa", "", any,
    "value of one part of a load, which is the sum of a list of parts"};
inline constexpr Key part_history{
    "load.*.parts[].history", Type::text, "", "", any, "history of that part"};
inline constexpr Key history{
    "history.*", Type::history, "", "", any, "[progress of the step, factor], progress from 0 to 1; or measured:"};
inline constexpr Key history_file{
    "history.*.file", Type::text, "", "required", any,
    "CSV file with a line of names; its first column is time_s or progress; the path counts from the scene file"};
inline constexpr Key history_column{
    "history.*.column", Type::text, "", "", any, "the column of factors; by default the second"};
inline constexpr Key history_tolerance{
    "history.*.tolerance", Type::number, "", "0.01", {.low = 0.0, .high = 0.2},
    "points are left out where straight lines between the others stay this close, as a share of the range; 0 keeps "
    "all that are not on a line"};
inline constexpr Key history_close{
    "history.*.close", Type::flag, "", "false", any,
    "true: after the last point the way back to the first value is added, one mean interval long"};
inline constexpr Key step_name{
    "step[].name", Type::text, "", "", any, "name in messages; by default its number"};
inline constexpr Key step_play{
    "step[].play", Type::texts, "", "[]", any, "histories played; the others keep their last factor"};
inline constexpr Key step_increments{
    "step[].increments", Type::whole, "", "1", from_to(1.0, 1e5),
    "number of equal increments; corners of histories are always ends of increments"};
inline constexpr Key frames_per_step{
    "output.frames.per_step", Type::whole, "", "", at_least(0.0),
    "frames of a step that counts cycles, evenly spaced, at most one per block; by default 5 without any other rule"};
inline constexpr Key frames_every_cycles{
    "output.frames.every_cycles", Type::number, "", "0", at_least(0.0), "cycles between frames"};
inline constexpr Key frames_per_decade{
    "output.frames.per_decade", Type::whole, "", "0", at_least(0.0),
    "frames per factor of ten in cycles, at most one per block"};
inline constexpr Key frames_every_increment{
    "output.frames.every_increment", Type::flag, "", "false", any, "a frame at each increment"};
inline constexpr Key frames_last_block{
    "output.frames.last_block", Type::flag, "", "false", any, "a frame at each increment of the last block of a step"};
inline constexpr Key frames_paraview{
    "output.frames.paraview", Type::flag, "", "true", any,
    "false: rows of the surface tables alone, no .vtu and .vtp; stress inside the bodies is not computed"};
inline constexpr Key checkpoint{
    "output.checkpoint_s", Type::number, "s", "1", at_least(0.0),
    "least wall time between two checkpoints; 0: one at each block end. The last block end of a run is always kept"};
inline constexpr Key probe_body{
    "output.probes.*.body", Type::text, "", "required", any, "body of the probe"};
inline constexpr Key max_newton{
    "solver.max_newton", Type::whole, "", "30", at_least(1.0), "Newton iterations before an increment is cut"};
inline constexpr Key max_cutbacks{
    "solver.max_cutbacks", Type::whole, "", "8", at_least(0.0), "halvings of an increment before the run fails"};
// clang-format on

}  // namespace reye::scene::rows
