#include "scene/keys.hpp"

namespace reye::scene {

namespace {

constexpr Range any{};
constexpr Range positive{.low = 0.0, .low_open = true};
constexpr Range at_least(double low) { return {.low = low}; }
constexpr Range from_to(double low, double high) { return {.low = low, .high = high}; }
constexpr Range one_of(std::string_view choices) { return {.choices = choices}; }

// One key a paragraph.
// clang-format off
constexpr Key table[] = {
    {"title", Type::text, "", "", any, "headline of the results; without it the scene's name"},
    {"analysis", Type::text, "", "plane_strain", one_of("plane_strain|plane_stress|axisymmetric"),
     "idealisation; axisymmetric: r = x >= 0, axis y; of a section drawn on both sides of the axis the half x >= 0 is taken"},
    {"accuracy", Type::number, "", "", {.low = 0.0, .high = 0.2, .low_open = true},
     "relative error asked for, of worn profiles, or of tractions where nothing wears: a pilot run chooses the size of fine "
     "zones without `size_mm`; steps that wear without `jump` take half of it as tolerance"},
    {"geometry", Type::texts, "", "required", any,
     "geometry files in mm (.step .stp .iges .igs .brep .geo .msh .vtu); paths count from the scene file"},
    {"section.point_mm", Type::triple, "mm", "required", any,
     "a point of the plane that cuts every solid of the geometry files into faces"},
    {"section.normal", Type::triple, "", "required", any, "normal of that plane; length and sign do not matter"},
    {"shape", Type::text, "", "on", one_of("on|off"), "off: wear stays in the gap, the surfaces do not move"},

    {"material.*.law", Type::text, "", "linear_elastic",
     one_of("linear_elastic|st_venant_kirchhoff|neo_hookean|hencky|hencky_cauchy|hencky_j2"),
     "stress law; `linear_elastic` is for small strain only, where the other elastic laws reduce to it; "
     "hencky: Kirchhoff stress linear in log strain, hencky_cauchy: Cauchy stress"},
    {"material.*.E_MPa", Type::number, "MPa", "required", positive, "Young's modulus"},
    {"material.*.nu", Type::number, "", "required",
     {.low = -1.0, .high = 0.5, .low_open = true, .high_open = true}, "Poisson's ratio"},
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
     "label in the geometry (STEP product, physical surface); with neither `at` nor `name` the body's own name"},
    {"body.*.material", Type::text, "", "", any, "one of the materials; a rigid body takes none"},
    {"body.*.rigid", Type::flag, "", "false", any, "the body does not deform"},
    {"body.*.b_bar", Type::flag, "", "", any,
     "remedy for volumetric locking, B-bar or (finite) F-bar; without it on for quads of order 1 in plane strain and axisymmetry"},
    {"body.*.kinematics", Type::text, "", "small", one_of("small|finite|auto"),
     "strain measure; of the secondary body also that of its contact: per length on X (small) or on x (finite); auto: small "
     "where a trial estimates its error at 1 % or less, else finite, as `plan` reports; linear_elastic is then hencky. At small "
     "strain linear_elastic bodies that can turn do so by any angle; strain above 1 % is a warning, and above 5 % ends a run "
     "whose scene leaves this key out"},
    {"body.*.order", Type::whole, "", "", one_of("1|2"),
     "polynomial order of the elements: 2 puts a node on every edge, on curves of the outline; a mesh file of second order stays one; "
     "without it 1, but 2 at a contact with friction and wear that only forces drive"},
    {"body.*.mesh.element", Type::text, "", "quad", one_of("quad|tri"), "kind of the elements"},
    {"body.*.mesh.far_size_mm", Type::number, "mm", "", positive,
     "element size away from contacts; without it a twentieth of the body's diagonal"},
    {"body.*.mesh.growth", Type::number, "", "1.3", {.low = 1.0, .high = 3.0, .low_open = true},
     "ratio of neighbouring element sizes away from fine zones"},

