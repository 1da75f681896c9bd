#include "command.hpp"
#include "scenes.hpp"

using namespace reye;

/// Mistakes as users make them: one good scene, altered in one place each, and every word that the command says of it.
namespace {

const char* const tilted_drawing = R"(SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 1, 1};
Rotate {{0, 0, 1}, {0, 0, 0}, Pi/4} { Surface{1}; }
Rectangle(2) = {-2, -1, 0, 4, 1};
Physical Surface("slider") = {1};
Physical Surface("base") = {2};
Physical Curve("slider_bottom") = {1, 4};
Physical Curve("slider_top") = {2};
Physical Curve("base_bottom") = {5};
Physical Curve("base_top") = {7};
)";

const char* const good_scene = R"(geometry = ["blocks.geo"]
[material.steel]
E_MPa = 200e3
nu = 0.3
[body.slider]
material = "steel"
mesh = { far_size_mm = 0.25 }
[body.base]
material = "steel"
mesh = { far_size_mm = 0.25 }
[contact.pad]
secondary = "slider_bottom"
primary = ["base_top"]
friction = 0.3
wear = { law = "energy", secondary_mm3_per_J = 3e-5, primary_mm3_per_J = 2e-5 }
[support.holder]
edge = "slider_top"
x = { motion_mm = 0.01, history = "stroke" }
y = { force_N_per_mm = -20.0, history = "press" }
rotation = "fixed"
[support.floor]
edge = "base_bottom"
x = "fixed"
y = "fixed"
[history]
press = [[0.0, 0.0], [1.0, 1.0]]
stroke = [[0.0, 0.0], [0.25, 1.0], [0.75, -1.0], [1.0, 0.0]]
[[step]]
name = "press"
play = ["press"]
wear = false
[[step]]
name = "wear"
play = ["stroke"]
increments = 8
cycles = 20
jump = 10
[limit.life]
contact = "pad"
depth_mm = 1.0
[output]
probes = { side = { body = "base", at_mm = [4.0, -0.5] } }
)";

struct Mistake {
  std::string name, command;  ///< "check" or "run"
  std::vector<std::pair<std::string, std::string>> changes;
  std::string more;  ///< put at the end of the scene
  int code;
  std::string told;  ///< on the error stream; of a run that fails the last line
};

/// A zigzag of 5 um on points 0.012 mm apart.
std::string zigzag() {
  std::string text = "arc_length_mm,height_mm\n0.2,0\n";
  for (int i = 1; i < 50; ++i) text += std::to_string(0.2 + 0.012 * i) + (i % 2 == 0 ? ",0\n" : ",-0.01\n");
  return text + "0.8,0\n";
}

void draw(const test::Place& place) {
  const std::string upper = "{1, 0, 0, 2, 1}", lower = "{0, -1, 0, 4, 1}";
  const auto drawn = [&](const std::string& file, const std::string& from, const std::string& to) {
    place.write(file, test::changed(test::blocks_geo, {{from, to}}));
  };
  place.write("blocks.geo", test::blocks_geo);
  place.write("tilted.geo", tilted_drawing);
  place.write("metres.geo", test::changed(test::blocks_geo,
                                          {{upper, "{1e-3, 0, 0, 2e-3, 1e-3}"}, {lower, "{0, -1e-3, 0, 4e-3, 1e-3}"}}));
  drawn("apart.geo", upper, "{1, 1, 0, 2, 1}");
  drawn("gap.geo", upper, "{1, 0.1, 0, 2, 1}");
  drawn("inside.geo", upper, "{1, -0.5, 0, 2, 1}");
  drawn("left.geo", lower, "{-1, -1, 0, 4, 1}");
  place.write("um.csv", "arc_length_mm,height_mm\n0.5,0\n0.6,-5\n1.4,-5\n1.5,0\n");
  place.write("fine.csv", zigzag());
}

void expect_told(const std::vector<Mistake>& mistakes) {
  const test::Place place;
  draw(place);
  for (const auto& mistake : mistakes) {
    place.write("scene.toml", test::changed(good_scene, mistake.changes) + mistake.more);
    const auto told = mistake.command == "run" ? place.reye({"run", "scene.toml", "--out", "out", "--force", "--quiet"})
                                               : place.reye({"check", "scene.toml"});
    EXPECT_EQ(told.code, mistake.code) << mistake.name;
    if (told.code == 1)  // the cause comes last
      EXPECT_TRUE(told.err.ends_with("\n" + mistake.told) || told.err == mistake.told)
          << mistake.name << ": " << told.err;
    else
      EXPECT_EQ(told.err, mistake.told) << mistake.name;
  }
}

}  // namespace

