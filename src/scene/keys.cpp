#include "scene/keys.hpp"

#include "scene/shared_keys.hpp"

namespace reye::scene {

/// The rows of plane scenes, in the order of the reference.
namespace plane_rows {

using namespace rows;

// One key a paragraph.
// clang-format off
constexpr Key table[] = {
    title,
    {"analysis", Type::text, "", "plane_strain", one_of("plane_strain|plane_stress|axisymmetric|solid"),
     "idealisation; axisymmetric: r = x >= 0, axis y; of a section drawn on both sides of the axis the half x >= 0 is "
     "taken; solid: three dimensions, with keys of their own, below"},
    accuracy,
    geometry,
    {"section.point_mm", Type::triple, "mm", "required", any,
     "a point of the plane that cuts every solid of the geometry files into faces"},
    {"section.normal", Type::triple, "", "required", any, "normal of that plane; length and sign do not matter"},
    shape,

    {"material.*.law", Type::text, "", "linear_elastic",
     one_of("linear_elastic|st_venant_kirchhoff|neo_hookean|hencky|hencky_cauchy|hencky_j2"),
     "stress law; `linear_elastic` is for small strain only, where the other elastic laws reduce to it; "
     "hencky: Kirchhoff stress linear in log strain, hencky_cauchy: Cauchy stress"},
    modulus,
    poisson,
    {"material.*.volumetric", Type::text, "", "log_squared", one_of("log_squared|quadratic|mixed|power"),
     "volumetric part of the neo-Hookean energy: lambda/2 (ln J)^2, lambda/2 (J - 1)^2, lambda/4 (J^2 - 1 - 2 ln J); "
     "power: mu/2 (I1 - 3) + mu/(2 beta) (J^(-2 beta) - 1) as a whole, beta = nu/(1 - 2 nu)"},
    {"material.*.hardening.law", Type::text, "", "required", one_of("linear|voce|swift|table"),
     "yield stress over accumulated plastic strain p, `hencky_j2`"},
    {"material.*.hardening.yield_MPa", Type::number, "MPa", "", positive, "yield stress at p = 0, linear and voce"},
    {"material.*.hardening.modulus_MPa", Type::number, "MPa", "0.0", at_least(0.0),
     "linear part: modulus x p, linear and voce"},
    {"material.*.hardening.saturation_MPa", Type::number, "MPa", "", positive,
     "voce: + (saturation - yield)(1 - exp(-rate p))"},
    {"material.*.hardening.rate", Type::number, "", "", positive, "rate of that saturation"},
    {"material.*.hardening.strength_MPa", Type::number, "MPa", "", positive, "swift: strength (offset + p)^exponent"},
    {"material.*.hardening.offset", Type::number, "", "", positive, "offset of p"},
    {"material.*.hardening.exponent", Type::number, "", "", {.low = 0.0, .high = 1.0, .low_open = true}, "exponent"},
    {"material.*.hardening.points", Type::curve, "MPa", "", at_least(0.0),
     "table: [p, yield stress] from p = 0 on, linear between, constant beyond"},

    {"body.*.at", Type::pair, "mm", "", any, "a point inside the body"},
    {"body.*.name", Type::text, "", "", any,
     "label in the geometry (STEP product, physical surface); with neither `at` nor `name` the name of the body in the "
     "scene"},
    body_material,
    body_rigid,
    {"body.*.b_bar", Type::flag, "", "", any,
     "remedy for volumetric locking, B-bar or (finite) F-bar; by default on for quads of order 1 in plane strain and "
     "axisymmetry"},
    {"body.*.kinematics", Type::text, "", "small", one_of("small|finite|auto"),
     "strain measure; of the secondary body also that of its contact: per length on X (small) or on x (finite); auto: "
     "small where a trial estimates its error at 1 % or less, else finite (`plan` reports the choice), where "
     "linear_elastic becomes hencky. At small strain linear_elastic bodies that can turn do so by any angle; without "
     "this key strain above 1 % causes a warning, and above 5 % ends the run"},
    {"body.*.order", Type::whole, "", "", one_of("1|2"),
     "polynomial order of the elements: 2 puts a node on every edge, on curves of the outline; a mesh file of second "
     "order keeps its order; by default 1, but 2 at a contact with friction and wear that is driven by forces alone"},
    {"body.*.mesh.element", Type::text, "", "quad", one_of("quad|tri"), "kind of the elements"},
    {"body.*.mesh.far_size_mm", Type::number, "mm", "", positive,
     "element size away from contacts; by default a twentieth of the body's diagonal"},
    mesh_growth,

    {"boundary.*.body", Type::text, "", "required", any,
     "body whose edges are named; without a selector the physical curve of this name, or else the whole outline"},
    {"boundary.*.box_mm", Type::box, "mm", "", any, "edges wholly inside [x_min, y_min, x_max, y_max]"},
    {"boundary.*.type", Type::text, "", "", one_of("line|circle|spline"), "edges of this kind"},
    {"boundary.*.nearest_mm", Type::pair, "mm", "", any, "the one edge nearest to this point"},
    {"boundary.*.profile", Type::text, "", "", any,
     "start profile, a CSV file headed `arc_length_mm,height_mm`: outward height over the arc length from the end with "
     "smaller x (then smaller y), zero outside of its range; the path counts from the scene file"},

    {"contact.*.secondary", Type::text, "", "required", any,
     "boundary that carries the contact tractions, on a deformable body, best the finer side; several contacts may "
     "share it, each with its own primary boundaries"},
    {"contact.*.primary", Type::texts, "", "required", any, "boundaries that the secondary side may touch"},
    {"contact.*.friction", Type::formula, "", "0.0", at_least(0.0),
     "Coulomb coefficient; or a formula of pressure_MPa, speed_mm_per_s (steps then need period_s), path_mm, depth_mm "
     "(of the secondary side) and cycle, such as \"0.3 + 0.2*exp(-path_mm/500)\"; or, over the cycles:"},
    {"contact.*.friction.cycles", Type::numbers, "", "required", at_least(0.0),
     "cycles, increasing; a block uses the coefficient at its first cycle"},
    {"contact.*.friction.value", Type::numbers, "", "required", at_least(0.0),
     "coefficient at each of these cycles, linear between, constant before and after"},
    {"contact.*.dual", Type::text, "", "", one_of("linear|quadratic"),
     "basis of the multipliers where the secondary body is of order 2 (linear for order 1); by default quadratic, but "
     "linear with friction and wear that are driven by forces alone"},
    implicit,
    {"contact.*.imposed_sliding_mm", Type::number, "mm", "", any,
     "imposed slip, distributed evenly over each play of a step; or a table of the keys below, or a list of such "
     "tables, which add "
     "up; without it slip follows from the motion"},
    {"contact.*.imposed_out_of_plane_mm", Type::number, "mm", "", any,
     "imposed slip out of the plane: friction mu p works and wears there and leaves no shear in the plane"},
    {"contact.*.imposed_turn_rad", Type::number, "rad", "", any,
     "imposed turn about the axis, axisymmetric problems: slip = angle x r"},
    {"contact.*.{imposed_sliding_mm,imposed_out_of_plane_mm}[?].value", Type::number, "mm", "required", any,
     "slip at factor 1"},
    {"contact.*.imposed_turn_rad[?].value", Type::number, "rad", "required", any, "angle at factor 1"},
    {"contact.*.{imposed_sliding_mm,imposed_out_of_plane_mm,imposed_turn_rad}[?].history", Type::text, "", "", any,
     "slip follows the factor of this history while a step plays it, back and forth; without it slip is even"},
    search,
    {"contact.*.c_normal", Type::number, "", "1.0", positive,
     "factor of the normal complementarity function in the first iterations"},
    {"contact.*.c_tangential", Type::number, "", "1.0", positive,
     "factor of the tangential complementarity function in the first iterations"},
    wear_law,
    wear_energy,
    wear_archard,
    wear_rate,
    wear_pressure_exponent,
    wear_pressure_ref,
    wear_speed_exponent,
    wear_speed_ref,
    wear_threshold,
    {"bond.*.secondary", Type::text, "", "required", any,
     "boundary that is joined permanently, without opening or slip; the finer one, on a deformable body"},
    {"bond.*.primary", Type::texts, "", "required", any, "boundaries on which the secondary side lies"},
    {"{contact,bond}.*.fine_zone[?].centre_mm", Type::pair, "mm", "required", any,
     "middle of the fine mesh; a contact that touches in several places takes a list of such tables"},
    {"{contact,bond}.*.fine_zone[?].half_width_mm", Type::number, "mm", "required", positive,
     "half extent along the contact"},
    {"{contact,bond}.*.fine_zone[?].depth_mm", Type::number, "mm", "required", positive, "extent into both bodies"},
    {"{contact,bond}.*.fine_zone[?].size_mm", Type::number, "mm", "", positive,
     "element size inside; may be left out only with `accuracy`"},
    {"{contact,bond}.*.fine_zone[?].angle_deg", Type::number, "degree", "0.0", any, "direction of the width, from x"},

    {"face", Type::refused, "", "", any,
     "faces are of solids, analysis = \"solid\"; a plane scene names edges, in [boundary]"},
    {"symmetry", Type::refused, "", "", any,
     "is a list of faces of solids, analysis = \"solid\"; in a plane scene a support with normal = \"fixed\" is "
     "symmetry"},
    {"{support,load}.*.face", Type::refused, "", "", any,
     "faces are of solids, analysis = \"solid\"; a plane scene takes edge"},

    {"support.*.edge", Type::text, "", "", any, "boundary that is held or moved; or `point_mm`"},
    {"support.*.point_mm", Type::pair, "mm", "", any,
     "a point of the body, at most a quarter of an element beside it: a node of each of its meshes"},
    {"support.*.body", Type::text, "", "", any, "body of the point; by default the body whose node is nearest"},
    {"support.*.angle_deg", Type::number, "degree", "0.0", any, "x and y of the support turned by this angle"},
    {"support.*.rigid", Type::flag, "", "", any,
     "the edge moves as a rigid line; by default true when a rotation is named or a motion is loaded"},
    {"support.*.{x,y,tangent,normal}", Type::text, "", "free", one_of("fixed|free"),
     "motion along x, y, or tangential and normal to the edge; a table of the keys below, or a list of such tables, "
     "which add up"},
    {"support.*.{x,y,tangent,normal}[?].motion_mm", Type::number, "mm", "", any, "imposed motion"},
    {"support.*.{x,y,tangent,normal}[?].force_N_per_mm", Type::number, "N/mm", "", any,
     "force on the whole edge, plane problems"},
    {"support.*.{x,y,tangent,normal}[?].force_N", Type::number, "N", "", any,
     "force on the whole ring, axisymmetric problems"},
    {"support.*.{x,y,tangent,normal}[?].spring_N_per_mm2", Type::number, "N/mm/mm", "", positive,
     "spring between the whole edge and the ground, force per mm of displacement, plane problems; motion_mm, if given, "
     "moves its far end, and a force acts in parallel"},
    {"support.*.{x,y,tangent,normal}[?].spring_N_per_mm", Type::number, "N/mm", "", positive,
     "spring of the whole ring, axisymmetric problems"},
    {"support.*.{x,y,tangent,normal}[?].history", Type::text, "", "", any,
     "history of its factor over a step; without one the full value acts from the start"},
    {"support.*.rotation", Type::text, "", "free", one_of("fixed|free"),
     "rotation of a rigid edge; a table of the keys below, or a list of such tables, which add up"},
    {"support.*.rotation[?].motion_rad", Type::number, "rad", "", any, "imposed rotation"},
    {"support.*.rotation[?].moment_N_mm_per_mm", Type::number, "N mm/mm", "", any, "moment about the edge's middle"},
    {"support.*.rotation[?].spring_N_mm_per_mm", Type::number, "N mm/mm/rad", "", positive,
     "spring against the rotation, moment per rad"},
    {"support.*.rotation[?].history", Type::text, "", "", any, "its factor over a step"},

    {"load.*.edge", Type::text, "", "", any, "boundary under pressure or traction; or `point_mm` or `body`"},
    pressure,
    {"load.*.traction_MPa", Type::pair, "MPa", "", any, "traction in x and y, added to the pressure"},
    {"load.*.interval_mm", Type::pair, "mm", "", at_least(0.0),
     "loaded range of arc length, from the end with smaller x (then smaller y)"},
    {"load.*.point_mm", Type::pair, "mm", "", any,
     "a point of the body, at most a quarter of an element beside it: a node of each of its meshes; or"},
    {"load.*.force_N_per_mm", Type::pair, "N/mm", "", any, "force at the point, plane problems"},
    {"load.*.force_N", Type::pair, "N", "", any, "force on the whole ring, axisymmetric problems"},
    {"load.*.body", Type::text, "", "", any, "body of the point, or body under a body force"},
    {"load.*.force_N_per_mm3", Type::pair, "N/mm^3", "", any, "force per volume on the body"},
    load_history,
    part_pressure,
    {"load.*.parts[].{traction_MPa,force_N_per_mm,force_N,force_N_per_mm3}", Type::pair, "", "", any, "as above"},
    part_history,

    history,
    history_file,
    history_column,
    history_tolerance,
    history_close,

    step_name,
    step_play,
    step_increments,
    step_wear,
    step_cycles,
    step_jump,
    step_jump_tolerance,
    step_jump_first,
    step_jump_most,
    step_period,

    spectrum_steps,
    spectrum_levels,
    spectrum_times,

    limit_contact,
    limit_side,
    limit_depth,
    {"limit.*.area_mm2", Type::number, "mm^2", "", positive, "worn area, plane problems; or"},
    {"limit.*.volume_mm3", Type::number, "mm^3", "", positive, "worn volume, axisymmetric problems"},
    limit_stop,
    limit_wear_factor,

    frames_per_step,
    frames_every_cycles,
    frames_every_blocks,
    frames_per_decade,
    frames_at_remeshes,
    frames_every_increment,
    frames_last_block,
    frames_paraview,
    history_every_blocks,
    checkpoint,
    estimate_error,
    probe_body,
    {"output.probes.*.at_mm", Type::pair, "mm", "required", any,
     "point whose displacement is reported; on the body, or at most a quarter of an element beside it"},

    remesh_automatic,
    remesh_every_blocks,
    {"remesh.min_scaled_jacobian", Type::number, "", "0.3", {.low = 0.0, .high = 0.8, .low_open = true},
     "smallest sine of an element's corner angle"},
    {"remesh.min_angle_deg", Type::number, "degree", "15", {.low = 0.0, .high = 50.0}, "smallest corner angle"},
    {"remesh.size_ratio", Type::number, "", "2.5", {.low = 1.0, .low_open = true},
     "ratio of the length of an outline facet to its first length, or the inverse"},
    remesh_wear_fraction,
    {"remesh.max_dofs", Type::number, "", "4e6", {.low = 100.0},
     "largest size of a new mesh; the run ends if it would need more"},
    {"remesh.fit_tolerance_mm", Type::number, "mm", "", positive,
     "a spline farther than this from the polygon of the worn nodes is replaced by the polygon; by default chosen from "
     "the elements"},

    {"remesh.state_transfer", Type::text, "", "l2", one_of("nearest|patch|l2"),
     "transfer of plastic state to a fresh mesh: from the nearest Gauss point, by patch recovery, or by L2 projection, "
     "which keeps its integral"},

    max_newton,
    max_cutbacks,
};
// clang-format on

}  // namespace plane_rows

bool Range::holds(double value) const {
  return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);
}

std::span<const Key> keys() { return plane_rows::table; }

}  // namespace reye::scene