    {"boundary.*.body", Type::text, "", "required", any,
     "its edges are named; without a selector the physical curve of this name, or else the whole outline"},
    {"boundary.*.box_mm", Type::box, "mm", "", any, "edges wholly inside [x_min, y_min, x_max, y_max]"},
    {"boundary.*.type", Type::text, "", "", one_of("line|circle|spline"), "edges of this kind"},
    {"boundary.*.nearest_mm", Type::pair, "mm", "", any, "the one edge nearest to this point"},
    {"boundary.*.profile", Type::text, "", "", any,
     "start profile, a CSV file headed `arc_length_mm,height_mm`: height out of the body over the arc length from the "
     "end with smaller x (then smaller y), zero outside of its range; the path counts from the scene file"},

    {"contact.*.secondary", Type::text, "", "required", any,
     "boundary that carries the multipliers; of a deformable body; several contacts may share it, each with its own primary ones"},
    {"contact.*.primary", Type::texts, "", "required", any, "boundaries it may touch"},
    {"contact.*.friction", Type::number, "", "0.0", at_least(0.0), "Coulomb coefficient; or over the cycles"},
    {"contact.*.friction.cycles", Type::numbers, "", "required", at_least(0.0),
     "cycles, increasing; a block takes the coefficient at the cycle it begins with"},
    {"contact.*.friction.value", Type::numbers, "", "required", at_least(0.0),
     "coefficient at each of them, straight lines between, constant before and after"},
    {"contact.*.dual", Type::text, "", "", one_of("linear|quadratic"),
     "basis of the multipliers where the secondary body is of order 2; on order 1 it is linear; without it quadratic, but "
     "linear with friction and wear that only forces drive"},
    {"contact.*.implicit", Type::flag, "", "true", any, "wear is implicit: it enters the contact equations of its own increment"},
    {"contact.*.imposed_sliding_mm", Type::number, "mm", "", any,
     "imposed slip, distributed evenly over each play of a step; or a table of the keys below, or a list of such tables, which add "
     "up; without it slip comes from the motion"},
    {"contact.*.imposed_out_of_plane_mm", Type::number, "mm", "", any,
     "imposed slip out of the plane: friction mu p works and wears there and leaves no shear in the plane"},
    {"contact.*.imposed_turn_rad", Type::number, "rad", "", any,
     "imposed turn about the axis, axisymmetric problems: slip = angle x r"},
    {"contact.*.{imposed_sliding_mm,imposed_out_of_plane_mm}[?].value", Type::number, "mm", "required", any, "slip at factor 1"},
    {"contact.*.imposed_turn_rad[?].value", Type::number, "rad", "required", any, "angle at factor 1"},
    {"contact.*.{imposed_sliding_mm,imposed_out_of_plane_mm,imposed_turn_rad}[?].history", Type::text, "", "", any,
     "slip goes as its factor does while a step plays it, forth and back; without it evenly"},
    {"contact.*.search_mm", Type::number, "mm", "", positive,
     "facets farther apart are not paired; without it chosen from the bodies"},
    {"contact.*.c_normal", Type::number, "", "1.0", positive, "factor of the normal complementarity function in the first iterations"},
    {"contact.*.c_tangential", Type::number, "", "1.0", positive,
     "factor of the tangential complementarity function in the first iterations"},
    {"contact.*.wear.law", Type::text, "", "required", one_of("energy|archard"),
     "removed volume = coefficient x frictional work, or x pressure x slip"},
    {"contact.*.wear.{secondary,primary}_mm3_per_J", Type::number, "mm^3/J", "0.0", at_least(0.0),
     "coefficient of each side, energy law"},
    {"contact.*.wear.{secondary,primary}_per_MPa", Type::number, "1/MPa", "0.0", at_least(0.0),
     "coefficient of each side, Archard's law"},
    {"contact.*.wear.pressure_exponent", Type::number, "", "0.0", {.low = -1.0, .low_open = true},
     "m: the removed volume times (pressure / pressure_ref_MPa)^m"},
    {"contact.*.wear.pressure_ref_MPa", Type::number, "MPa", "", positive, "pressure that the coefficients belong to"},
    {"contact.*.wear.speed_exponent", Type::number, "", "0.0", {.low = -1.0, .low_open = true},
     "n: the removed volume times (speed of slip / speed_ref_mm_per_s)^n; steps that wear need period_s"},
    {"contact.*.wear.speed_ref_mm_per_s", Type::number, "mm/s", "", positive, "speed that the coefficients belong to"},
    {"contact.*.wear.threshold_mJ_per_mm2", Type::number, "mJ/mm^2", "0.0", at_least(0.0),
     "energy law: frictional work per area that a place must have seen since the start before it wears"},
    {"bond.*.secondary", Type::text, "", "required", any,
     "boundary that is joined for good, without opening or slip; the finer one, of a deformable body"},
    {"bond.*.primary", Type::texts, "", "required", any, "boundaries it lies on"},
    {"{contact,bond}.*.fine_zone[?].centre_mm", Type::pair, "mm", "required", any,
     "middle of the fine mesh; a contact that touches in several places takes a list of such tables"},
    {"{contact,bond}.*.fine_zone[?].half_width_mm", Type::number, "mm", "required", positive,
     "half extent along the contact"},
    {"{contact,bond}.*.fine_zone[?].depth_mm", Type::number, "mm", "required", positive, "extent into both bodies"},
    {"{contact,bond}.*.fine_zone[?].size_mm", Type::number, "mm", "", positive,
     "element size inside; only with `accuracy` may it be left out"},
    {"{contact,bond}.*.fine_zone[?].angle_deg", Type::number, "degree", "0.0", any, "direction of the width, from x"},