// The scene that all mistakes are made in must have no warnings.
TEST(Mistakes, None) { expect_told({{"none", "check", {}, "", 0, ""}, {"none", "run", {}, "", 0, ""}}); }

// A number in another unit must be reported at once with its line, and with what it would be in the unit of its key.
TEST(Mistakes, Units) {
  expect_told({
      {"modulus in Pa",
       "check",
       {{R"(200e3)", R"(200e9)"}},
       "",
       0,
       R"(warning: scene.toml:3: material.steel.E_MPa = 200e9: no solid has more than 1e9 MPa (steel 2.1e5, diamond 1.2e6); in Pa it would be 2e+05; for a body that does not deform write rigid = true)"
       "\n"},
      {"modulus in TPa",
       "check",
       {{R"(200e3)", R"(0.2)"}},
       "",
       0,
       R"(warning: scene.toml:5: units, body slider: The force of support holder, 20 N/mm on 2 mm of its edge, would strain body slider of E_MPa = 0.2 by 5e+03 %; check the load, and E_MPa.)"
       "\n"},
      {"wear coefficient in um^3/mJ",
       "check",
       {{R"(secondary_mm3_per_J = 3e-5)", R"(secondary_mm3_per_J = 32)"}},
       "",
       0,
       R"(warning: scene.toml:15: contact.pad.wear.secondary_mm3_per_J = 32: no wear takes off more than 1 mm^3/J, as metal cutting hardly does; in um^3/mJ it would be 3.2e-05)"
       "\n"},
      {"wear coefficient in m^3/J",
       "check",
       {{R"(primary_mm3_per_J = 2e-5)", R"(primary_mm3_per_J = 2e-14)"}},
       "",
       0,
       R"(warning: scene.toml:15: contact.pad.wear.primary_mm3_per_J = 2e-14: no wear is measured below 1e-12 mm^3/J; in m^3/J it would be 2e-05)"
       "\n"},
      {"wear factor in 1e-6 mm^3/(N m)",
       "check",
       {{R"(wear = { law = "energy", secondary_mm3_per_J = 3e-5, primary_mm3_per_J = 2e-5 })",
         R"(wear = { law = "archard", secondary_per_MPa = 1.5 })"}},
       "",
       0,
       R"(warning: scene.toml:15: contact.pad.wear.secondary_per_MPa = 1.5: no wear takes off more than 0.01 of the sliding distance per MPa; in 1e-6 mm^3/(N m) it would be 1.5e-09)"
       "\n"},
      {"wear factor in 1/Pa",
       "check",
       {{R"(wear = { law = "energy", secondary_mm3_per_J = 3e-5, primary_mm3_per_J = 2e-5 })",
         R"(wear = { law = "archard", secondary_per_MPa = 1e-15 })"}},
       "",
       0,
       R"(warning: scene.toml:15: contact.pad.wear.secondary_per_MPa = 1e-15: no wear is measured below 1e-14 1/MPa; in 1/Pa it would be 1e-09)"
       "\n"},
      {"friction in per cent",
       "check",
       {{R"(friction = 0.3)", R"(friction = 30)"}},
       "",
       0,
       R"(warning: scene.toml:14: contact.pad.friction = 30: no dry contact has a coefficient of friction above 3; in per cent it would be 0.3)"
       "\n"},
      {"stroke in metres",
       "check",
       {{R"(motion_mm = 0.01)", R"(motion_mm = 1e-5)"}},
       "",
       0,
       R"(warning: scene.toml:18: support.holder.x.motion_mm = 1e-5: moves by 1e-05 mm at most, less than a tenth of a micrometre; in metres it would be 0.01)"
       "\n"},
  });
}

