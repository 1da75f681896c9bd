#include <gtest/gtest.h>

#include "bad_solid.hpp"

using namespace reye;

/// Names that nothing has, or that cannot play their part.
TEST(BadSolid, Names) {
  test::expect_solid_refused({
      {"unknown names",
       {{"material = \"steel\"\nmesh", "material = \"stel\"\nmesh"},
        {"body = \"ball\", type", "body = \"bal\", type"},
        {"body   = \"stop\"", "body = \"stopp\""},
        {"body            = \"flat\"", "body = \"moon\""},
        {"body = \"flat\", at_mm", "body = \"falt\", at_mm"}},
       "scene.toml:12: body.ball.material = \"stel\": there is no material \"stel\"; did you mean \"steel\"?\n"
       "scene.toml:25: face.ball_contact.body = \"bal\": there is no body \"bal\"; did you mean \"ball\"?\n"
       "scene.toml:55: support.stop.body = \"stopp\": there is no body \"stopp\"; did you mean \"stop\"?\n"
       "scene.toml:70: load.weight.body = \"moon\": there is no body \"moon\"; known: \"ball\", \"flat\", \"stop\"\n"
       "scene.toml:90: output.probes.edge.body = \"falt\": there is no body \"falt\"; did you mean \"ball\"?"},
      {"unknown histories",
       {{"value = 0.4, history = \"rub\"", "value = 0.4, history = \"rubb\""},
        {"0.01, history = \"press\"", "0.01, history = \"pres\""},
        {"play = [\"rub\"]", "play = [\"run\", \"rub\", \"rub\"]"}},
       "scene.toml:37: contact.pad.imposed_sliding_mm.history = \"rubb\": there is no history \"rubb\"; did you mean "
       "\"rub\"?\n"
       "scene.toml:50: support.holder.rotation_y.history = \"pres\": there is no history \"pres\"; did you mean "
       "\"press\"?\n"
       "scene.toml:84: step[1].play = [\"run\", \"rub\", \"rub\"]: there is no history \"run\"; did you mean \"rub\"?\n"
       "scene.toml:84: step[1].play = [\"run\", \"rub\", \"rub\"]: names \"rub\" twice"},
      {"rigid secondary",
       {{"secondary = \"flat_bottom\"\nprimary   = [\"stop_top\"]",
         "secondary = \"stop_top\"\nprimary   = [\"flat_bottom\"]"}},
       "scene.toml:41: contact.stop.secondary = \"stop_top\": lies on the rigid body \"stop\"; the secondary side must "
       "deform"},
      {"rigid face as secondary",
       {{"secondary = \"flat_contact\"\nprimary   = [\"ball_contact\"]",
         "secondary = \"ball_top\"\nprimary   = [\"flat_contact\"]"}},
       "scene.toml:32: contact.pad.secondary = \"ball_top\": is the rigid face of support \"holder\"; the secondary "
       "side must deform"},
      {"both sides on one body",
       {{"[\"ball_contact\"]", "[\"flat_bottom\"]"}},
       "scene.toml:33: contact.pad.primary = [\"flat_bottom\"]: \"flat_bottom\" lies on the body of the secondary "
       "side, \"flat\""},
      {"sides",
       {{"[\"ball_contact\"]", "[\"flat_contact\", \"ball_top\", \"ball_top\"]"}},
       "scene.toml:33: contact.pad.primary = [\"flat_contact\", \"ball_top\", \"ball_top\"]: \"flat_contact\" is also "
       "the secondary side\n"
       "scene.toml:33: contact.pad.primary = [\"flat_contact\", \"ball_top\", \"ball_top\"]: names \"ball_top\" twice"},
      {"secondary twice",
       {{"secondary = \"flat_bottom\"", "secondary = \"flat_contact\""}},
       "scene.toml:41: contact.stop.secondary = \"flat_contact\": is already the secondary side of contact \"pad\"; "
       "give one contact all its primary faces"},
      {"the same pair",
       {{"secondary = \"flat_bottom\"\nprimary   = [\"stop_top\"]",
         "secondary = \"ball_contact\"\nprimary   = [\"flat_contact\"]"}},
       "scene.toml:42: contact.stop.primary = [\"flat_contact\"]: \"flat_contact\" meets \"ball_contact\" in contact "
       "\"pad\" already"},
      {"faces of symmetry",
       {{"[\"ball_sx\", \"flat_sx\"]", "[\"flat_contact\", \"ball_contact\", \"flat_side\", \"flat_side\"]"}},
       "scene.toml:4: symmetry = [\"flat_contact\", \"ball_contact\", \"flat_side\", \"flat_side\"]: names "
       "\"flat_side\" twice\n"
       "scene.toml:32: contact.pad.secondary = \"flat_contact\": is a face of symmetry\n"
       "scene.toml:33: contact.pad.primary = [\"ball_contact\"]: \"ball_contact\" is a face of symmetry\n"
       "scene.toml:63: support.slope.normal: the face is held there by symmetry"},
      {"order", {{"order    = 1", "order = 3"}}, "scene.toml:18: body.flat.order = 3: must be 1 or 2"},
  });
}