    {"support.*.edge", Type::text, "", "", any, "boundary that is held or moved; or"},
    {"support.*.point_mm", Type::pair, "mm", "", any, "a point of the body, at most a quarter of an element beside it: a node of each of its meshes"},
    {"support.*.body", Type::text, "", "", any, "body of the point; without it the body whose node is nearest"},
    {"support.*.angle_deg", Type::number, "degree", "0.0", any, "x and y of the support turned by this angle"},
    {"support.*.rigid", Type::flag, "", "", any,
     "the edge moves as a rigid line; without it true when a rotation is named or a motion is loaded"},
    {"support.*.{x,y,tangent,normal}", Type::text, "", "free", one_of("fixed|free"),
     "motion along x, y, or along the edge and out of it; a table of the keys below, or a list of such tables, which add up"},
    {"support.*.{x,y,tangent,normal}[?].motion_mm", Type::number, "mm", "", any, "imposed motion"},
    {"support.*.{x,y,tangent,normal}[?].force_N_per_mm", Type::number, "N/mm", "", any,
     "force on the whole edge, plane problems"},
    {"support.*.{x,y,tangent,normal}[?].force_N", Type::number, "N", "", any,
     "force on the whole ring, axisymmetric problems"},
    {"support.*.{x,y,tangent,normal}[?].spring_N_per_mm2", Type::number, "N/mm/mm", "", positive,
     "spring between the whole edge and the ground, force per mm of its way, plane problems; may stand alone; motion_mm is then that "
     "of its far end, and a force acts beside it"},
    {"support.*.{x,y,tangent,normal}[?].spring_N_per_mm", Type::number, "N/mm", "", positive, "the same of the whole ring, axisymmetric problems"},
    {"support.*.{x,y,tangent,normal}[?].history", Type::text, "", "", any,
     "its factor over a step; without it full from the start"},
    {"support.*.rotation", Type::text, "", "free", one_of("fixed|free"),
     "rotation of a rigid edge; a table of the keys below, or a list of such tables, which add up"},
    {"support.*.rotation[?].motion_rad", Type::number, "rad", "", any, "imposed rotation"},
    {"support.*.rotation[?].moment_N_mm_per_mm", Type::number, "N mm/mm", "", any, "moment about the edge's middle"},
    {"support.*.rotation[?].spring_N_mm_per_mm", Type::number, "N mm/mm/rad", "", positive, "the same for the rotation, moment per rad"},
    {"support.*.rotation[?].history", Type::text, "", "", any, "its factor over a step"},