// A number in another unit must be reported at once with its line, and with what it would be in the unit of its key.
TEST(Mistakes, UnitsMore) {
  expect_told({
      {"stroke in micrometres",
       "check",
       {{R"(motion_mm = 0.01)", R"(motion_mm = 10)"}},
       "",
       0,
       R"(warning: scene.toml:16: units, support holder: It moves by 10 mm, farther than all bodies reach together (4.472 mm); a motion in um must be divided by 1000.)"
       "\n"},
      {"drawing in metres",
       "check",
       {{R"(["blocks.geo"])", R"(["metres.geo"])"}, {R"(at_mm = [4.0, -0.5])", R"(at_mm = [4e-3, -5e-4])"}},
       "",
       0,
       R"(warning: scene.toml:5: units, body slider: It measures 0.002 x 0.001 mm, less than one element of far_size_mm = 0.25. A drawing in metres must be scaled by 1000: it would measure 2 x 1 mm.)"
       "\n"
       R"(warning: scene.toml:8: units, body base: It measures 0.004 x 0.001 mm, less than one element of far_size_mm = 0.25. A drawing in metres must be scaled by 1000: it would measure 4 x 1 mm.)"
       "\n"
       R"(warning: scene.toml:16: units, support holder: It moves by 0.01 mm, farther than all bodies reach together (0.004472 mm); a motion in um must be divided by 1000.)"
       "\n"},
      {"profile in micrometres",
       "check",
       {},
       R"([boundary]
worn = { body = "slider", nearest_mm = [2.0, 1.0], profile = "um.csv" }
)",
       2,
       R"(scene.toml:44: boundary.worn.profile = "um.csv": its height changes by 5 mm over 0.1 mm at arc length 0.5 mm, more steeply than 5 : 1; heights in um must be divided by 1000)"
       "\n"},
      {"profile finer than the mesh",
       "check",
       {},
       R"([boundary]
worn = { body = "slider", nearest_mm = [3.0, 0.5], profile = "fine.csv" }
)",
       0,
       R"(warning: scene.toml:44: profile, boundary worn: Its profile fine.csv has heights of 0.01 mm, of which elements of 0.007059 mm miss up to 0.002937 mm: it is finer than the mesh. Make elements there shorter, or smooth the profile.)"
       "\n"},
      {"force in N in a plane scene",
       "check",
       {{R"(force_N_per_mm)", R"(force_N)"}},
       "",
       2,
       R"(scene.toml:19: support.holder.y.force_N = -20.0: a plane scene takes force_N_per_mm)"
       "\n"},
      {"pressure of a load in Pa",
       "check",
       {},
       R"([load.air]
edge = "slider_right"
pressure_MPa = 1e5
)",
       0,
       R"(warning: scene.toml:5: units, body slider: Load air, of 1e+05 MPa, would strain body slider of E_MPa = 2e+05 by 50 %; check the load, and E_MPa.)"
       "\n"},
      {"Poisson ratio in per cent",
       "check",
       {{R"(nu = 0.3)", R"(nu = 30)"}},
       "",
       2,
       R"(scene.toml:4: material.steel.nu = 30: must lie in (-1, 0.5))"
       "\n"},
  });
}

// A point that is no place of its body must be refused with the nearest place that is.
TEST(Mistakes, Points) {
  expect_told({
      {"probe beside its body",
       "check",
       {{R"(at_mm = [4.0, -0.5])", R"(at_mm = [5.0, -0.5])"}},
       "",
       2,
       R"(scene.toml:42: output.probes.side.at_mm = [5, -0.5]: lies outside of body base, whose nearest place is (4, -0.5), 1 mm away; put the point on the body)"
       "\n"},
      {"point load a kilometre off",
       "check",
       {},
       R"([load.weight]
body = "slider"
point_mm = [1e6, 1e6]
force_N_per_mm = [0, -1]
)",
       2,
       R"(scene.toml:45: load.weight.point_mm = [1e+06, 1e+06]: lies outside of body slider, whose nearest place is (3, 1), 1.414e+06 mm away; put the point on the body)"
       "\n"},
      {"point support beside all bodies",
       "check",
       {},
       R"([support.pin]
point_mm = [0.0, 0.5]
x = "fixed"
)",
       2,
       R"(scene.toml:44: support.pin.point_mm = [0, 0.5]: lies outside of body base, whose nearest place is (0, 0), 0.5 mm away; put the point on the body)"
       "\n"},
  });
}

