#include <gtest/gtest.h>

#include "bad_solid.hpp"

using namespace reye;

/// The example is accepted, so that each of the refusals here is that of its change.
TEST(BadSolid, ExampleIsGood) { EXPECT_EQ(test::solid_refusal(test::solid_example), ""); }

/// Values of the wrong kind, size or choice, and keys that nobody knows.
TEST(BadSolid, Values) {
  test::expect_solid_refused({
      {"two numbers for a point",
       {{"[1.0, 1.0, 40.0]", "[1.0, 40.0]"}},
       "scene.toml:11: body.ball.at = [1.0, 40.0]: must be a list of three numbers"},
      {"a box of the plane",
       {{"[-60.0, -60.0, 49.9, 60.0, 60.0, 50.1]", "[-60.0, 49.9, 60.0, 50.1]"}},
       "scene.toml:26: face.ball_top.box_mm = [-60.0, 49.9, 60.0, 50.1]: must be a list of six numbers, [x_min, y_min, "
       "z_min, x_max, y_max, z_max]"},
      {"box without room",
       {{"49.9, 60.0, 60.0, 50.1]", "50.0, 60.0, 60.0, 50.0]"}},
       "scene.toml:26: face.ball_top.box_mm = [-60.0, -60.0, 50.0, 60.0, 60.0, 50.0]: must be [x_min, y_min, z_min, "
       "x_max, y_max, z_max], each minimum below its maximum; a plane face needs some room on both sides"},
      {"kind of face",
       {{"\"sphere\"", "\"circle\""}},
       "scene.toml:25: face.ball_contact.type = \"circle\": must be \"plane\", \"cylinder\", \"sphere\", \"cone\", "
       "\"torus\" or \"spline\""},
      {"unknown keys",
       {{"far_size_mm", "far_size"}, {"radius_mm", "radus_mm"}, {"rotation_z", "rotation_w"}},
       "scene.toml:13: body.ball.mesh.far_size = 6.0: unknown key; did you mean far_size_mm?\n"
       "scene.toml:35: contact.pad.fine_zone[0].radus_mm = 2.0: unknown key; did you mean radius_mm?\n"
       "scene.toml:35: contact.pad.fine_zone[0]: needs one of radius_mm, half_widths_mm\n"
       "scene.toml:51: support.holder.rotation_w: unknown key; did you mean rotation_x?"},
      {"material law",
       {{"nu    = 0.3", "nu = 0.5\nlaw = \"neo_hookean\""}},
       "scene.toml:8: material.steel.nu = 0.5: must lie in (-1, 0.5)\n"
       "scene.toml:9: material.steel.law = \"neo_hookean\": must be \"linear_elastic\": solids are linear so far"},
      {"friction as formula",
       {{"= 0.3\nfine", "= \"0.1 + path_mm\"\nfine"}},
       "scene.toml:34: contact.pad.friction = \"0.1 + path_mm\": must be a number"},
      {"cycles below zero", {{"cycles = 3", "cycles = -2"}}, "scene.toml:86: step[1].cycles = -2: must be >= 0"},
      {"sliding as a number",
       {{"{ direction = [0.0, 3.0, 0.0], value = 0.4, history = \"rub\" }", "0.4"}},
       "scene.toml:37: contact.pad.imposed_sliding_mm = 0.4: must be a table of direction, value, history, or a list "
       "of such tables"},
      {"no direction",
       {{"direction = [0.0, 3.0, 0.0]", "direction = [0, 0, 0]"}, {"axis = [0.0, 0.0, 2.0], ", ""}},
       "scene.toml:37: contact.pad.imposed_sliding_mm.direction = [0, 0, 0]: must not be zero\n"
       "scene.toml:38: contact.pad.imposed_turn_rad[0].axis: missing"},
      {"not finite",
       {{"[0.0, 0.0, 50.0]", "[0.0, nan, 50.0]"}},
       "scene.toml:52: support.holder.centre_mm = [0.0, nan, 50.0]: must be finite"},
  });
}