/// Motions, axes and loads that contradict themselves.
TEST(BadSolid, Supports) {
  test::expect_solid_refused({
      {"moved and loaded",
       {{"{ force_N = -500.0, history = \"press\" }", "[{ force_N = -500.0 }, { motion_mm = 0.1 }]"}},
       "scene.toml:48: support.holder.z[1].motion_mm = 0.1: does not go with the force_N of the parts before it: a "
       "motion is imposed, or a force leaves it to the equations"},
      {"both in one part",
       {{"{ force_N = -500.0,", "{ force_N = -500.0, motion_mm = 0.1,"}},
       "scene.toml:48: support.holder.z: takes only one of motion_mm, force_N"},
      {"rotation of a face that is not rigid",
       {{"[0.0, 0.0, 50.0]", "[0.0, 0.0, 50.0]\nrigid = false"}},
       "scene.toml:49: support.holder.rotation_x = \"fixed\": needs a rigid face\n"
       "scene.toml:50: support.holder.rotation_y: needs a rigid face\n"
       "scene.toml:51: support.holder.rotation_z: needs a rigid face\n"
       "scene.toml:52: support.holder.centre_mm = [0.0, 0.0, 50.0]: has no use where the face is not rigid\n"
       "scene.toml:53: support.holder.rigid = false: a force or a spring needs a rigid face; or use [load] for a "
       "force"},
      {"normal of a rigid face",
       {{"x          = \"fixed\"", "normal = \"fixed\""}},
       "scene.toml:46: support.holder.normal = \"fixed\": a rigid face has no motion along its normals; take axis_z "
       "along the normal, and z"},
      {"force along the normal",
       {{"normal = { motion_mm = 0.1,", "normal = { force_N = 0.1,"}},
       "scene.toml:63: support.slope.normal.force_N = 0.1: a face is pressed along its normals by a load, "
       "pressure_MPa"},
      {"axes askew",
       {{"[1.0, 1.0, 0.0]", "[1.0, 1.0, 0.1]"}},
       "scene.toml:59: support.stop.axis_x = [1.0, 1.0, 0.1]: must be at right angles to axis_z"},
      {"axes of a normal",
       {{"face   = \"flat_side\"", "face = \"flat_side\"\naxis_z = [0, 0, 1]\ncentre_mm = [0, 0, 0]"}},
       "scene.toml:63: support.slope.axis_z = [0, 0, 1]: has no use: normal follows the face\n"
       "scene.toml:64: support.slope.centre_mm = [0, 0, 0]: has no use where the face is not rigid"},
      {"support of a body that deforms",
       {{"body   = \"stop\"", "body = \"flat\""}},
       "scene.toml:55: support.stop.body = \"flat\": deforms: it is held at a face"},
      {"rigid body by node",
       {{"body   = \"stop\"", "body = \"stop\"\nrigid = false"}},
       "scene.toml:56: support.stop.rigid = false: a rigid body moves as one"},
      {"no place, two places, no motion",
       {{"face       = \"ball_top\"\n", ""},
        {"body   = \"stop\"", "body = \"stop\"\nface = \"stop_top\""},
        {"normal = { motion_mm = 0.1, history = \"press\" }", ""}},
       "scene.toml:44: support.holder: needs one of face, body\n"
       "scene.toml:53: support.stop: takes only one of face, body\n"
       "scene.toml:61: support.slope: names no motion: x, y, z, normal, rotation_x, rotation_y or rotation_z"},
      {"loads",
       {{"{ traction_MPa = [0, 0, 1] }", "{ force_N_per_mm3 = [0, 0, 1] }"},
        {"force_N_per_mm3 = [0.0, 0.0, -7.7e-5]", "pressure_MPa = 1.0"}},
       "scene.toml:67: load.squeeze.parts[1].force_N_per_mm3 = [0, 0, 1]: does not go with face\n"
       "scene.toml:67: load.squeeze.parts[1]: needs pressure_MPa, traction_MPa or force_N\n"
       "scene.toml:69: load.weight.force_N_per_mm3: missing\n"
       "scene.toml:71: load.weight.pressure_MPa = 1.0: does not go with body"},
      {"load without a place",
       {{"body            = \"flat\"\n", ""},
        {"face     = \"flat_side\"", "face = \"flat_side\"\npressure_MPa = 3.0\nhistory = \"press\""}},
       "scene.toml:67: load.squeeze.pressure_MPa = 3.0: stands in each of the parts\n"
       "scene.toml:68: load.squeeze.history = \"press\": stands in each of the parts\n"
       "scene.toml:71: load.weight: needs one of face, body"},
      {"rigid with material, and without",
       {{"rigid = true", "rigid = true\nmaterial = \"steel\""}, {"material = \"steel\"\nmesh", "mesh"}},
       "scene.toml:10: body.ball.material: missing; a body has a material or is rigid\n"
       "scene.toml:22: body.stop.material = \"steel\": a rigid body takes none"},
      {"locking",
       {{"nu    = 0.3", "nu = 0.49"}},
       "scene.toml:18: body.flat.order = 1: tetrahedra of first order lock at nu = 0.49, as above 0.45; take order = "
       "2"},
      {"zone",
       {{"radius_mm = 2.0", "radius_mm = 2.0, half_widths_mm = [1, 1, -1]"},
        {"half_widths_mm = [1.0, 2.0, 3.0], size_mm = 0.5", "size_mm = 0.5"}},
       "scene.toml:35: contact.pad.fine_zone[0].half_widths_mm = [1, 1, -1]: must be > 0\n"
       "scene.toml:35: contact.pad.fine_zone[0]: takes only one of radius_mm, half_widths_mm\n"
       "scene.toml:36: contact.pad.fine_zone[1]: needs one of radius_mm, half_widths_mm"},
      {"zone without a size",
       {{", size_mm = 0.5", ""}},
       "scene.toml:36: contact.pad.fine_zone[1].size_mm: missing; only a scene with accuracy may leave it out"},
      {"open cycle",
       {{"play = [\"rub\"]", "play = [\"rub\", \"press\"]"}},
       "scene.toml:84: step[1].play = [\"rub\", \"press\"]: history \"press\" ends a cycle at 1 and began it at 0; "
       "give it the way back: a last corner [1, 0]"},
  });
}