// Steps, histories and limits that play, count or watch nothing must be reported with their line.
TEST(Mistakes, Steps) {
  expect_told({
      {"cycles that play nothing",
       "check",
       {{R"(name = "wear"
play = ["stroke"])",
         R"(name = "wear")"},
        {R"(play = ["press"])", R"(play = ["press", "stroke"])"}},
       "",
       0,
       R"(warning: scene.toml:32: plays_nothing, step wear: Its cycles play no history that a support, a load or an imposed sliding names: nothing moves in them; write play = [...].)"
       "\n"},
      {"no cycles beside a limit",
       "check",
       {{R"(cycles = 20
)",
         R"()"},
        {R"(jump = 10
)",
         R"()"}},
       "",
       0,
       R"(warning: scene.toml:32: no_cycles, step wear: The step wears but has no cycles: it is played once and counts as none, so that no limit can be reached at a cycle; write cycles = ..., or wear = false if it only loads.)"
       "\n"},
      {"jump beyond the step",
       "check",
       {{R"(jump = 10)", R"(jump = 100)"}},
       "",
       0,
       R"(warning: scene.toml:37: step[1].jump = 100: is more than cycles = 20: the step is one block of 20 cycles)"
       "\n"},
      {"jump of none",
       "check",
       {{R"(jump = 10)", R"(jump = 0)"}},
       "",
       2,
       R"(scene.toml:37: step[1].jump = 0: must be >= 1)"
       "\n"},
      {"one increment a stroke",
       "check",
       {{R"(increments = 8)", R"(increments = 1)"}},
       "",
       0,
       R"(warning: scene.toml:32: increments, step wear: A cycle of 3 strokes has 3 increments: slip and wear are counted at the ends of strokes alone; write increments = 24 or more.)"
       "\n"},
      {"a cycle that ends elsewhere",
       "check",
       {{R"([0.75, -1.0], [1.0, 0.0]])", R"([1.0, -1.0]])"}},
       "",
       2,
       R"(scene.toml:34: step[1].play = ["stroke"]: history "stroke" ends a cycle at -1 and began it at 0; give it the way back: a last corner [1, 0])"
       "\n"},
      {"a history that no support names",
       "check",
       {{R"(press = [[)", R"(spare = [[0.0, 0.0], [1.0, 1.0]]
press = [[)"}},
       "",
       0,
       R"(warning: scene.toml:26: history.spare: no step plays it; its factor stays 0)"
       "\n"
       R"(warning: scene.toml:26: history.spare: no support, load or imposed sliding names it)"
       "\n"},
      {"a history misspelt",
       "check",
       {{R"(play = ["stroke"])", R"(play = ["strokes"])"}},
       "",
       2,
       R"(scene.toml:34: step[1].play = ["strokes"]: there is no history "strokes"; did you mean "stroke"?)"
       "\n"},
  });
}

// Steps, histories and limits that play, count or watch nothing must be reported with their line.
TEST(Mistakes, StepsMore) {
  expect_told({
      {"a history that goes back",
       "check",
       {{R"([0.25, 1.0], [0.75, -1.0])", R"([0.75, 1.0], [0.25, -1.0])"}},
       "",
       2,
       R"(scene.toml:27: history.stroke = [[0.0, 0.0], [0.75, 1.0], [0.25, -1.0], [1.0, 0.0]]: progress must increase strictly from 0 to 1)"
       "\n"},
      {"two steps of one name",
       "check",
       {{R"(name = "wear")", R"(name = "press")"}},
       "",
       2,
       R"(scene.toml:33: step[1].name = "press": another step has this name)"
       "\n"},
      {"a press that no step plays",
       "check",
       {{R"(play = ["press"])", R"(play = [])"}},
       "",
       0,
       R"(warning: scene.toml:26: history.press: no step plays it; its factor stays 0)"
       "\n"},
      {"a limit of another contact",
       "check",
       {{R"(contact = "pad"
depth)",
         R"(contact = "bad"
depth)"}},
       "",
       2,
       R"(scene.toml:39: limit.life.contact = "bad": there is no contact "bad"; did you mean "pad"?)"
       "\n"},
      {"no steps",
       "check",
       {{R"([[step]]
name = "press")",
         R"([[steps]]
name = "press")"},
        {R"([[step]]
name = "wear")",
         R"([[steps]]
name = "wear")"}},
       "",
       2,
       R"(scene.toml:1: step: missing; a scene has at least one [[step]])"
       "\n"
       R"(scene.toml:28: steps: unknown key; did you mean step?)"
       "\n"},
  });
}

