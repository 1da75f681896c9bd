#include "bad_scene.hpp"

using namespace reye;

/// Keys that do not go together within one table.
TEST(BadScene, Tables) {
  const std::vector<test::BadScene> scenes = {
      {"rigid with material",
       {{R"(material = "steel")"
         "\n",
         R"(material = "steel")"
         "\n"
         "rigid = true\n"
         "b_bar = true\n"}},
       R"(scene.toml:12: body.cylinder.material = "steel": a rigid body takes none)"
       "\n"
       "scene.toml:14: body.cylinder.b_bar = true: a rigid body takes none"},
      {"missing material",
       {{R"(material = "steel")"
         "\n",
         "\n"}},
       "scene.toml:10: body.cylinder.material: missing; a body has a material or is rigid"},
      {"b bar in plane stress",
       {{R"("plane_strain" )", R"("plane_stress" )"},
        {R"(material = "steel")"
         "\n",
         R"(material = "steel")"
         "\n"
         "b_bar = true\n"}},
       "scene.toml:13: body.cylinder.b_bar = true: plane stress does not lock"},
      {"boundary box reversed",
       {{"[-6.1, 5.9, 6.1, 6.1]", "[-6.1, 6.1, 6.1, 5.9]"}},
       "scene.toml:21: boundary.top.box_mm = [-6.1, 6.1, 6.1, 5.9]: must be [x_min, y_min, x_max, y_max] with x_min < "
       "x_max and y_min < y_max"},
      {"same boundary twice",
       {{R"(["round"])", R"(["face", "round", "round"])"}},
       R"(scene.toml:28: contact.pad.primary = ["face", "round", "round"]: "face" is also the secondary side)"
       "\n"
       R"(scene.toml:28: contact.pad.primary = ["face", "round", "round"]: names "round" twice)"},
      {"empty primary",
       {{R"(["round"])", "[]"}},
       "scene.toml:28: contact.pad.primary = []: must name at least one boundary"},
      {"energy without friction",
       {{"friction  = 0.9", "friction = 0.0"}},
       R"(scene.toml:30: contact.pad.wear.law = "energy": without friction no energy is dissipated; use friction > 0 or archard)"},
      {"archard without friction",
       {{"friction  = 0.9", ""},
        {R"(law = "energy", secondary_mm3_per_J = 3.222e-5, primary_mm3_per_J = 2.111e-5)",
         R"(law = "archard", secondary_per_MPa = 2.9e-8)"}},
       R"(scene.toml:30: contact.pad.wear.law = "archard": without friction needs imposed_sliding_mm)"},
      {"sliding of two kinds",
       {{"friction  = 0.9", "friction = 0.9\nimposed_sliding_mm = 1.0\nimposed_turn_rad = 0.1"}},
       "scene.toml:31: contact.pad.imposed_turn_rad = 0.1: cannot stand beside imposed_sliding_mm\n"
       "scene.toml:31: contact.pad.imposed_turn_rad = 0.1: needs analysis = \"axisymmetric\": it turns about the axis"},
      {"coefficients of the other law",
       {{"primary_mm3_per_J", "primary_per_MPa"}},
       "scene.toml:30: contact.pad.wear.primary_per_MPa = 2.111e-5: belongs to law = \"archard\"; "
       "\"energy\" takes mm3_per_J"},
      {"exponents without references",
       {{"primary_mm3_per_J = 2.111e-5", "pressure_exponent = 0.5, speed_exponent = -0.5"},
        {"jump = 100 ", "period_s = 0.1\njump = 100 "}},
       "scene.toml:30: contact.pad.wear.pressure_exponent = 0.5: needs pressure_ref_MPa\n"
       "scene.toml:30: contact.pad.wear.speed_exponent = -0.5: needs speed_ref_mm_per_s"},
      {"references without exponents",
       {{"primary_mm3_per_J = 2.111e-5", "pressure_ref_MPa = 5, speed_ref_mm_per_s = 3"}},
       "scene.toml:30: contact.pad.wear.pressure_ref_MPa = 5: has no use without pressure_exponent\n"
       "scene.toml:30: contact.pad.wear.speed_ref_mm_per_s = 3: has no use without speed_exponent"},
      {"speed without time",
       {{"primary_mm3_per_J = 2.111e-5", "speed_exponent = 0.5, speed_ref_mm_per_s = 3"}},
       "scene.toml:61: step[2].period_s: missing; contact \"pad\" wears with a speed_exponent"},
      {"threshold of Archard's law",
       {{R"(law = "energy", secondary_mm3_per_J = 3.222e-5, primary_mm3_per_J = 2.111e-5)",
         R"(law = "archard", secondary_per_MPa = 2.9e-8, threshold_mJ_per_mm2 = 5)"}},
       "scene.toml:30: contact.pad.wear.threshold_mJ_per_mm2 = 5: belongs to the energy law"},
      {"wear without coefficient",
       {{R"(law = "energy", secondary_mm3_per_J = 3.222e-5, primary_mm3_per_J = 2.111e-5)", R"(law = "archard")"}},
       "scene.toml:30: contact.pad.wear: needs secondary_per_MPa, primary_per_MPa or both"},
      {"support without place",
       {{R"(edge     = "top")"
         "\n",
         "\n"}},
       "scene.toml:33: support.holder: needs one of edge, point_mm"},
      {"support with two places",
       {{R"(edge     = "top")", R"(edge = "top")"
                                "\n"
                                "point_mm = [0, 6]"}},
       "scene.toml:33: support.holder: takes only one of edge, point_mm"},
      {"support without motion",
       {{"[history] ",
         "[support.idle]\n"
         R"(edge = "left")"
         "\n"
         "[history] "}},
       "scene.toml:45: support.idle: names no motion: x, y, tangent, normal or rotation"},
      {"motion both",
       {{"force_N_per_mm = -18.5,", "force_N_per_mm = -18.5, motion_mm = 0.1,"}},
       "scene.toml:37: support.holder.y: takes only one of motion_mm, force_N_per_mm"},
      {"parts of two kinds",
       {{"{ force_N_per_mm = -18.5, history = \"press\" }",
         "[{ force_N_per_mm = -18.5 }, { motion_mm = 0.1, history = \"pres\" }]"}},
       "scene.toml:37: support.holder.y[1].motion_mm = 0.1: does not go with the force_N_per_mm of the parts before "
       "it: a motion is "
       "imposed, or a force leaves it to the equations\n"
       R"(scene.toml:37: support.holder.y[1].history = "pres": there is no history "pres"; did you mean "press"?)"},
      {"parts of a load beside its own value",
       {{"[history] ",
         "[load.a]\nedge = \"top\"\npressure_MPa = 1\nparts = [{ pressure_MPa = 2 }, { force_N_per_mm = [1, 0] "
         "}]\n[history] "}},
       "scene.toml:47: load.a.pressure_MPa = 1: stands in each of the parts\n"
       "scene.toml:48: load.a.parts[1]: needs pressure_MPa, traction_MPa or both\n"
       "scene.toml:48: load.a.parts[1].force_N_per_mm = [1, 0]: does not go with edge"},
      {"springs",
       {{"{ force_N_per_mm = -18.5, history = \"press\" }",
         "[{ spring_N_per_mm2 = 5, force_N_per_mm = 1 }, { spring_N_per_mm2 = 6 }, { spring_N_per_mm = 7 }]"}},
       "scene.toml:37: support.holder.y[1].spring_N_per_mm2 = 6: is the second spring of this motion; write one, with "
       "the sum of both\n"
       "scene.toml:37: support.holder.y[2].spring_N_per_mm = 7: a plane scene takes spring_N_per_mm2"},
      {"sliding without value",
       {{"friction  = 0.9", "friction = 0.9\nimposed_sliding_mm = { history = \"strok\" }"}},
       "scene.toml:30: contact.pad.imposed_sliding_mm.value: missing\n"
       R"(scene.toml:30: contact.pad.imposed_sliding_mm.history = "strok": there is no history "strok"; did you mean "stroke"?)"},
      {"motion neither",
       {{"force_N_per_mm = -18.5, ", ""}},
       "scene.toml:37: support.holder.y: needs one of motion_mm, force_N_per_mm"},
      {"force on the ring in a plane scene",
       {{"force_N_per_mm = -18.5", "force_N = -18.5"}},
       "scene.toml:37: support.holder.y.force_N = -18.5: a plane scene takes force_N_per_mm"},
      {"axes mixed",
       {{"[history] ",
         "[support.a]\n"
         R"(edge = "left")"
         "\n"
         R"(normal = "fixed")"
         "\n"
         R"(x = "fixed")"
         "\n"
         "angle_deg = 30\n"
         "[history] "}},
       R"(scene.toml:48: support.a.x = "fixed": does not go with tangent and normal)"
       "\n"
       "scene.toml:49: support.a.angle_deg = 30: tangent and normal follow the edge"},
      {"force on a soft edge",
       {{R"(rotation = "fixed")"
         "\n"
         "y        = {",
         "rigid = false\n"
         "y = {"}},
       "scene.toml:36: support.holder.rigid = false: a force or moment needs a rigid edge; or use [load]"},
      {"rotation of a point",
       {{"[history] ",
         "[support.a]\n"
         "point_mm = [0, 6]\n"
         R"(rotation = "fixed")"
         "\n"
         "rigid = true\n"
         "[history] "}},
       R"(scene.toml:47: support.a.rotation = "fixed": a point does not rotate)"
       "\n"
       "scene.toml:48: support.a.rigid = true: a point is no edge"},
      {"body of an edge",
       {{R"(edge     = "top")", R"(edge = "top")"
                                "\n"
                                R"(body = "cylinder")"}},
       R"(scene.toml:35: support.holder.body = "cylinder": an edge has its own body)"},
      {"limit of nothing", {{"depth_mm = 0.0025", ""}}, "scene.toml:68: limit.life: needs one of depth_mm, area_mm2"},
      {"volume in a plane scene",
       {{"depth_mm = 0.0025", "volume_mm3 = 1.0"}},
       "scene.toml:71: limit.life.volume_mm3 = 1.0: a plane scene takes area_mm2"},
      {"loads",
       {{"[history] ",
         "[load.a]\n"
         R"(edge = "top")"
         "\n"
         "[load.b]\n"
         "pressure_MPa = 1\n"
         "[load.c]\n"
         R"(edge = "top")"
         "\n"
         "pressure_MPa = 1\n"
         "interval_mm = [3, 1]\n"
         R"(history = "gone")"
         "\n"
         "[load.d]\n"
         "point_mm = [0, 0]\n"
         "force_N = [1, 0]\n"
         "[load.e]\n"
         "force_N_per_mm3 = [0, 1]\n"
         R"(body = "moon")"
         "\n"
         "[load.f]\n"
         R"(edge = "top")"
         "\n"
         "point_mm = [0, 0]\n"
         "[history] "}},
       "scene.toml:45: load.a: needs pressure_MPa, traction_MPa or both\n"
       "scene.toml:47: load.b: needs edge, point_mm, or body with force_N_per_mm3\n"
       "scene.toml:52: load.c.interval_mm = [3, 1]: must increase\n"
       R"(scene.toml:53: load.c.history = "gone": there is no history "gone"; known: "press", "stroke")"
       "\n"
       "scene.toml:56: load.d.force_N = [1, 0]: a plane scene takes force_N_per_mm\n"
       R"(scene.toml:59: load.e.body = "moon": there is no body "moon"; known: "cylinder", "flat")"
       "\n"
       "scene.toml:60: load.f: acts on an edge, at a point or in a body; not on two of them"},
      {"load with keys of another",
       {{"[history] ",
         "[load.a]\n"
         R"(edge = "top")"
         "\n"
         "pressure_MPa = 1\n"
         R"(body = "flat")"
         "\n"
         "[load.b]\n"
         "point_mm = [0, 0]\n"
         "pressure_MPa = 2\n"
         "[history] "}},
       R"(scene.toml:48: load.a.body = "flat": does not go with edge)"
       "\n"
       "scene.toml:49: load.b.force_N_per_mm: missing\n"
       "scene.toml:51: load.b.pressure_MPa = 2: does not go with point_mm"},
      {"rotation in axisymmetry",
       {{R"("plane_strain" )", R"("axisymmetric" )"}, {R"(rotation = "fixed")", "rotation = { motion_rad = 0.1 }"}},
       R"(scene.toml:36: support.holder.rotation: must be "fixed" or "free" in an axisymmetric scene)"
       "\n"
       "scene.toml:37: support.holder.y.force_N_per_mm = -18.5: an axisymmetric scene takes force_N"},
  };
  for (const auto& bad : scenes) test::expect_refused(bad);
}