    {"load.*.edge", Type::text, "", "", any, "boundary under pressure or traction; or"},
    {"load.*.pressure_MPa", Type::number, "MPa", "", any, "pressure, > 0 pushes on the body"},
    {"load.*.traction_MPa", Type::pair, "MPa", "", any, "traction in x and y, added to the pressure"},
    {"load.*.interval_mm", Type::pair, "mm", "", at_least(0.0),
     "only on this arc length, from the end with smaller x (then smaller y)"},
    {"load.*.point_mm", Type::pair, "mm", "", any, "a point of the body, at most a quarter of an element beside it: a node of each of its meshes; or"},
    {"load.*.force_N_per_mm", Type::pair, "N/mm", "", any, "force at the point, plane problems"},
    {"load.*.force_N", Type::pair, "N", "", any, "force on the whole ring, axisymmetric problems"},
    {"load.*.body", Type::text, "", "", any, "body of the point, or body under a body force"},
    {"load.*.force_N_per_mm3", Type::pair, "N/mm^3", "", any, "force per volume on the body"},
    {"load.*.history", Type::text, "", "", any, "its factor over a step; without it full from the start"},
    {"load.*.parts[].pressure_MPa", Type::number, "MPa", "", any, "a load as a list of parts, which add up: each with its own value"},
    {"load.*.parts[].{traction_MPa,force_N_per_mm,force_N,force_N_per_mm3}", Type::pair, "", "", any, "as above"},
    {"load.*.parts[].history", Type::text, "", "", any, "and its own history"},

    {"history.*", Type::history, "", "", any, "[progress of the step, factor], progress from 0 to 1"},

    {"step[].name", Type::text, "", "", any, "name in messages; without it its number"},
    {"step[].play", Type::texts, "", "[]", any, "histories played; the others hold their last factor"},
    {"step[].increments", Type::whole, "", "1", from_to(1.0, 1e5), "equal parts of the step; corners are always ends"},
    {"step[].wear", Type::flag, "", "true", any, "false: nothing wears in this step"},
    {"step[].cycles", Type::number, "", "0", at_least(0.0), "how often it is repeated; 0: a load step, no cycle"},
    {"step[].jump", Type::number, "", "1", at_least(1.0), "cycles per block, the same for all; with `accuracy` a tolerance is the default; or"},
    {"step[].jump.tolerance", Type::number, "", "required", {.low = 1e-5, .high = 0.2},
     "error of depth profile and worn volume that the run chooses its blocks by"},
    {"step[].jump.first", Type::number, "", "", at_least(1.0), "cycles of the first block; without it a thousandth of the step"},
    {"step[].jump.most", Type::number, "", "", at_least(1.0), "cycles that no block exceeds"},
    {"step[].period_s", Type::number, "s", "", positive,
     "how long one play of the step lasts; only a speed exponent asks for it"},

    {"spectrum.steps", Type::texts, "", "required", any, "steps that follow one another, played over and over in this order"},
    {"spectrum.times", Type::whole, "", "required", from_to(1.0, 1e5), "how often"},

    {"limit.*.contact", Type::text, "", "required", any, "contact that is watched"},
    {"limit.*.side", Type::text, "", "secondary", one_of("secondary|primary|sum"), "side that is watched"},
    {"limit.*.depth_mm", Type::number, "mm", "", positive, "largest wear depth; or"},
    {"limit.*.area_mm2", Type::number, "mm^2", "", positive, "worn area, plane problems; or"},
    {"limit.*.volume_mm3", Type::number, "mm^3", "", positive, "worn volume, axisymmetric problems"},
    {"limit.*.stop", Type::flag, "", "false", any, "true: the run ends there"},
    {"limit.*.wear_factor", Type::pair, "", "", positive,
     "[lowest, highest] factor on all wear coefficients, their scatter: the limit's life is reported as a band, life / factor"},