// Motions that nothing holds, that contradict one another or that lead nowhere must be reported with support, body and
// motion.
TEST(Mistakes, Supports) {
  expect_told({
      {"nothing holds both bodies",
       "check",
       {{R"(y = "fixed"
[history])",
         R"(rotation = "fixed"
[history])"}},
       "",
       2,
       R"(scene.toml:5: body.slider: translation along y of slider and base together is free: no support of any of them holds it, so that no force along it has anything to push against; give one of them a support that is fixed or moved there, or a spring)"
       "\n"},
      {"a body that may turn",
       "check",
       {{R"(rotation = "fixed"
)",
         R"()"},
        {R"(friction = 0.3
wear = { law = "energy", secondary_mm3_per_J = 3e-5, primary_mm3_per_J = 2e-5 }
)",
         R"()"}},
       "",
       2,
       R"(scene.toml:5: body.slider: rotation is free: no support holds it and no load drives it)"
       "\n"},
      {"two motions of one edge",
       "check",
       {},
       R"([support.again]
edge = "slider_top"
x = { motion_mm = 0.02, history = "stroke" }
)",
       2,
       R"(scene.toml:45: support.again.x: the node at (3, 1) moves with the rigid edge of support "holder", and not as support "again" asks; say it in the support of the rigid edge)"
       "\n"},
      {"a support without motion",
       "check",
       {},
       R"([support.idle]
edge = "base_bottom"
)",
       2,
       R"(scene.toml:43: support.idle: names no motion: x, y, tangent, normal or rotation)"
       "\n"},
      {"force and motion at once",
       "check",
       {{R"(force_N_per_mm = -20.0,)", R"(force_N_per_mm = -20.0, motion_mm = 0.1,)"}},
       "",
       2,
       R"(scene.toml:19: support.holder.y: takes only one of motion_mm, force_N_per_mm)"
       "\n"},
      {"an edge that is not there",
       "check",
       {{R"(edge = "base_bottom")", R"(edge = "bottom")"}},
       "",
       2,
       R"(scene.toml:22: support.floor.edge = "bottom": no boundary has this name; there are slider.left, slider.slider_bottom, slider.slider_right, slider.slider_top, base.base_bottom, base.base_top, base.left)"
       "\n"},
      {"a force that pulls",
       "run",
       {{R"(-20.0)", R"(20.0)"}},
       "",
       1,
       R"(reye: scene.toml:28: step "press", cycle 0, progress 0 to 0.003906: body slider has come away from contact pad, and no support holds its translation along y; check the direction of its loads, and that they press it on throughout the step)"
       "\n"},
      {"a force that lifts in the middle",
       "run",
       {{R"(press = [[0.0, 0.0], [1.0, 1.0]])", R"(press = [[0.0, 0.0], [0.5, 1.0], [1.0, -1.0]])"}},
       "",
       1,
       R"(reye: scene.toml:28: step "press", cycle 0, progress 0.75 to 0.752: body slider has come away from contact pad, and no support holds its translation along y; check the direction of its loads, and that they press it on throughout the step)"
       "\n"},
  });
}

// Motions that nothing holds, that contradict one another or that lead nowhere must be reported with support, body and
// motion.
TEST(Mistakes, SupportsMore) {
  expect_told({
      {"a rigid ring moved radially",
       "check",
       {{R"(geometry)", R"(analysis = "axisymmetric"
geometry)"},
        {R"([body.slider]
material = "steel"
mesh = { far_size_mm = 0.25 })",
         R"([body.slider]
rigid = true)"},
        {R"(secondary = "slider_bottom")", R"(secondary = "base_top")"},
        {R"(primary = ["base_top"])", R"(primary = ["slider_bottom"])"},
        {R"(, primary_mm3_per_J = 2e-5)", R"()"},
        {R"(force_N_per_mm)", R"(force_N)"}},
       "",
       2,
       R"(scene.toml:18: support.holder.x: a rigid ring cannot move radially; only a deformable one can)"
       "\n"},
  });
}