/// Imposed sliding needs no way back at the end of a cycle.
TEST(BadSolid, SlidingNeedsNoWayBack) {
  auto text = test::replaced(test::solid_example, "value = 0.4, history = \"rub\"", "value = 0.4, history = \"on\"");
  text = test::replaced(text, "[history]", "[history]\non = [[0, 0], [1, 1]]");
  EXPECT_EQ(test::solid_refusal(test::replaced(text, "play = [\"rub\"]", "play = [\"rub\", \"on\"]")), "");
}

/// Whole turns about one axis need no way back at the end of a cycle; parts of a turn, and turns about two axes, do.
TEST(BadSolid, WholeTurnsNeedNoWayBack) {
  auto played = test::replaced(test::solid_example, "[history]", "[history]\non = [[0, 0], [1, 2]]");
  played = test::replaced(played, "play = [\"rub\"]", "play = [\"rub\", \"on\"]");
  const auto turned = [](const std::string& text, const std::string& motion) {
    return test::solid_refusal(test::replaced(text, "{ motion_rad = 0.01, history = \"press\" }", motion));
  };
  const std::string thrice = "{ motion_rad = 9.42477796, history = \"on\" }";
  EXPECT_EQ(turned(played, thrice), "");
  EXPECT_NE(turned(played, "{ motion_rad = 3.0, history = \"on\" }").find("ends a cycle"), std::string::npos);
  const auto twice =
      test::replaced(played, "{ spring_N_mm_per_rad = 50.0 }", "{ motion_rad = 0.1, history = \"rub\" }");
  EXPECT_NE(turned(twice, thrice).find("ends a cycle"), std::string::npos);
}

/// A plane scene with keys of solids says what it takes, and the reader of plane scenes does not take solids.
TEST(BadSolid, InPlaneScenes) {
  std::string text = test::replaced(test::example, "[material.steel]",
                                    "symmetry = [\"left\"]\n[face.top]\nbody = \"flat\"\n[material.steel]");
  EXPECT_EQ(test::refusal(text),
            "scene.toml:5: symmetry = [\"left\"]: is a list of faces of solids, analysis = \"solid\"; in a plane scene "
            "a support with normal = \"fixed\" is symmetry\n"
            "scene.toml:6: face: faces are of solids, analysis = \"solid\"; a plane scene names edges, in [boundary]");
  text = test::replaced(test::example, "edge     = \"top\"", "edge = \"top\"\nface = \"top\"");
  EXPECT_EQ(test::refusal(text),
            "scene.toml:35: support.holder.face = \"top\": faces are of solids, analysis = \"solid\"; a plane scene "
            "takes edge");
  EXPECT_EQ(test::refusal(test::solid_example),
            "scene.toml:2: analysis = \"solid\": a scene of solids; this command takes plane scenes only so far");
}

/// A scene without bodies or steps says so.
TEST(BadSolid, Empty) {
  EXPECT_EQ(test::solid_refusal("analysis = \"solid\"\ngeometry = [\"ball_on_flat.step\"]\n"),
            "scene.toml:1: body: missing; a scene has at least one [body.NAME]\n"
            "scene.toml:1: step: missing; a scene has at least one [[step]]");
}