/// Keys of plane scenes and of what is not built yet say what solids take instead.
TEST(BadSolid, KeysOfThePlane) {
  test::expect_solid_refused({
      {"edges",
       {{"[face]", "[boundary.left]\nbody = \"ball\"\n[face]"}, {"face       = \"ball_top\"", "edge = \"ball_top\""}},
       "scene.toml:24: boundary: names edges of plane scenes; solids name faces, in [face]\n"
       "scene.toml:47: support.holder.edge = \"ball_top\": is of plane scenes; solids take face"},
      {"forces per length",
       {{"{ force_N = -500.0, history = \"press\" }", "[{ force_N_per_mm = -500.0 }, { spring_N_per_mm2 = 3.0 }]"}},
       "scene.toml:48: support.holder.z[0].force_N_per_mm = -500.0: is of plane scenes; solids take force_N\n"
       "scene.toml:48: support.holder.z[1].spring_N_per_mm2 = 3.0: is of plane scenes; solids take spring_N_per_mm"},
      {"moment per length",
       {{"spring_N_mm_per_rad", "spring_N_mm_per_mm"}},
       "scene.toml:51: support.holder.rotation_z.spring_N_mm_per_mm = 50.0: is of plane scenes; solids take "
       "spring_N_mm_per_rad"},
      {"other keys of a support",
       {{"[support.slope]",
         "[support.slope]\npoint_mm = [0, 0]\nangle_deg = 3\ntangent = \"fixed\"\nrotation = \"fixed\""}},
       "scene.toml:62: support.slope.point_mm = [0, 0]: is of plane scenes; solids are held at faces\n"
       "scene.toml:63: support.slope.angle_deg = 3: is of plane scenes; solids take axis_x and axis_z\n"
       "scene.toml:64: support.slope.tangent = \"fixed\": is of plane scenes; along a face solids take x, y, z with "
       "axis_z along its normal\n"
       "scene.toml:65: support.slope.rotation = \"fixed\": is of plane scenes; solids take rotation_x, rotation_y and "
       "rotation_z"},
      {"zone of the plane",
       {{"radius_mm = 2.0", "half_width_mm = 2.0, depth_mm = 1.0"}},
       "scene.toml:35: contact.pad.fine_zone[0].half_width_mm = 2.0: is of plane scenes; a zone of solids takes "
       "radius_mm or half_widths_mm\n"
       "scene.toml:35: contact.pad.fine_zone[0].depth_mm = 1.0: is of plane scenes; a zone of solids takes radius_mm "
       "or half_widths_mm"},
      {"wear",
       {{"friction  = 0.3", "friction = 0.3\nwear = { law = \"archard\" }\nimplicit = true"},
        {"cycles = 3", "cycles = 3\njump = 10\nwear = true"}},
       "scene.toml:35: contact.pad.wear: needs secondary_per_MPa, primary_per_MPa or both"},
      {"wear by speed",
       {{"friction  = 0.3",
         "friction = 0.3\nwear = { law = \"archard\", secondary_per_MPa = 1e-8, speed_exponent = 0.5, "
         "speed_ref_mm_per_s = 10 }"}},
       "scene.toml:78: step[0].period_s: missing; contact \"pad\" wears with a speed_exponent\n"
       "scene.toml:83: step[1].period_s: missing; contact \"pad\" wears with a speed_exponent"},
      {"remeshes where no surface moves",
       {{"symmetry = [", "shape = \"off\"\nremesh = { every_blocks = 2 }\nsymmetry = ["}},
       "scene.toml:5: remesh.every_blocks = 2: with shape = \"off\" no surface moves and no body is remeshed; leave "
       "one of "
       "them out"},
      {"limit and remesh",
       {{"[output]", "[limit.life]\ncontact = \"pad\"\n[remesh]\nmin_angle_deg = 10\nmin_quality = 0.9\n[output]"}},
       "scene.toml:88: limit.life: needs one of depth_mm, volume_mm3\n"
       "scene.toml:91: remesh.min_angle_deg = 10: is of plane scenes; solids take min_quality and min_facet_shape\n"
       "scene.toml:92: remesh.min_quality = 0.9: must lie in [0.05, 0.8]"},
      {"limit of the plane",
       {{"[output]", "[limit.life]\ncontact = \"pat\"\narea_mm2 = 1\ndepth_mm = 1\n[output]"}},
       "scene.toml:89: limit.life.contact = \"pat\": there is no contact \"pat\"; did you mean \"pad\"?\n"
       "scene.toml:90: limit.life.area_mm2 = 1: is of plane scenes; solids take volume_mm3"},
      {"section, bond",
       {{"symmetry", "section = { normal = [0, 0, 1] }\nbond = {}\nsymmetry"}},
       "scene.toml:4: section: cuts solids into faces of a plane scene; a scene of solids takes them whole\n"
       "scene.toml:5: bond: bonds of solids are not built yet"},
      {"loads of the plane",
       {{"body            = \"flat\"", "edge = \"left\"\nforce_N_per_mm = [0, 1]"}},
       "scene.toml:70: load.weight.edge = \"left\": is of plane scenes; solids take face\n"
       "scene.toml:71: load.weight.force_N_per_mm = [0, 1]: is of plane scenes; solids take force_N"},
      {"bodies of the plane",
       {{"mesh     = {", "kinematics = \"finite\"\nb_bar = true\nmesh = { element = \"quad\", "}},
       "scene.toml:13: body.ball.kinematics = \"finite\": solids are of small strain so far\n"
       "scene.toml:14: body.ball.b_bar = true: is of plane scenes; tetrahedra of order = 2 do not lock\n"
       "scene.toml:15: body.ball.mesh.element = \"quad\": is of plane scenes; solids are meshed by tetrahedra, and "
       "mesh files bring their elements"},
  });
}