// Sides that cannot touch or cannot wear must be reported by their contact.
TEST(Mistakes, Contacts) {
  expect_told({
      {"both sides on one body",
       "check",
       {{R"(primary = ["base_top"])", R"(primary = ["slider_top"])"}},
       "",
       2,
       R"(scene.toml:13: contact.pad.primary = "slider_top": lies on the same body as the secondary side ("slider"))"
       "\n"},
      {"sides that look away",
       "check",
       {{R"(primary = ["base_top"])", R"(primary = ["base_bottom"])"},
        {R"(edge = "base_bottom")", R"(edge = "base_top")"}},
       "",
       2,
       R"(scene.toml:11: contact.pad: no facet of the secondary side faces a primary one within search_mm = 1.5: they do not face each other; name boundaries that do)"
       "\n"},
      {"drawn too far apart",
       "check",
       {{R"(["blocks.geo"])", R"(["apart.geo"])"}, {R"(force_N_per_mm = -20.0)", R"(motion_mm = -0.5)"}},
       "",
       2,
       R"(scene.toml:11: contact.pad: no facet of the secondary side faces a primary one within search_mm = 0.4; the sides are 1 mm apart as drawn, and supports move these bodies by 0.5 mm at most: draw them closer, or move them farther)"
       "\n"},
      {"drawn apart, search too short",
       "check",
       {{R"(["blocks.geo"])", R"(["apart.geo"])"}, {R"(friction)", R"(search_mm = 0.2
friction)"}},
       "",
       2,
       R"(scene.toml:11: contact.pad: no facet of the secondary side faces a primary one within search_mm = 0.2; the sides are 1 mm apart as drawn: leave search_mm out)"
       "\n"},
      {"drawn half a body inside",
       "check",
       {{R"(["blocks.geo"])", R"(["inside.geo"])"}},
       "",
       2,
       R"(scene.toml:11: contact.pad: its sides overlap by 0.5 mm as drawn, at (1, -0.5) mm, of the 1 mm that body slider measures there: too deep for a fit; draw the bodies apart, or name the boundaries that touch)"
       "\n"},
      {"a gap that no motion closes",
       "run",
       {{R"(["blocks.geo"])", R"(["gap.geo"])"},
        {R"(force_N_per_mm = -20.0)", R"(motion_mm = -0.05)"},
        {R"(cycles = 20
jump = 10
)",
         R"(wear = false
)"},
        {R"([limit.life]
contact = "pad"
depth_mm = 1.0
)",
         R"()"}},
       "",
       0,
       R"(warning: scene.toml:11: gap, contact pad: Its sides are 0.1 mm apart as drawn, and supports move no body by more than 0.05 mm, nor does a force: they never touch. Draw them closer, or move them farther.)"
       "\n"
       R"(warning: scene.toml:11: never_closed, contact pad: No node of it ever carried a force; check gap, direction and size of what presses the sides together.)"
       "\n"},
      {"a corner as secondary side",
       "check",
       {{R"(["blocks.geo"])", R"(["tilted.geo"])"}, {R"(at_mm = [4.0, -0.5])", R"(at_mm = [2.0, -0.5])"}},
       "",
       2,
       R"(scene.toml:12: contact.pad.secondary = "slider_bottom": its corner at (0, 0) mm is what touches, and at a corner the direction of contact forces is undefined; swap primary and secondary)"
       "\n"},
      {"a rigid secondary side",
       "check",
       {{R"([body.slider]
material = "steel"
mesh = { far_size_mm = 0.25 })",
         R"([body.slider]
rigid = true)"}},
       "",
       2,
       R"(scene.toml:11: contact.pad.secondary = "slider_bottom": lies on the rigid body "slider"; the secondary side must belong to a deformable body)"
       "\n"},
  });
}

// Sides that cannot touch or cannot wear must be reported by their contact.
TEST(Mistakes, ContactsMore) {
  expect_told({
      {"a rigid side that wears",
       "check",
       {{R"([body.base]
material = "steel"
mesh = { far_size_mm = 0.25 })",
         R"([body.base]
rigid = true)"}},
       "",
       2,
       R"(scene.toml:14: contact.pad.wear: the primary side lies on the rigid body "base", which cannot wear)"
       "\n"},
      {"the same two edges in two contacts",
       "check",
       {},
       R"([contact.more]
secondary = "slider_bottom"
primary = ["base_top"]
)",
       2,
       R"(scene.toml:45: contact.more.primary = ["base_top"]: "base_top" meets "slider_bottom" in contact "pad" already)"
       "\n"},
      {"energy law without friction",
       "check",
       {{R"(friction = 0.3
)",
         R"()"}},
       "",
       2,
       R"(scene.toml:14: contact.pad.wear.law = "energy": without friction no energy is dissipated; use friction > 0 or archard)"
       "\n"},
      {"coefficients of the other law",
       "check",
       {{R"(wear = { law = "energy", secondary_mm3_per_J = 3e-5, primary_mm3_per_J = 2e-5 })",
         R"(wear = { law = "archard", secondary_mm3_per_J = 3e-5 })"}},
       "",
       2,
       R"(scene.toml:15: contact.pad.wear.secondary_mm3_per_J = 3e-5: belongs to law = "energy"; "archard" takes per_MPa)"
       "\n"
       R"(scene.toml:15: contact.pad.wear: needs secondary_per_MPa, primary_per_MPa or both)"
       "\n"},
      {"no coefficient",
       "check",
       {{R"(wear = { law = "energy", secondary_mm3_per_J = 3e-5, primary_mm3_per_J = 2e-5 })",
         R"(wear = { law = "energy" })"}},
       "",
       2,
       R"(scene.toml:15: contact.pad.wear: needs secondary_mm3_per_J, primary_mm3_per_J or both)"
       "\n"},
      {"a fine zone in the void",
       "check",
       {{R"(friction)", R"(fine_zone = { centre_mm = [9.0, 9.0], half_width_mm = 0.1, depth_mm = 0.1, size_mm = 0.05 }
friction)"}},
       "",
       2,
       R"(scene.toml:14: contact.pad.fine_zone.centre_mm = [9, 9]: no edge of a body passes through the fine zone)"
       "\n"},
      {"a fine zone of a thousand million nodes",
       "check",
       {{R"(friction)", R"(fine_zone = { centre_mm = [2.0, 0.0], half_width_mm = 1.0, depth_mm = 0.5, size_mm = 1e-5 }
friction)"}},
       "",
       2,
       R"(scene.toml:5: body.slider: would need about 1.00013e+10 nodes (at most 1e+06): raise the fine zone's size_mm or mesh.far_size_mm)"
       "\n"
       R"(scene.toml:8: body.base: would need about 1.00013e+10 nodes (at most 1e+06): raise the fine zone's size_mm or mesh.far_size_mm)"
       "\n"},
  });
}

