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
inline constexpr Key remesh_automatic{
    "remesh.automatic", Type::flag, "", "true", any,
    "a worn body is remeshed when one of the bounds below is passed; false: the run ends instead"};
inline constexpr Key remesh_every_blocks{
    "remesh.every_blocks", Type::whole, "", "0", at_least(0.0),
    "blocks between remeshes of all bodies in contact, needed or not; 0: only when needed"};
inline constexpr Key remesh_wear_fraction{
    "remesh.wear_fraction", Type::number, "", "0.5", {.low = 0.0, .high = 2.0, .low_open = true},
    "depth worn since the last mesh, over the height of the element below"};
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
inline constexpr Key shape{
    "shape", Type::text, "", "on", one_of("on|off"), "off: wear only opens the gap, the surfaces are not moved"};
inline constexpr Key implicit{
    "contact.*.implicit", Type::flag, "", "true", any,
     "wear is implicit: it enters the contact equations of its own increment"};
inline constexpr Key wear_law{
    "contact.*.wear.law", Type::text, "", "required", one_of("energy|archard|rate"),
     "removed volume = coefficient x frictional work, or x pressure x slip, or x slip; each coefficient may be a "
     "formula of pressure_MPa, speed_mm_per_s (wearing steps then need period_s), path_mm (of slip, at the secondary "
     "side's node), depth_mm (worn off its own side) and cycle, such as \"depth_mm < 0.002 ? 1e-6 : 3e-5\""};
inline constexpr Key wear_energy{
    "contact.*.wear.{secondary,primary}_mm3_per_J", Type::formula, "mm^3/J", "0.0", at_least(0.0),
     "coefficient of each side, energy law"};
inline constexpr Key wear_archard{
    "contact.*.wear.{secondary,primary}_per_MPa", Type::formula, "1/MPa", "0.0", at_least(0.0),
     "coefficient of each side, Archard's law"};
inline constexpr Key wear_rate{
    "contact.*.wear.{secondary,primary}_mm_per_mm", Type::formula, "mm/mm", "0.0", at_least(0.0),
     "depth per sliding distance of each side, law = \"rate\": the whole rate is the formula's"};
inline constexpr Key wear_pressure_exponent{
    "contact.*.wear.pressure_exponent", Type::number, "", "0.0", {.low = -1.0, .low_open = true},
     "m: the removed volume times (pressure / pressure_ref_MPa)^m"};
inline constexpr Key wear_pressure_ref{
    "contact.*.wear.pressure_ref_MPa", Type::number, "MPa", "", positive, "pressure for which the coefficients hold"};
inline constexpr Key wear_speed_exponent{
    "contact.*.wear.speed_exponent", Type::number, "", "0.0", {.low = -1.0, .low_open = true},
     "n: the removed volume times (sliding speed / speed_ref_mm_per_s)^n; wearing steps need period_s"};
inline constexpr Key wear_speed_ref{
    "contact.*.wear.speed_ref_mm_per_s", Type::number, "mm/s", "", positive,
     "sliding speed for which the coefficients hold"};
inline constexpr Key wear_threshold{
    "contact.*.wear.threshold_mJ_per_mm2", Type::number, "mJ/mm^2", "0.0", at_least(0.0),
     "energy law: frictional work per area that must be dissipated at a place before it wears"};
inline constexpr Key step_wear{
    "step[].wear", Type::flag, "", "true", any, "false: nothing wears in this step"};
inline constexpr Key step_cycles{
    "step[].cycles", Type::number, "", "0", at_least(0.0),
     "number of repetitions; 0: a load step, which does not count as a cycle"};
inline constexpr Key step_jump{
    "step[].jump", Type::number, "", "1", at_least(1.0),
     "cycles per block; where a body yields, the first block is played in parts that double, from one cycle on, while it "
     "shakes down; by default 1, or with `accuracy` a tolerance; or a table:"};
inline constexpr Key accuracy{"accuracy", Type::number, "", "", {.low = 0.0, .high = 0.2, .low_open = true},
     "relative error asked for, of worn profiles, or of tractions without wear: a pilot run chooses the element size "
     "of fine zones without `size_mm`; wearing steps without `jump` get half of it as tolerance"};
inline constexpr Key estimate_error{"output.estimate_error", Type::flag, "", "", any,
     "by default true with `accuracy`, else false; true: the run is repeated on elements twice as large, which gives "
     "the error of the mesh and takes some 0.4 of a long run's time"};
inline constexpr Key step_jump_tolerance{
    "step[].jump.tolerance", Type::number, "", "required", {.low = 1e-5, .high = 0.2},
     "error of depth profile and worn volume by which the run chooses its blocks"};
inline constexpr Key step_jump_first{
    "step[].jump.first", Type::number, "", "", at_least(1.0),
     "cycles of the first block; by default a thousandth of the step"};
inline constexpr Key step_jump_most{
    "step[].jump.most", Type::number, "", "", at_least(1.0), "largest number of cycles of a block"};
inline constexpr Key step_period{
    "step[].period_s", Type::number, "s", "", positive,
     "duration of one play of the step; needed only with a speed exponent"};
inline constexpr Key spectrum_steps{
    "spectrum.steps", Type::texts, "", "required", any, "consecutive steps that are repeated in this order"};
inline constexpr Key spectrum_levels{
    "spectrum.levels", Type::text, "", "", any,
     "CSV file headed `level,cycles`: the steps are played at each level in turn, all factors they play multiplied by "
     "it, with its number of cycles in place of their own"};
inline constexpr Key spectrum_times{
    "spectrum.times", Type::whole, "", "required", from_to(1.0, 1e5), "number of repetitions"};
inline constexpr Key limit_contact{
    "limit.*.contact", Type::text, "", "required", any, "contact to watch"};
inline constexpr Key limit_side{
    "limit.*.side", Type::text, "", "secondary", one_of("secondary|primary|sum"), "side to watch, or their sum"};
inline constexpr Key limit_depth{
    "limit.*.depth_mm", Type::number, "mm", "", positive, "largest wear depth; or"};
inline constexpr Key limit_stop{
    "limit.*.stop", Type::flag, "", "false", any, "true: the run ends at the limit"};
inline constexpr Key limit_wear_factor{
    "limit.*.wear_factor", Type::pair, "", "", positive,
     "[lowest, highest] factor on all wear coefficients, their scatter: the limit's life is reported as a band, life / "
     "factor"};
inline constexpr Key frames_every_blocks{
    "output.frames.every_blocks", Type::whole, "", "0", at_least(0.0), "blocks of a step between frames"};
inline constexpr Key frames_at_remeshes{
    "output.frames.at_remeshes", Type::flag, "", "false", any, "a frame at the end of each block with a remesh"};
inline constexpr Key history_every_blocks{
    "output.history.every_blocks", Type::whole, "", "1", at_least(1.0),
     "blocks of a step between rows of history.csv; the first and last block always have rows"};
// clang-format on

}  // namespace reye::scene::rows
