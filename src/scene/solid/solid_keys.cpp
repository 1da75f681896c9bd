#include "scene/solid/solid_keys.hpp"

#include "scene/read.hpp"
#include "scene/shared_keys.hpp"

namespace reye::scene {

/// The rows of scenes of solids, in the order of the reference.
namespace solid_rows {

using namespace rows;

constexpr std::string_view takes_quality = "is of plane scenes; solids take min_quality and min_facet_shape";
constexpr std::string_view takes_face = "is of plane scenes; solids take face";
constexpr std::string_view takes_force = "is of plane scenes; solids take force_N";
constexpr std::string_view takes_spring = "is of plane scenes; solids take spring_N_per_mm";
constexpr std::string_view takes_zone = "is of plane scenes; a zone of solids takes radius_mm or half_widths_mm";
constexpr Range linear_only{.choices = "linear_elastic", .why = "solids are linear so far"};

constexpr Key refused(std::string_view pattern, std::string_view rule) {
  return {pattern, Type::refused, "", "", any, rule};
}

// One key a paragraph.
// clang-format off
constexpr Key table[] = {
    title,
    {"analysis", Type::text, "", "required", one_of("solid"), "three dimensions, x y z"},
    geometry,
    {"symmetry", Type::texts, "", "", any,
     "faces without motion along their normal, planes of symmetry of what is drawn; results are those of the drawn "
     "part"},
    accuracy,
    refused("section", "cuts solids into faces of a plane scene; a scene of solids takes them whole"),
    shape,

    {"material.*.law", Type::text, "", "linear_elastic", linear_only,
     "stress law; solids are linear so far, at small strain"},
    modulus,
    poisson,
    refused("material.*.volumetric", "solids are linear so far: it belongs to neo_hookean"),
    refused("material.*.hardening", "solids are linear so far: they do not flow"),

    {"body.*.at", Type::triple, "mm", "", any, "a point inside the body"},
    {"body.*.name", Type::text, "", "", any,
     "label in the geometry (STEP product, physical volume); with neither `at` nor `name` the name of the body in the "
     "scene, or the only solid of all files"},
    body_material,
    body_rigid,
    {"body.*.order", Type::whole, "", "2", one_of("1|2"),
     "polynomial order of the tetrahedra; those of first order are stiff and poor in stress. A mesh file keeps its "
     "elements"},
    {"body.*.mesh.far_size_mm", Type::number, "mm", "", positive,
     "element size away from contacts; by default a fifteenth of the body's diagonal"},
    mesh_growth,
    refused("body.*.mesh.element",
            "is of plane scenes; solids are meshed by tetrahedra, and mesh files bring their elements"),
    refused("body.*.b_bar", "is of plane scenes; tetrahedra of order = 2 do not lock"),
    refused("body.*.kinematics", "solids are of small strain so far"),

    {"face.*.body", Type::text, "", "required", any,
     "body whose faces are named; without a selector the physical surface of this name, or else the whole skin"},
    {"face.*.box_mm", Type::solid_box, "mm", "", any,
     "faces wholly inside [x_min, y_min, z_min, x_max, y_max, z_max]"},
    {"face.*.type", Type::text, "", "", one_of("plane|cylinder|sphere|cone|torus|spline"), "faces of this kind"},
    {"face.*.nearest_mm", Type::triple, "mm", "", any, "the one face nearest to this point"},
    refused("face.*.profile", "start profiles are of plane scenes so far"),
    refused("boundary", "names edges of plane scenes; solids name faces, in [face]"),

    {"contact.*.secondary", Type::text, "", "required", any,
     "face that carries the contact tractions, on a deformable body, best the finer side; it is the secondary side of "
     "one contact"},
    {"contact.*.primary", Type::texts, "", "required", any, "faces that the secondary side may touch"},
    {"contact.*.friction", Type::number, "", "0.0", at_least(0.0), "Coulomb coefficient"},
    refused("contact.*.friction.cycles", "the friction of solids is a number so far"),
    refused("contact.*.friction.value", "the friction of solids is a number so far"),
    {"contact.*.dual", Type::text, "", "quadratic", one_of("linear|quadratic"),
     "basis of the multipliers where the secondary body is of order 2 (linear for order 1)"},
    search,
    {"contact.*.imposed_sliding_mm[?].direction", Type::triple, "", "required", any,
     "direction in which the secondary side slides against the primary, without its part along the normal; a table of "
     "these keys, or a list of such tables, which add up to the slip of the motion"},
    {"contact.*.imposed_sliding_mm[?].value", Type::number, "mm", "required", any, "slip at factor 1"},
    {"contact.*.imposed_turn_rad[?].point_mm", Type::triple, "mm", "required", any,
     "a point of the axis about which the secondary side turns against the primary: slip = angle x distance; a table "
     "of these keys, or a list of such tables"},
    {"contact.*.imposed_turn_rad[?].axis", Type::triple, "", "required", any, "direction of the axis, right-handed"},
    {"contact.*.imposed_turn_rad[?].value", Type::number, "rad", "required", any, "angle at factor 1"},
    {"contact.*.{imposed_sliding_mm,imposed_turn_rad}[?].history", Type::text, "", "", any,
     "slip follows the factor of this history while a step plays it, back and forth; without it slip is even"},
    {"contact.*.fine_zone[?].centre_mm", Type::triple, "mm", "required", any,
     "middle of the fine mesh, a ball or a box; a contact that touches in several places takes a list of such tables"},
    {"contact.*.fine_zone[?].radius_mm", Type::number, "mm", "", positive, "radius of the ball; or"},
    {"contact.*.fine_zone[?].half_widths_mm", Type::triple, "mm", "", positive,
     "half extents of the box along x, y and z"},
    {"contact.*.fine_zone[?].size_mm", Type::number, "mm", "", positive,
     "element size inside; may be left out only with `accuracy`"},
    refused("contact.*.fine_zone[?].half_width_mm", takes_zone),
    refused("contact.*.fine_zone[?].depth_mm", takes_zone),
    refused("contact.*.fine_zone[?].angle_deg", takes_zone),
    refused("contact.*.imposed_out_of_plane_mm", "is of plane scenes; solids slide in space: imposed_sliding_mm"),
    implicit,
    wear_law,
    wear_energy,
    wear_archard,
    wear_rate,
    wear_pressure_exponent,
    wear_pressure_ref,
    wear_speed_exponent,
    wear_speed_ref,
    wear_threshold,
    refused("contact.*.{c_normal,c_tangential}",
            "solids choose the factors of their complementarity functions themselves"),
    refused("bond", "bonds of solids are not built yet"),

    {"support.*.face", Type::text, "", "", any, "face that is held or moved; of a rigid body any of its faces; or"},
    {"support.*.body", Type::text, "", "", any, "rigid body that is held or moved"},
    {"support.*.axis_z", Type::triple, "", "", any,
     "direction of the support's z, at right angles to axis_x. Of the two one may be left out: axis_x is then as near "
     "to x as right angles permit, axis_z to z; or to y where the other axis lies within 10 degrees of that"},
    {"support.*.axis_x", Type::triple, "", "", any, "direction of the support's x; y follows right-handed"},
    {"support.*.rigid", Type::flag, "", "", any,
     "the face moves as a rigid one; by default true when a rotation is named or a motion is loaded, and of rigid "
     "bodies"},
    {"support.*.centre_mm", Type::triple, "mm", "", any,
     "point of a rigid face about which rotations turn and moments act; it moves along with the body. By default the "
     "centroid of the face's area"},
    {"support.*.{x,y,z}", Type::text, "", "free", one_of("fixed|free"),
     "motion along an axis; a table of the keys below, or a list of such tables, which add up"},
    {"support.*.{x,y,z}[?].motion_mm", Type::number, "mm", "", any, "imposed motion"},
    {"support.*.{x,y,z}[?].force_N", Type::number, "N", "", any, "force on the whole face, which is then rigid"},
    {"support.*.{x,y,z}[?].spring_N_per_mm", Type::number, "N/mm", "", positive,
     "spring between the whole face, which is then rigid, and the ground; motion_mm, if given, moves its far end, and "
     "a force acts in parallel"},
    {"support.*.{x,y,z}[?].history", Type::text, "", "", any,
     "history of its factor over a step; without one the full value acts from the start"},
    {"support.*.normal", Type::text, "", "free", one_of("fixed|free"),
     "motion along the normal at each node, on a plane face symmetry; a table of motion_mm, or a list of such tables"},
    {"support.*.normal[?].motion_mm", Type::number, "mm", "", any, "imposed motion, outward"},
    {"support.*.normal[?].history", Type::text, "", "", any, "its factor over a step"},
    {"support.*.{rotation_x,rotation_y,rotation_z}", Type::text, "", "free", one_of("fixed|free"),
     "rotation of a rigid face or body, by any angle, about an axis through the centre; a table of the keys below, or a "
     "list of such tables, which add up"},
    {"support.*.{rotation_x,rotation_y,rotation_z}[?].motion_rad", Type::number, "rad", "", any,
     "imposed rotation; imposed rotations about several axes are the components of one rotation vector. At most 0.05 "
     "rad where a further support keeps the body's direction"},
    {"support.*.{rotation_x,rotation_y,rotation_z}[?].moment_N_mm", Type::number, "N mm", "", any,
     "moment about the centre; its axis keeps its direction in space"},
    {"support.*.{rotation_x,rotation_y,rotation_z}[?].spring_N_mm_per_rad", Type::number, "N mm/rad", "", positive,
     "spring against the rotation about this axis, summed over the increments"},
    {"support.*.{rotation_x,rotation_y,rotation_z}[?].history", Type::text, "", "", any, "its factor over a step"},
    refused("support.*.edge", takes_face),
    refused("support.*.point_mm", "is of plane scenes; solids are held at faces"),
    refused("support.*.angle_deg", "is of plane scenes; solids take axis_x and axis_z"),
    refused("support.*.tangent", "is of plane scenes; along a face solids take x, y, z with axis_z along its normal"),
    refused("support.*.rotation", "is of plane scenes; solids take rotation_x, rotation_y and rotation_z"),
    refused("support.*.{x,y,z}[?].force_N_per_mm", takes_force),
    refused("support.*.{x,y,z}[?].spring_N_per_mm2", takes_spring),
    refused("support.*.normal[?].force_N", "a face is pressed along its normals by a load, pressure_MPa"),
    refused("support.*.normal[?].spring_N_per_mm", "springs of solids act along x, y, z of a rigid face"),
    refused("support.*.{rotation_x,rotation_y,rotation_z}[?].moment_N_mm_per_mm",
            "is of plane scenes; solids take moment_N_mm"),
    refused("support.*.{rotation_x,rotation_y,rotation_z}[?].spring_N_mm_per_mm",
            "is of plane scenes; solids take spring_N_mm_per_rad"),

    {"load.*.face", Type::text, "", "", any, "face under load; or `body`"},
    pressure,
    {"load.*.traction_MPa", Type::triple, "MPa", "", any, "traction in x, y and z, added to the pressure; it keeps its direction in space while the body turns, as forces do, "
     "and a pressure follows the face"},
    {"load.*.force_N", Type::triple, "N", "", any, "force on the whole face, spread evenly over its area"},
    {"load.*.body", Type::text, "", "", any, "body under a body force"},
    {"load.*.force_N_per_mm3", Type::triple, "N/mm^3", "", any, "force per volume on the body"},
    load_history,
    part_pressure,
    {"load.*.parts[].{traction_MPa,force_N,force_N_per_mm3}", Type::triple, "", "", any, "as above"},
    part_history,
    refused("load.*.edge", takes_face),
    refused("load.*.point_mm", "is of plane scenes; solids are loaded on faces and in bodies"),
    refused("load.*.interval_mm", "is of plane scenes; solids load a face as a whole"),
    refused("load.*.force_N_per_mm", takes_force),
    refused("load.*.parts[].force_N_per_mm", takes_force),

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
    {"limit.*.volume_mm3", Type::number, "mm^3", "", positive, "worn volume"},
    refused("limit.*.area_mm2", "is of plane scenes; solids take volume_mm3"),
    limit_stop,
    limit_wear_factor,

    remesh_automatic,
    remesh_every_blocks,
    {"remesh.min_quality", Type::number, "", "0.15", {.low = 0.05, .high = 0.8},
     "shape of an element, 1 for a regular one, of those that have lost 0.3 of it by wear"},
    {"remesh.min_facet_shape", Type::number, "", "0.3", {.low = 0.05, .high = 0.8},
     "height of a facet of the skin over its longest edge, 1 for a regular one, of those that have lost 0.3 of it by wear"},
    {"remesh.size_ratio", Type::number, "", "2.5", {.low = 1.0, .low_open = true},
     "ratio of the mean edge of a facet to its first one, or the inverse; or of its first height to that which is left"},
    remesh_wear_fraction,
    refused("remesh.min_scaled_jacobian", takes_quality),
    refused("remesh.min_angle_deg", takes_quality),
    refused("remesh.max_dofs", "is of plane scenes; `reye plan` reports whether the dofs of a scene of solids fit"),
    refused("remesh.fit_tolerance_mm", "is of plane scenes; the worn faces of solids are those of their facets"),
    refused("remesh.state_transfer", "is of plane scenes; solids do not yield so far"),

    frames_per_step,
    frames_every_cycles,
    frames_per_decade,
    frames_every_increment,
    frames_last_block,
    frames_paraview,
    frames_every_blocks,
    frames_at_remeshes,
    history_every_blocks,
    checkpoint,
    estimate_error,
    probe_body,
    {"output.probes.*.at_mm", Type::triple, "mm", "required", any,
     "point whose displacement is reported; in the body, or at most a quarter of an element beside it"},

    max_newton,
    max_cutbacks,
};
// clang-format on

}  // namespace solid_rows

std::span<const Key> solid_keys() { return solid_rows::table; }

const Spec& solid_spec() {
  static const Spec root = tree_of(solid_keys());
  return root;
}

std::string solid_reference() { return reference(solid_keys()); }

}  // namespace reye::scene