// A body that is worn away must be named with what is gone of it.
TEST(Mistakes, WornAway) {
  expect_told({
      {"a body worn away",
       "run",
       {{R"(friction = 0.3
)",
         R"(imposed_sliding_mm = 1000.0
)"},
        {R"(wear = { law = "energy", secondary_mm3_per_J = 3e-5, primary_mm3_per_J = 2e-5 })",
         R"(wear = { law = "archard", secondary_per_MPa = 1e-5 })"},
        {R"(cycles = 20
jump = 10)",
         R"(cycles = 50)"},
        {R"(depth_mm = 1.0)", R"(depth_mm = 2.0)"}},
       "",
       1,
       R"(reye: scene.toml:32: body slider is worn by 0.6 mm of the 1 mm that it measured at cycle 0, 0.4 mm are left (cycle 6); end the run before with a limit with stop = true, or check the wear coefficients)"
       "\n"},
  });
}

// Wear that waits in the gap beyond the search must be named as the cause, with the key that leaves it there.
TEST(Mistakes, WaitingWear) {
  expect_told({
      {"wear that stays in the gap",
       "run",
       {{R"(geometry)", R"(shape = "off"
geometry)"},
        {R"(friction = 0.3
)",
         R"(imposed_sliding_mm = 1000.0
)"},
        {R"(wear = { law = "energy", secondary_mm3_per_J = 3e-5, primary_mm3_per_J = 2e-5 })",
         R"(wear = { law = "archard", secondary_per_MPa = 1e-5 })"},
        {R"(cycles = 20
jump = 10)",
         R"(cycles = 50)"},
        {R"(depth_mm = 1.0)", R"(depth_mm = 2.0)"}},
       "",
       1,
       R"(reye: scene.toml:33: step "wear", cycle 3, progress 0.9995 to 1: wear of 0.4 mm waits in the gap of contact pad, as shape = "off" asks, and facets are paired no farther than search_mm = 0.4; write shape = "on", or a longer search_mm)"
       "\n"},
  });
}

// A run that fails must say what led there, in its last line, and what to change.
TEST(Mistakes, Failures) {
  expect_told({
      {"a jump that is too long",
       "run",
       {{R"(secondary_mm3_per_J = 3e-5)", R"(secondary_mm3_per_J = 0.9)"},
        {R"(force_N_per_mm = -20.0)", R"(force_N_per_mm = -200.0)"},
        {R"(cycles = 20
jump = 10)",
         R"(cycles = 500
jump = 500)"}},
       "",
       0,
       R"(warning: scene.toml:32: jump, step wear: A block of 125 cycles failed at cycle 375; from there on blocks have 31 (the log says why). Write jump = 31, or jump = { tolerance = 0.01 }.)"
       "\n"},
      {"small strain for a squeezed block",
       "run",
       {{R"(force_N_per_mm = -20.0)", R"(motion_mm = -0.6)"}, {R"(motion_mm = 0.01)", R"(motion_mm = 0.0)"}},
       "",
       1,
       R"(reye: scene.toml:5: strain and rotation reach 39 % where body slider stores its energy: the error of small strain in that is about 79 %; write kinematics = "finite", and check loads, motions and E_MPa)"
       "\n"},
  });
}