    {"output.frames.every_cycles", Type::number, "", "0", at_least(0.0),
     "cycles between frames; without this and the next ones: first and last state of each step only"},
    {"output.frames.every_blocks", Type::whole, "", "0", at_least(0.0), "a frame after each so many blocks of a step"},
    {"output.frames.per_decade", Type::whole, "", "0", at_least(0.0),
     "so many frames while the cycles grow to ten times as many, at most one per block"},
    {"output.frames.at_remeshes", Type::flag, "", "false", any, "a frame at the end of each block with a body remeshed"},
    {"output.frames.every_increment", Type::flag, "", "false", any, "a frame at each increment"},
    {"output.frames.last_block", Type::flag, "", "false", any, "a frame at each increment of the last block of a step"},
    {"output.frames.paraview", Type::flag, "", "true", any,
     "false: rows of the surface tables alone, no .vtu and .vtp; nothing inside the bodies is solved back"},
    {"output.history.every_blocks", Type::whole, "", "1", at_least(1.0),
     "rows of history.csv of each so many blocks of a step, and of its first and last"},
    {"output.checkpoint_s", Type::number, "s", "1", at_least(0.0),
     "least wall time between two checkpoints; 0: one at each block end. However the run ends, its last block end is kept"},
    {"output.estimate_error", Type::flag, "", "", any,
     "without it true with `accuracy`, else false; true: the run is repeated on elements twice as large, which gives the error of the mesh and takes some 0.4 of a long run's time"},
    {"output.probes.*.body", Type::text, "", "required", any, "body of the probe"},
    {"output.probes.*.at_mm", Type::pair, "mm", "required", any, "its displacement is reported; on the body, or at most a quarter of an element beside it"},

    {"remesh.automatic", Type::flag, "", "true", any,
     "a worn body is remeshed when one of the bounds below is passed; false: the run ends there"},
    {"remesh.every_blocks", Type::whole, "", "0", at_least(0.0),
     "bodies in contact are remeshed after each so many blocks, needed or not; 0: only when needed"},
    {"remesh.min_scaled_jacobian", Type::number, "", "0.3", {.low = 0.0, .high = 0.8, .low_open = true},
     "smallest sine of an element's corner angle"},
    {"remesh.min_angle_deg", Type::number, "degree", "15", {.low = 0.0, .high = 50.0}, "smallest corner angle"},
    {"remesh.size_ratio", Type::number, "", "2.5", {.low = 1.0, .low_open = true},
     "length of an outline facet against that at its birth, either way"},
    {"remesh.wear_fraction", Type::number, "", "0.5", {.low = 0.0, .high = 2.0, .low_open = true},
     "depth worn since the mesh was made over the height of the element below"},
    {"remesh.max_dofs", Type::number, "", "4e6", {.low = 100.0}, "a new mesh that would need more ends the run"},
    {"remesh.fit_tolerance_mm", Type::number, "mm", "", positive,
     "a spline farther than this from the worn nodes' polygon is replaced by the polygon; without it chosen from the elements"},

    {"remesh.state_transfer", Type::text, "", "l2", one_of("nearest|patch|l2"),
     "how plastic state goes to a fresh mesh: of the nearest Gauss point, by patch recovery, or by L2 projection, which keeps "
     "its integral"},

    {"solver.max_newton", Type::whole, "", "30", at_least(1.0), "Newton iterations before an increment is cut"},
    {"solver.max_cutbacks", Type::whole, "", "8", at_least(0.0), "halvings of an increment before the run fails"},
};
// clang-format on

}  // namespace

bool Range::holds(double value) const {
  return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);
}

std::span<const Key> keys() { return table; }

}  // namespace reye::scene
