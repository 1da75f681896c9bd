#include "bad_scene.hpp"

using namespace reye;

/// Each key by itself: known, of its type, in its range, not missing; and what is no TOML at all.
TEST(BadScene, Values) {
  const std::vector<test::BadScene> scenes = {
      {"unknown key",
       {{"nu    = 0.3", "mu = 0.3"}},
       "scene.toml:5: material.steel.nu: missing\n"
       "scene.toml:8: material.steel.mu = 0.3: unknown key; did you mean nu?"},
      {"unknown key without unit",
       {{"E_MPa = 200e3", "E = 200e3"}},
       "scene.toml:5: material.steel.E_MPa: missing\n"
       "scene.toml:7: material.steel.E = 200e3: unknown key; did you mean E_MPa?"},
      {"unknown key far from all",
       {{"[material.steel]", R"(colour = "red")"
                             "\n"
                             "[material.steel]"}},
       R"(scene.toml:5: colour = "red": unknown key; known here: title, analysis, accuracy, geometry, section, shape, material, body, boundary, contact, bond, support, load, history, step, spectrum, limit, output, remesh, solver)"},
      {"unknown table", {{"[limit.life]", "[limits.life]"}}, "scene.toml:68: limits: unknown key; did you mean limit?"},
      {"several at once",
       {{"nu    = 0.3", "nu = 0.5"},
        {"friction  = 0.9", "friction = -0.1"},
        {"increments = 10", "increments = 0"},
        {"size_mm = 0.010", "size_mm = 0"}},
       "scene.toml:8: material.steel.nu = 0.5: must lie in (-1, 0.5)\n"
       "scene.toml:29: contact.pad.friction = -0.1: must be >= 0\n"
       "scene.toml:31: contact.pad.fine_zone.size_mm = 0: must be > 0\n"
       "scene.toml:52: step[0].increments = 0: must lie in [1, 1e+05]"},
      {"accuracy",
       {{"[material.steel]", "accuracy = 0\n[material.steel]"}},
       "scene.toml:5: accuracy = 0: must lie in (0, 0.2]"},
      {"remeshes where no surface moves",
       {{"[material.steel]", "shape = \"off\"\n[remesh]\nevery_blocks = 2\n[material.steel]"}},
       "scene.toml:7: remesh.every_blocks = 2: with shape = \"off\" no surface moves and no body is remeshed; leave "
       "one of "
       "them out"},
      {"accuracy of a guess",
       {{"[material.steel]", "accuracy = 0.21\n[material.steel]"}},
       "scene.toml:5: accuracy = 0.21: must lie in (0, 0.2]"},
      {"size left out without an accuracy",
       {{", size_mm = 0.010", ""}},
       "scene.toml:31: contact.pad.fine_zone.size_mm: missing; only a scene with accuracy may leave it out"},
      {"one of several fine zones",
       {{"fine_zone = { centre_mm = [0.0, 0.0], half_width_mm = 0.5, depth_mm = 0.2, size_mm = 0.010 }",
         "fine_zone = [{ centre_mm = [0.0, 0.0], half_width_mm = 0.5, depth_mm = 0.2, size_mm = 0.010 },\n"
         "  { centre_mm = [0.0, 0.0], half_width_mm = -1, depth_mm = 0.2 }]"}},
       "scene.toml:32: contact.pad.fine_zone[1].half_width_mm = -1: must be > 0\n"
       "scene.toml:32: contact.pad.fine_zone[1].size_mm: missing; only a scene with accuracy may leave it out"},
      {"fine zones that are none",
       {{"fine_zone = { centre_mm = [0.0, 0.0], half_width_mm = 0.5, depth_mm = 0.2, size_mm = 0.010 }",
         "fine_zone = []"}},
       "scene.toml:31: contact.pad.fine_zone = []: must be a table of centre_mm, half_width_mm, depth_mm, "
       "size_mm, angle_deg, or a list of such tables"},
      {"remeshing",
       {{"[material.steel]",
         "[remesh]\nevery_blocks = -1\nmin_scaled_jacobian = 0.9\nmin_angle_deg = 60\nsize_ratio = 1\n"
         "wear_fraction = 0\nmax_dofs = 10\nfit_tolerance_mm = 0\n[material.steel]"}},
       "scene.toml:6: remesh.every_blocks = -1: must be >= 0\n"
       "scene.toml:7: remesh.min_scaled_jacobian = 0.9: must lie in (0, 0.8]\n"
       "scene.toml:8: remesh.min_angle_deg = 60: must lie in [0, 50]\n"
       "scene.toml:9: remesh.size_ratio = 1: must be > 1\n"
       "scene.toml:10: remesh.wear_fraction = 0: must lie in (0, 2]\n"
       "scene.toml:11: remesh.max_dofs = 10: must be >= 100\n"
       "scene.toml:12: remesh.fit_tolerance_mm = 0: must be > 0"},
      {"output",
       {{"frames = { every_cycles = 1000 }",
         "frames = { every_blocks = -2, per_decade = 2.5, at_remeshes = 1 }\nhistory = { every_blocks = 0 "
         "}\ncheckpoint_s = -1"}},
       "scene.toml:74: output.frames.every_blocks = -2: must be >= 0\n"
       "scene.toml:74: output.frames.per_decade = 2.5: must be a whole number\n"
       "scene.toml:74: output.frames.at_remeshes = 1: must be true or false\n"
       "scene.toml:75: output.history.every_blocks = 0: must be >= 1\n"
       "scene.toml:76: output.checkpoint_s = -1: must be >= 0"},
      {"poisson low", {{"nu    = 0.3", "nu = -1"}}, "scene.toml:8: material.steel.nu = -1: must lie in (-1, 0.5)"},
      {"youngs modulus", {{"E_MPa = 200e3", "E_MPa = 0.0"}}, "scene.toml:7: material.steel.E_MPa = 0.0: must be > 0"},
      {"not a number",
       {{"E_MPa = 200e3", "E_MPa = nan"}, {"friction  = 0.9", "friction = inf"}},
       "scene.toml:7: material.steel.E_MPa = nan: must be finite\n"
       "scene.toml:29: contact.pad.friction = inf: must be finite"},
      {"infinite in a list",
       {{"at       = [0.0, 3.0]", "at = [0.0, -inf]"}, {"[[0.0, 0.0], [1.0, 1.0]]", "[[0.0, 0.0], [1.0, nan]]"}},
       "scene.toml:11: body.cylinder.at = [0.0, -inf]: must be finite\n"
       "scene.toml:46: history.press = [[0.0, 0.0], [1.0, nan]]: must be finite"},
      {"types",
       {{"E_MPa = 200e3", R"(E_MPa = "200e3")"},
        {"wear = false", R"(wear = "no")"},
        {"increments = 40", "increments = 40.5"},
        {"at       = [0.0, 3.0]", "at = [0.0, 3.0, 1.0]"},
        {"title    = ", "title = 3 # "}},
       "scene.toml:1: title = 3: must be a text in quotes\n"
       R"(scene.toml:7: material.steel.E_MPa = "200e3": must be a number)"
       "\n"
       "scene.toml:11: body.cylinder.at = [0.0, 3.0, 1.0]: must be a list of two numbers\n"
       R"(scene.toml:53: step[0].wear = "no": must be true or false)"
       "\n"
       "scene.toml:58: step[1].increments = 40.5: must be a whole number"},
      {"text for list",
       {{R"(["round"])", R"("round")"},
        {R"(geometry = ["cylinder_on_flat.step"])", R"(geometry = "cylinder_on_flat.step")"}},
       R"(scene.toml:3: geometry = "cylinder_on_flat.step": must be a list of texts in quotes)"
       "\n"
       R"(scene.toml:28: contact.pad.primary = "round": must be a list of texts in quotes)"},
      {"choice",
       {{R"("plane_strain" )", R"("plane_strin" )"},
        {R"(element = "quad")", R"(element = "hexa")"},
        {R"("circle")", R"("arc")"},
        {R"(side     = "secondary")", R"(side = "both")"}},
       R"(scene.toml:2: analysis = "plane_strin": must be "plane_strain", "plane_stress", "axisymmetric" or "solid")"
       "\n"
       R"(scene.toml:13: body.cylinder.mesh.element = "hexa": must be "quad" or "tri")"
       "\n"
       R"(scene.toml:22: boundary.round.type = "arc": must be "line", "circle" or "spline")"
       "\n"
       R"(scene.toml:70: limit.life.side = "both": must be "secondary", "primary" or "sum")"},
      {"a spectrum of steps that do not follow one another",
       {{"[limit.life]", "[spectrum]\nsteps = [\"wear\", \"press\"]\ntimes = 0\n[limit.life]"}},
       "scene.toml:69: spectrum.steps = [\"wear\", \"press\"]: must name steps that follow one another, in their "
       "order\n"
       "scene.toml:70: spectrum.times = 0: must lie in [1, 1e+05]"},
      {"a jump under control",
       {{"jump = 100 ", "jump = { tolerance = 2, first = 0.5 } "}},
       "scene.toml:66: step[2].jump.tolerance = 2: must lie in [1e-05, 0.2]\n"
       "scene.toml:66: step[2].jump.first = 0.5: must be >= 1"},
      {"a jump under control without its tolerance",
       {{"jump = 100 ", "jump = { first = 10 } "}},
       "scene.toml:66: step[2].jump.tolerance: missing"},
      {"linear elasticity at finite strain",
       {{"[boundary]", R"(kinematics = "finite")"
                       "\n"
                       "[boundary]"}},
       R"(scene.toml:20: body.flat.kinematics = "finite": material "steel" is linear_elastic, a law of small strain; )"
       "the same E_MPa and nu serve hencky, neo_hookean and st_venant_kirchhoff"},
      {"laws that do not take a key",
       {{"nu    = 0.3", "nu = 0.3\nvolumetric = \"mixed\"\nhardening = { law = \"linear\", yield_MPa = 1 }"}},
       R"(scene.toml:9: material.steel.volumetric = "mixed": only neo_hookean takes one)"
       "\n"
       "scene.toml:10: material.steel.hardening: only hencky_j2 takes one"},
      {"hardening missing",
       {{"nu    = 0.3", "nu = 0.3\nlaw = \"hencky_j2\""}, {"law   = \"linear_elastic\"", ""}},
       "scene.toml:5: material.steel.hardening: missing; hencky_j2 needs a table of it"},
      {"hardening parameters",
       {{"nu    = 0.3",
         "nu = 0.3\nlaw = \"hencky_j2\"\nhardening = { law = \"voce\", yield_MPa = 300, saturation_MPa = 200, exponent "
         "= 0.2 }"},
        {"law   = \"linear_elastic\"", ""}},
       "scene.toml:10: material.steel.hardening.rate: missing; hardening by voce needs it\n"
       "scene.toml:10: material.steel.hardening.exponent = 0.2: hardening by voce takes none\n"
       "scene.toml:10: material.steel.hardening.saturation_MPa = 200: must be >= yield_MPa"},
      {"hardening table",
       {{"nu    = 0.3",
         "nu = 0.3\nlaw = \"hencky_j2\"\nhardening = { law = \"table\", points = [[0.1, 300], [0.2, 200]] }"},
        {"law   = \"linear_elastic\"", ""}},
       "scene.toml:10: material.steel.hardening.points = [[0.1, 300], [0.2, 200]]: must start at p = 0 with a yield "
       "stress > 0\n"
       "scene.toml:10: material.steel.hardening.points = [[0.1, 300], [0.2, 200]]: the yield stress must not fall"},
      {"order unknown",
       {{"[boundary]",
         "order = 3\n"
         "[boundary]"}},
       "scene.toml:20: body.flat.order = 3: must be 1 or 2"},
      {"wear rate",
       {{"primary_mm3_per_J = 2.111e-5",
         "primary_mm3_per_J = 2.111e-5, pressure_exponent = -1, pressure_ref_MPa = 0, "
         "speed_exponent = -2, speed_ref_mm_per_s = -1, threshold_mJ_per_mm2 = -3"},
        {"jump = 100 ", "period_s = 0\njump = 100 "}},
       "scene.toml:30: contact.pad.wear.pressure_exponent = -1: must be > -1\n"
       "scene.toml:30: contact.pad.wear.pressure_ref_MPa = 0: must be > 0\n"
       "scene.toml:30: contact.pad.wear.speed_exponent = -2: must be > -1\n"
       "scene.toml:30: contact.pad.wear.speed_ref_mm_per_s = -1: must be > 0\n"
       "scene.toml:30: contact.pad.wear.threshold_mJ_per_mm2 = -3: must be >= 0\n"
       "scene.toml:66: step[2].period_s = 0: must be > 0"},
      {"friction over cycles",
       {{"friction  = 0.9", "friction = { cycles = [0, 100, 100], value = [0.3, -0.1, 0.9] }"}},
       "scene.toml:29: contact.pad.friction.value = [0.3, -0.1, 0.9]: must be >= 0\n"
       "scene.toml:29: contact.pad.friction.cycles = [0, 100, 100]: must increase strictly"},
      {"friction over cycles of another length",
       {{"friction  = 0.9", "friction = { cycles = [0, 100], value = [0.3] }"}},
       "scene.toml:29: contact.pad.friction.value = [0.3]: must hold as many numbers as cycles, 2"},
      {"friction over cycles of another type",
       {{"friction  = 0.9", R"(friction = { cycles = [], value = ["high"] })"}},
       "scene.toml:29: contact.pad.friction.cycles = []: must be a list of numbers\n"
       R"(scene.toml:29: contact.pad.friction.value = ["high"]: must be a list of numbers)"},
      {"friction over nothing",
       {{"friction  = 0.9", "friction = { value = [0.3], cycle = [0] }"}},
       "scene.toml:29: contact.pad.friction.cycle = [0]: unknown key; did you mean cycles?\n"
       "scene.toml:29: contact.pad.friction.cycles: missing"},
      {"friction of another type",
       {{"friction  = 0.9", R"(friction = "high")"}},
       R"(scene.toml:29: contact.pad.friction = "high": is no usable formula: it names "high", which is none of pressure_MPa, speed_mm_per_s, path_mm, depth_mm, cycle)"},
      {"friction by a formula that does not end",
       {{"friction  = 0.9", R"(friction = "0.3 + 0.1*(1 - cycle")"}},
       R"(scene.toml:29: contact.pad.friction = "0.3 + 0.1*(1 - cycle": is no usable formula: Missing parenthesis)"},
      {"friction by a formula that is negative from the start",
       {{"friction  = 0.9", R"(friction = "path_mm/100 - 0.1")"}},
       R"(scene.toml:29: contact.pad.friction = "path_mm/100 - 0.1": is no usable formula: the formula "path_mm/100 - 0.1" is -0.1 at path_mm = 0; it must be finite and not negative)"},
      {"friction by a formula that is zero at the start",
       {{"friction  = 0.9", R"~(friction = "0.3*(cycle > 100)")~"}},
       R"~(scene.toml:29: contact.pad.friction = "0.3*(cycle > 100)": is zero where path, depth and cycle are; a formula must be above zero there)~"},
      {"friction by a formula of speed in steps without duration",
       {{"friction  = 0.9", R"(friction = "0.3 + 1/(10 + speed_mm_per_s)*2")"}},
       "scene.toml:49: step[0].period_s: missing; contact \"pad\" rubs by a formula of speed_mm_per_s\n"
       "scene.toml:55: step[1].period_s: missing; contact \"pad\" rubs by a formula of speed_mm_per_s\n"
       "scene.toml:61: step[2].period_s: missing; contact \"pad\" rubs by a formula of speed_mm_per_s"},
      {"friction zero at all cycles",
       {{"friction  = 0.9", "friction = { cycles = [0, 5], value = [0, 0] }"}},
       R"(scene.toml:30: contact.pad.wear.law = "energy": without friction no energy is dissipated; use friction > 0 or archard)"},
      {"missing keys",
       {{"nu    = 0.3", ""},
        {R"(secondary = "face")", "#"},
        {"centre_mm = [0.0, 0.0], ", ""},
        {", at_mm = [0.5, 0.0]", ""}},
       "scene.toml:5: material.steel.nu: missing\n"
       "scene.toml:26: contact.pad.secondary: missing\n"
       "scene.toml:31: contact.pad.fine_zone.centre_mm: missing\n"
       "scene.toml:75: output.probes.edge.at_mm: missing"},
      {"missing geometry key", {{"geometry = ", "# "}}, "scene.toml:1: geometry: missing"},
      {"empty geometry list", {{R"(["cylinder_on_flat.step"])", "[]"}}, "scene.toml:3: geometry = []: names no file"},
      {"geometry files",
       {{R"(["cylinder_on_flat.step"])",
         R"(["no.step", "empty.geo", "part.stl", "cylinder_on_flat.step", "./cylinder_on_flat.step", "folder.msh"])"}},
       R"(scene.toml:3: geometry = "no.step": no such file)"
       "\n"
       R"(scene.toml:3: geometry = "empty.geo": is empty)"
       "\n"
       R"(scene.toml:3: geometry = "part.stl": not supported; use .step, .stp, .iges, .igs, .brep, .geo, .msh or .vtu)"
       "\n"
       R"(scene.toml:3: geometry = "./cylinder_on_flat.step": is named twice)"
       "\n"
       R"(scene.toml:3: geometry = "folder.msh": is not a file)"},
      {"section",
       {{"[material.steel]",
         "section = { point_mm = [0, 0], normal = [0, 0, 0] }\n"
         "[material.steel]"}},
       "scene.toml:5: section.point_mm = [0, 0]: must be a list of three numbers"},
      {"section without normal",
       {{"[material.steel]",
         "section = { point_mm = [0, nan, 0] }\n"
         "[material.steel]"}},
       "scene.toml:5: section.point_mm = [0, nan, 0]: must be finite\n"
       "scene.toml:5: section.normal: missing"},
      {"section with a zero normal",
       {{"[material.steel]",
         "[section]\n"
         "point_mm = [0, 0, 1]\n"
         "normal = [0, 0.0, 0]\n"
         "[material.steel]"}},
       "scene.toml:7: section.normal = [0, 0.0, 0]: must not be zero"},
      {"profile files",
       {{R"(box_mm = [-6.1, 5.9, 6.1, 6.1] })", R"(profile = "none.csv" })"},
        {R"(type = "circle" })", R"(type = "circle", profile = "wrong.csv" })"},
        {R"(nearest_mm = [0.0, 0.0] })", R"(nearest_mm = [0.0, 0.0], profile = "back.csv" })"},
        {R"(box_mm = [-6.1, -6.1, 6.1, -5.9] })", R"(profile = "infinite.csv" })"}},
       R"(scene.toml:21: boundary.top.profile = "none.csv": no such file)"
       "\n"
       R"(scene.toml:22: boundary.round.profile = "wrong.csv": its first line must be arc_length_mm,height_mm)"
       "\n"
       R"(scene.toml:23: boundary.face.profile = "back.csv": line 4: arc_length_mm must increase)"
       "\n"
       R"(scene.toml:24: boundary.bottom.profile = "infinite.csv": line 3: must be finite)"},
      {"more profile files",
       {{R"(box_mm = [-6.1, 5.9, 6.1, 6.1] })", R"(profile = "" })"},
        {R"(type = "circle" })", R"(type = "circle", profile = "empty.csv" })"},
        {R"(nearest_mm = [0.0, 0.0] })", R"(nearest_mm = [0.0, 0.0], profile = "short.csv" })"},
        {R"(box_mm = [-6.1, -6.1, 6.1, -5.9] })", R"(profile = "folder.msh" })"}},
       R"(scene.toml:21: boundary.top.profile = "": must not be empty)"
       "\n"
       R"(scene.toml:22: boundary.round.profile = "empty.csv": is empty)"
       "\n"
       R"(scene.toml:23: boundary.face.profile = "short.csv": needs at least two rows of numbers)"
       "\n"
       R"(scene.toml:24: boundary.bottom.profile = "folder.msh": is not a file)"},
      {"growth",
       {{"far_size_mm = 0.8 }", "far_size_mm = -1, growth = 3.5 }"},
        {"far_size_mm = 0.8 }", "far_size_mm = 0.8, growth = 1.0 }"}},
       "scene.toml:13: body.cylinder.mesh.far_size_mm = -1: must be > 0\n"
       "scene.toml:13: body.cylinder.mesh.growth = 3.5: must lie in (1, 3]\n"
       "scene.toml:18: body.flat.mesh.growth = 1.0: must lie in (1, 3]"},
      {"wear negative",
       {{"3.222e-5", "-3.222e-5"}},
       "scene.toml:30: contact.pad.wear.secondary_mm3_per_J = -3.222e-5: must be >= 0"},
      {"wear without law", {{R"(law = "energy", )", ""}}, "scene.toml:30: contact.pad.wear.law: missing"},
      {"history too short",
       {{"[[0.0, 0.0], [1.0, 1.0]]", "[[0.0, 0.0]]"}},
       "scene.toml:46: history.press = [[0.0, 0.0]]: must be a list of at least two pairs [progress, factor], or a "
       "table of file, column, tolerance, close"},
      {"history not increasing",
       {{"[0.25, 1.0], [0.75, -1.0]", "[0.75, 1.0], [0.25, -1.0]"}},
       "scene.toml:47: history.stroke = [[0.0, 0.0], [0.75, 1.0], [0.25, -1.0], [1.0, 0.0]]: progress must increase "
       "strictly from 0 to 1"},
      {"history not to the end",
       {{"[[0.0, 0.0], [1.0, 1.0]]", "[[0.0, 0.0], [0.9, 1.0]]"}},
       "scene.toml:46: history.press = [[0.0, 0.0], [0.9, 1.0]]: progress must increase strictly from 0 to 1"},
      {"history not from the start",
       {{"[[0.0, 0.0], [1.0, 1.0]]", "[[0.1, 0.0], [1.0, 1.0]]"}},
       "scene.toml:46: history.press = [[0.1, 0.0], [1.0, 1.0]]: progress must increase strictly from 0 to 1"},
      {"cycle that does not end where it began",
       {{"[0.75, -1.0], [1.0, 0.0]]", "[1.0, 0.5]]"}},
       R"(scene.toml:63: step[2].play = ["stroke"]: history "stroke" ends a cycle at 0.5 and began it at 0; give it the way back: )"
       "a last corner [1, 0]"},
      {"solver",
       {{"[material.steel]",
         "solver = { max_newton = 0, max_cutbacks = 99999999999 }\n"
         "[material.steel]"}},
       "scene.toml:5: solver.max_newton = 0: must be >= 1\n"
       "scene.toml:5: solver.max_cutbacks = 99999999999: must be at most 1e9"},
      {"section as value",
       {{"[material.steel]",
         "output = 3\n"
         "[material.steel]"},
        {"[output]",
         "[limit.b]\n"
         R"(contact = "pad")"
         "\n"
         "depth_mm = 1\n"
         "[title2]"}},
       "scene.toml:5: output = 3: must be a table\n"
       "scene.toml:77: title2: unknown key; did you mean title?"},
      {"bad name",
       {{"[limit.life]", R"([limit."life time"])"}},
       "scene.toml:68: limit.life time: a name may hold letters, digits, '-' and '_' only"},
      {"empty text",
       {{R"(secondary = "face")", R"(secondary = "")"}},
       R"(scene.toml:27: contact.pad.secondary = "": must not be empty)"},
      {"boundary is no table",
       {{R"(round  = { body = "cylinder", type = "circle" })", R"(round = "circle")"}},
       R"(scene.toml:22: boundary.round = "circle": must be a table)"},
      {"motion word",
       {{R"(x        = "fixed")", R"(x = "fix")"}},
       R"(scene.toml:35: support.holder.x = "fix": must be "fixed" or "free", or a table of motion_mm, force_N_per_mm, force_N, spring_N_per_mm2, spring_N_per_mm, history, or a list of such tables)"},
      {"syntax",
       {{"nu    = 0.3", "nu = = 0.3"}},
       "scene.toml:8: is not TOML: Error while parsing value: could not determine value type"},
      {"duplicate key",
       {{"nu    = 0.3",
         "nu = 0.3\n"
         "nu = 0.3"}},
       "scene.toml:9: is not TOML: Error while parsing key-value pair: cannot redefine existing floating-point 'nu'"},
      {"duplicate table",
       {{"[body.flat]", "[body.cylinder]"}},
       "scene.toml:15: is not TOML: Error while parsing table header: cannot redefine existing table 'body.cylinder'"},
  };
  for (const auto& bad : scenes) test::expect_refused(bad);
}