// A body that is driven through the other must be named with its strain.
TEST(Mistakes, DrivenThrough) {
  expect_told({
      {"a body driven through the other",
       "run",
       {{R"([body.slider])", R"([body.slider]
kinematics = "finite")"},
        {R"([body.base])", R"([body.base]
kinematics = "finite")"},
        {R"(nu = 0.3)", R"(nu = 0.3
law = "hencky")"},
        {R"(force_N_per_mm = -20.0)", R"(motion_mm = -1.8)"}},
       R"([solver]
max_cutbacks = 3
)",
       1,
       R"(reye: scene.toml:31: step "press", cycle 0, progress 0.5 to 0.625: body slider is strained by 51 % on average already: more than it can bear; check loads, motions and E_MPa)"
       "\n"},
  });
}

// What the files do not hold must be reported with what they do hold.
TEST(Mistakes, Files) {
  expect_told({
      {"a file that is not there",
       "check",
       {{R"(["blocks.geo"])", R"(["block.geo"])"}},
       "",
       2,
       R"(scene.toml:1: geometry = "block.geo": no such file)"
       "\n"},
      {"a key misspelt",
       "check",
       {{R"(friction =)", R"(frictoin =)"}},
       "",
       2,
       R"(scene.toml:14: contact.pad.frictoin = 0.3: unknown key; did you mean friction?)"
       "\n"
       R"(scene.toml:15: contact.pad.wear.law = "energy": without friction no energy is dissipated; use friction > 0 or archard)"
       "\n"},
      {"a quote left out",
       "check",
       {{R"(edge = "slider_top")", R"(edge = "slider_top)"}},
       "",
       2,
       R"(scene.toml:17: is not TOML: a text lacks its closing quotation mark)"
       "\n"},
      {"a material that is not there",
       "check",
       {{R"(material = "steel")", R"(material = "stel")"}},
       "",
       2,
       R"(scene.toml:6: body.slider.material = "stel": there is no material "stel"; did you mean "steel"?)"
       "\n"},
      {"a body that is not there",
       "check",
       {{R"([body.slider])", R"([body.slidr])"}},
       "",
       2,
       R"(scene.toml:5: body.slidr: has neither 'at' nor 'name', and its own name is that of no face; there are: 'slider' in [1, 0, 3, 1], 'base' in [0, -1, 4, 0])"
       "\n"},
      {"an edge of two bodies",
       "check",
       {{R"(primary = ["base_top"])", R"(primary = ["left"])"}},
       "",
       2,
       R"(scene.toml:13: contact.pad.primary = "left": more than one body has a boundary of this name; write body.name)"
       "\n"},
      {"a box around no edge",
       "check",
       {},
       R"([boundary]
none = { body = "base", box_mm = [7, 7, 8, 8] }
)",
       2,
       R"(scene.toml:44: boundary.none.box_mm = [7, 7, 8, 8]: matches no edge of body 'base', which has: line [0, -1] to [4, -1], line [4, -1] to [4, 0], line [4, 0] to [0, 0], line [0, 0] to [0, -1])"
       "\n"},
      {"a negative radius",
       "check",
       {{R"(geometry)", R"(analysis = "axisymmetric"
geometry)"},
        {R"(["blocks.geo"])", R"(["left.geo"])"},
        {R"(force_N_per_mm)", R"(force_N)"},
        {R"(at_mm = [4.0, -0.5])", R"(at_mm = [3.0, -0.5])"}},
       "",
       2,
       R"(scene.toml:9: body.base: lies on both sides of the axis and is not mirror-symmetric about it: it reaches from x = -1 to 3, has 1 mm^2 at x < 0 and 3 mm^2 at x > 0, and its outline at [3, -1] lies 2 mm from the mirrored other half; draw it symmetric about x = 0, or its half x >= 0 alone)"
       "\n"},
  });
}

// What the files do not hold must be reported with what they do hold.
TEST(Mistakes, FilesMore) {
  expect_told({
      {"triangles that lock",
       "check",
       {{R"(nu = 0.3)", R"(nu = 0.49)"},
        {R"(mesh = { far_size_mm = 0.25 })", R"(mesh = { far_size_mm = 0.25, element = "tri" })"}},
       "",
       0,
       R"(warning: scene.toml:6: body.slider.material = "steel": triangles of order 1 lock where the material is (nearly) incompressible, as nu > 0.45 does; take quads or order = 2)"
       "\n"},
  });
}
