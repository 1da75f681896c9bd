#include <gtest/gtest.h>

#include "example.hpp"
#include "folder.hpp"
#include "scene/read.hpp"

using namespace reye;

namespace {

/// The example with one text replaced.
scene::Scene changed(const std::string& from, const std::string& to) {
  const test::Folder folder;
  test::Folder::write("scene.toml", test::replaced(test::example, from, to));
  test::Folder::write("cylinder_on_flat.step", "ISO-10303-21;");
  return scene::read("scene.toml");
}

scene::Scene with(const std::string& more) { return changed("[history] ", more + "\n[history] "); }

const std::string law =
    R"(wear      = { law = "energy", secondary_mm3_per_J = 3.222e-5, primary_mm3_per_J = 2.111e-5 })";

}  // namespace

/// Archard's coefficients are consistent already; with an imposed sliding friction may be absent.
TEST(Grammar, Archard) {
  const auto s =
      changed("friction  = 0.9\n" + law,
              "imposed_sliding_mm = 1000.0\nimplicit = false\nsearch_mm = 0.5\nc_normal = 2.0\n"
              "c_tangential = 3\ndual = \"linear\"\nwear = { law = \"archard\", secondary_per_MPa = 2.9e-8 }");
  const auto& contact = s.contacts.at(0);
  EXPECT_EQ(contact.wear.kind, wear::LawKind::archard);
  EXPECT_EQ(contact.wear.secondary, 2.9e-8);
  EXPECT_EQ(contact.wear.primary, 0.0);
  EXPECT_EQ(contact.friction, 0.0);
  EXPECT_TRUE(contact.imposed);
  EXPECT_EQ(contact.imposed_sliding.at(0).value, 1000.0);
  EXPECT_FALSE(contact.implicit_wear);
  EXPECT_EQ(contact.search_mm, 0.5);
  EXPECT_EQ(contact.c_normal, 2.0);
  EXPECT_EQ(contact.c_tangential, 3.0);
}

/// Imposed sliding is a number, or parts that may follow histories.
TEST(Grammar, SlidingInParts) {
  const auto pad =
      changed(law, "imposed_sliding_mm = [{ value = 30.0, history = \"stroke\" }, { value = -2.0 }]\n" + law)
          .contacts.at(0);
  EXPECT_TRUE(pad.imposed && !pad.out_of_plane);
  ASSERT_EQ(pad.imposed_sliding.size(), 2U);
  EXPECT_EQ(pad.imposed_sliding[0].value, 30.0);
  EXPECT_EQ(pad.imposed_sliding[0].history, "stroke");
  EXPECT_EQ(pad.imposed_sliding[1].value, -2.0);
  EXPECT_TRUE(pad.imposed_sliding[1].history.empty());
}

/// A spring leaves a motion to the equations; a far end that moves is a force, its stiffness times the way.
TEST(Grammar, Springs) {
  const auto s = with(
      "[support.mount]\nedge = \"left\"\nx = { spring_N_per_mm2 = 100.0 }\n"
      "y = [{ spring_N_per_mm2 = 50.0, motion_mm = 0.5, history = \"press\" }, { force_N_per_mm = 3.0 }]\n"
      "rotation = { spring_N_mm_per_mm = 7.0, moment_N_mm_per_mm = 2.0 }\n");
  const auto& mount = s.supports.at(2);
  EXPECT_TRUE(mount.rigid);
  EXPECT_EQ(mount.x.drive, body::Drive::loaded);
  EXPECT_EQ(mount.x.stiffness, 100.0);
  EXPECT_TRUE(mount.x.parts.empty());
  EXPECT_EQ(mount.y.stiffness, 50.0);
  ASSERT_EQ(mount.y.parts.size(), 2U);
  EXPECT_EQ(mount.y.parts[0].value, 25.0);
  EXPECT_EQ(mount.y.parts[0].history, "press");
  EXPECT_EQ(mount.y.parts[1].value, 3.0);
  EXPECT_EQ(mount.rotation.stiffness, 7.0);
  EXPECT_EQ(mount.rotation.parts.at(0).value, 2.0);
}

/// Sliding out of the plane is a length, or in axisymmetry an angle about the axis.
TEST(Grammar, SlidingOutOfThePlane) {
  const auto length = changed(law, "imposed_out_of_plane_mm = 20.0\n" + law).contacts.at(0);
  EXPECT_TRUE(length.imposed && length.out_of_plane);
  EXPECT_EQ(length.imposed_sliding.at(0).value, 20.0);
  EXPECT_TRUE(length.imposed_turn.empty());
  EXPECT_FALSE(changed(law, "imposed_sliding_mm = 20.0\n" + law).contacts.at(0).out_of_plane);
}

/// Exponents with their references, threshold and period reach the law as written; without them the law is plain.
TEST(Grammar, WearRate) {
  const test::Folder folder;
  auto text = test::replaced(test::example, "primary_mm3_per_J = 2.111e-5",
                             "primary_mm3_per_J = 2.111e-5, pressure_exponent = 0.5, pressure_ref_MPa = 100, "
                             "speed_exponent = -0.25, speed_ref_mm_per_s = 10, threshold_mJ_per_mm2 = 20");
  text = test::replaced(text, "cycles = 18000", "period_s = 0.05\ncycles = 18000");
  test::Folder::write("scene.toml", text);
  test::Folder::write("cylinder_on_flat.step", "ISO-10303-21;");
  const auto s = scene::read("scene.toml");
  const auto& law = s.contacts.at(0).wear;
  EXPECT_EQ(law.pressure_exponent, 0.5);
  EXPECT_EQ(law.pressure_ref, 100.0);
  EXPECT_EQ(law.speed_exponent, -0.25);
  EXPECT_EQ(law.speed_ref, 10.0);
  EXPECT_EQ(law.threshold, 20.0);
  EXPECT_EQ(s.steps[2].period_s, 0.05);
  const auto plain = changed("nu    = 0.3", "nu = 0.3").contacts.at(0).wear;
  EXPECT_EQ(plain.pressure_exponent, 0.0);
  EXPECT_EQ(plain.speed_exponent, 0.0);
  EXPECT_EQ(plain.threshold, 0.0);
}

/// Friction over cycles is a table; its largest value stands for the contact.
TEST(Grammar, FrictionOverCycles) {
  const auto s = changed("friction  = 0.9", "friction = { cycles = [0, 1000, 5000], value = [0.3, 0.9, 0.6] }");
  EXPECT_EQ(s.contacts[0].friction, 0.9);
  EXPECT_EQ(s.contacts[0].friction_over_cycles, (scene::History{{0, 0.3}, {1000, 0.9}, {5000, 0.6}}));
  EXPECT_TRUE(changed("friction  = 0.9", "friction = 0.9").contacts[0].friction_over_cycles.empty());
}

/// A history that turns a body by whole turns, and moves nothing else, may end a cycle elsewhere than it began.
TEST(Grammar, WholeTurnsAreClosedCycles) {
  const auto turned = [](const std::string& motion) {
    auto text = test::replaced(test::example, "[[0.0, 0.0], [0.25, 1.0], [0.75, -1.0], [1.0, 0.0]]",
                               "[[0.0, 0.0], [1.0, 1.0]]");
    text = test::replaced(text, "rotation = \"fixed\"\nx        = { motion_mm = 0.025, history = \"stroke\" }", motion);
    const test::Folder folder;
    test::Folder::write("scene.toml", text);
    test::Folder::write("cylinder_on_flat.step", "ISO-10303-21;");
    return scene::read("scene.toml");
  };
  EXPECT_NO_THROW(turned("rotation = { motion_rad = 12.5663706, history = \"stroke\" }"));
  EXPECT_THROW(turned("rotation = { motion_rad = 6.0, history = \"stroke\" }"), base::InputError);
  EXPECT_THROW(turned("rotation = { motion_rad = 12.5663706, history = \"stroke\" }\nx = { motion_mm = 0.1, history = "
                      "\"stroke\" }"),
               base::InputError);
}

/// A point, an edge's own axes and turned axes.
TEST(Grammar, Supports) {
  const auto s = with(
      "[support.pin]\npoint_mm = [3.0, 6.0]\nbody = \"cylinder\"\nx = \"fixed\"\n"
      "[support.roller]\nedge = \"left\"\nnormal = { motion_mm = 0.1 }\ntangent = \"free\"\n"
      "[support.wedge]\nedge = \"right\"\nangle_deg = 30.0\nx = \"fixed\"\n"
      "[support.crank]\nedge = \"arm\"\nrotation = { moment_N_mm_per_mm = 4.0, history = \"press\" }\n");
  ASSERT_EQ(s.supports.size(), 6U);
  const auto &pin = s.supports[2], &roller = s.supports[3], &wedge = s.supports[4], &crank = s.supports[5];
  EXPECT_EQ(*pin.point_mm, base::Vec2(3.0, 6.0));
  EXPECT_EQ(pin.body, "cylinder");
  EXPECT_FALSE(pin.rigid || roller.rigid || wedge.rigid);
  EXPECT_EQ(pin.y.drive, body::Drive::free);
  EXPECT_TRUE(roller.edge_axes);
  EXPECT_EQ(roller.y.drive, body::Drive::moved);
  EXPECT_EQ(roller.y.parts.at(0).value, 0.1);
  EXPECT_TRUE(roller.y.parts.at(0).history.empty());
  EXPECT_EQ(wedge.angle_deg, 30.0);
  EXPECT_TRUE(crank.rigid);
  EXPECT_EQ(crank.rotation.drive, body::Drive::loaded);
  EXPECT_EQ(crank.rotation.parts.at(0).value, 4.0);
}

/// A component may be a list of parts, each with its own value and history; a table alone is a list of one.
TEST(Grammar, PartsOfASum) {
  const auto s = with(
      "[support.crank]\nedge = \"arm\"\nrotation = [{ motion_rad = 6.28, history = \"press\" }, { motion_rad = 0.1, "
      "history = \"stroke\" }]\n"
      "[load.both]\nedge = \"top\"\nparts = [{ pressure_MPa = 5.0, history = \"press\" }, { traction_MPa = [1, 2] }]\n"
      "[load.tip]\npoint_mm = [1.0, 2.0]\n"
      "[[load.tip.parts]]\nforce_N_per_mm = [3.0, 4.0]\n[[load.tip.parts]]\nforce_N_per_mm = [0.5, 0.0]\nhistory = "
      "\"stroke\"\n"
      "[load.weight]\nbody = \"flat\"\nparts = [{ force_N_per_mm3 = [0, -1] }, { force_N_per_mm3 = [2, 0], history = "
      "\"stroke\" }]\n");
  const auto& turn = s.supports.at(2).rotation;
  EXPECT_EQ(turn.drive, body::Drive::moved);
  ASSERT_EQ(turn.parts.size(), 2U);
  EXPECT_EQ(turn.parts[0].value, 6.28);
  EXPECT_EQ(turn.parts[1].value, 0.1);
  EXPECT_EQ(turn.parts[0].history, "press");
  EXPECT_EQ(turn.parts[1].history, "stroke");
  ASSERT_EQ(s.boundary_loads.size(), 2U);
  EXPECT_EQ(s.boundary_loads[0].pressure_MPa, 5.0);
  EXPECT_EQ(s.boundary_loads[0].history, "press");
  EXPECT_EQ(s.boundary_loads[1].pressure_MPa, 0.0);
  EXPECT_EQ(s.boundary_loads[1].traction_MPa, base::Vec2(1.0, 2.0));
  ASSERT_EQ(s.point_loads.size(), 2U);
  EXPECT_EQ(s.point_loads[1].force_N_per_mm, base::Vec2(0.5, 0.0));
  EXPECT_EQ(s.point_loads[1].point_mm, base::Vec2(1.0, 2.0));
  ASSERT_EQ(s.body_forces.size(), 2U);
  EXPECT_EQ(s.body_forces[1].history, "stroke");
  EXPECT_EQ(s.supports[0].y.parts.size(), 1U);
}

/// The keys of a load decide its kind.
TEST(Grammar, Loads) {
  const auto s = with(
      "[load.top]\nedge = \"top\"\npressure_MPa = 10.0\ntraction_MPa = [1, -2]\ninterval_mm = [0.0, 3.0]\n"
      "history = \"press\"\n"
      "[load.tip]\npoint_mm = [1.0, 2.0]\nforce_N_per_mm = [3.0, 4.0]\n"
      "[load.weight]\nbody = \"flat\"\nforce_N_per_mm3 = [0, -7.7e-5]\n");
  ASSERT_EQ(s.boundary_loads.size(), 1U);
  EXPECT_EQ(s.boundary_loads[0].pressure_MPa, 10.0);
  EXPECT_EQ(s.boundary_loads[0].traction_MPa, base::Vec2(1.0, -2.0));
  EXPECT_EQ(*s.boundary_loads[0].interval_mm, (std::array{0.0, 3.0}));
  EXPECT_EQ(s.boundary_loads[0].history, "press");
  ASSERT_EQ(s.point_loads.size(), 1U);
  EXPECT_EQ(s.point_loads[0].force_N_per_mm, base::Vec2(3.0, 4.0));
  EXPECT_TRUE(s.point_loads[0].body.empty());
  ASSERT_EQ(s.body_forces.size(), 1U);
  EXPECT_EQ(s.body_forces[0].body, "flat");
  EXPECT_EQ(s.body_forces[0].force_N_per_mm3, base::Vec2(0.0, -7.7e-5));
}

/// Dotted keys at the end of the file, as one writes them by hand.
TEST(Grammar, OneLiners) {
  const auto s = changed("[material.steel]",
                         "shape = \"off\"\nsolver = { max_newton = 50, max_cutbacks = 0 }\n"
                         "body.ring.rigid = true\nbody.ring.name = \"ring/1\"\n"
                         "body.ring.mesh = { element = \"tri\", growth = 2 }\n[material.steel]");
  EXPECT_FALSE(s.shape);
  EXPECT_EQ(s.max_newton, 50);
  EXPECT_EQ(s.max_cutbacks, 0);
  ASSERT_EQ(s.geometry.bodies.size(), 3U);
  const auto& ring = s.geometry.bodies[0];
  EXPECT_TRUE(ring.rigid);
  EXPECT_EQ(*ring.label, "ring/1");
  EXPECT_EQ(ring.mesh.element, mesh::CellKind::tri3);
  EXPECT_TRUE(s.body_material.at("ring").material.empty());
}

/// A section and a profile reach the geometry stage as numbers.
TEST(Grammar, SectionAndProfile) {
  const test::Folder folder;
  std::filesystem::create_directory("scans");
  test::Folder::write("scans/a.csv", "arc_length_mm,height_mm\n0,0\n1,0.25\n2,0\n");
  test::Folder::write("cylinder_on_flat.step", "ISO-10303-21;");
  const auto text = test::replaced(test::example, R"(type = "circle")", R"(type = "circle", profile = "scans/a.csv")");
  test::Folder::write("scene.toml",
                      test::replaced(text, "[material.steel]",
                                     "section = { point_mm = [1, 2, 3], normal = [0, 0.5, -2] }\n[material.steel]"));
  const auto s = scene::read("scene.toml");
  ASSERT_TRUE(s.geometry.section);
  EXPECT_EQ(s.geometry.section->point_mm, cad::Vec3(1, 2, 3));
  EXPECT_EQ(s.geometry.section->normal, cad::Vec3(0, 0.5, -2));
  const auto& profile = s.geometry.boundaries[1].profile;
  ASSERT_TRUE(profile);
  EXPECT_EQ(profile->file, "scans/a.csv");
  EXPECT_EQ(profile->arc_mm, (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(profile->height_mm, (std::vector<double>{0, 0.25, 0}));
  EXPECT_FALSE(s.geometry.boundaries[0].profile);
}

/// An axisymmetric scene has forces on the whole ring and worn volumes.
TEST(Grammar, Axisymmetric) {
  const test::Folder folder;
  test::Folder::write("ring.geo", "Point(1) = {0, 0, 0};");
  test::Folder::write(
      "ring.toml",
      "analysis = \"axisymmetric\"\ngeometry = [\"ring.geo\"]\n"
      "[material.m]\nE_MPa = 1\nnu = 0\n[body.b]\nmaterial = \"m\"\nb_bar = false\nkinematics = \"small\"\norder = 1\n"
      "[support.s]\nedge = \"top\"\ny = { force_N = 5 }\n"
      "[load.l]\npoint_mm = [1, 1]\nforce_N = [0, 1]\n"
      "[contact.c]\nsecondary = \"a\"\nprimary = [\"b\"]\nfine_zone = { centre_mm = [0, 0], half_width_mm = 1, "
      "depth_mm = 1, size_mm = 0.1, angle_deg = 45 }\n"
      "[limit.v]\ncontact = \"c\"\nside = \"sum\"\nvolume_mm3 = 2\nstop = true\n[[step]]\nwear = false\ncycles = "
      "5\njump = 10\n");
  const auto s = scene::read("ring.toml");
  EXPECT_EQ(s.name, "ring");
  EXPECT_EQ(s.title, "ring");
  EXPECT_TRUE(s.geometry.axisymmetric);
  EXPECT_EQ(s.body_material.at("b").b_bar, false);
  EXPECT_EQ(s.supports[0].y.parts.at(0).value, 5.0);
  EXPECT_EQ(s.point_loads[0].force_N_per_mm, base::Vec2(0.0, 1.0));
  EXPECT_EQ(*s.limits[0].area_mm2, 2.0);
  EXPECT_TRUE(s.limits[0].stop);
  EXPECT_EQ(s.steps[0].name, "step 1");
  EXPECT_EQ(s.steps[0].jump, 10.0);
  EXPECT_TRUE(s.geometry.fine_zones[0].bodies.empty()) << "edges of the geometry file may belong to any body";
  EXPECT_EQ(s.geometry.fine_zones[0].angle_deg, 45.0);
}

/// A contact that touches in two places takes a list of fine zones, in either form that TOML has; a table by itself is
/// a list of one.
TEST(Grammar, SeveralFineZones) {
  const std::string one =
      "fine_zone = { centre_mm = [0.0, 0.0], half_width_mm = 0.5, depth_mm = 0.2, size_mm = 0.010 }";
  const std::string headed =
      "[[contact.pad.fine_zone]]\ncentre_mm = [1, 2]\nhalf_width_mm = 1\ndepth_mm = 1\nsize_mm = 0.01\n";
  const auto list =
      changed(one,
              "fine_zone = [{ centre_mm = [1, 2], half_width_mm = 0.6, depth_mm = 0.4, size_mm = 0.01 }, "
              "{ centre_mm = [3, 4], half_width_mm = 0.5, depth_mm = 0.3, size_mm = 0.02, angle_deg = 9 }]");
  for (const auto& scene : {list, changed(one, headed + headed)}) {
    const auto& zones = scene.geometry.fine_zones;
    ASSERT_EQ(zones.size(), 2U);
    EXPECT_EQ(zones[0].key, "contact.pad.fine_zone[0]");
    EXPECT_EQ(zones[1].key, "contact.pad.fine_zone[1]");
    EXPECT_EQ(zones[0].centre_mm, base::Vec2(1.0, 2.0));
    for (const auto& zone : zones) {
      EXPECT_EQ(zone.contact, "pad");
      EXPECT_EQ(zone.bodies, (std::vector<std::string>{"flat", "cylinder"}));
    }
  }
  EXPECT_EQ(list.geometry.fine_zones[1].angle_deg, 9.0);
  EXPECT_EQ(changed(one, one).geometry.fine_zones.at(0).key, "contact.pad.fine_zone");
}

/// A jump is a number of cycles, or a tolerance with a first guess of a thousandth of the step.
TEST(Grammar, JumpUnderControl) {
  const auto read = [](const std::string& jump) { return changed("jump = 100 ", "jump = " + jump + " ").steps.back(); };
  const auto fixed = read("10"), controlled = read("{ tolerance = 0.01 }"),
             given = read("{ tolerance = 0.02, first = 7, most = 90 }");
  EXPECT_EQ(fixed.jump_tolerance, 0.0);
  EXPECT_EQ(controlled.jump_tolerance, 0.01);
  EXPECT_EQ(controlled.jump, 18.0);
  EXPECT_EQ(controlled.jump_most, std::numeric_limits<double>::infinity());
  EXPECT_EQ(given.jump, 7.0);
  EXPECT_EQ(given.jump_most, 90.0);
}

/// With an accuracy a fine zone may leave out its size, a step that wears its jump, which half of it controls then, and
/// the mesh's error is estimated; what the scene says stays, load steps and steps that do not wear have no tolerance.
TEST(Grammar, Accuracy) {
  const auto none = changed("jump = 100 ", ""),
             sized = changed("[material.steel]", "accuracy = 0.02\n[material.steel]");
  EXPECT_EQ(none.accuracy, 0.0);
  EXPECT_EQ(none.steps[2].jump_tolerance, 0.0);
  EXPECT_EQ(none.steps[2].jump, 1.0);
  EXPECT_FALSE(none.output.estimate_error);
  EXPECT_EQ(sized.accuracy, 0.02);
  EXPECT_EQ(sized.geometry.fine_zones[0].size_mm, 0.010);
  EXPECT_EQ(sized.steps[2].jump_tolerance, 0.0);
  EXPECT_EQ(sized.steps[2].jump, 100.0);
  EXPECT_TRUE(sized.output.estimate_error);

  const test::Folder folder;
  auto text = test::replaced(test::example, ", size_mm = 0.010", "");
  text = test::replaced(text, "jump = 100 ", "[[step]]\nplay = [\"stroke\"]\ncycles = 5\nwear = false\n");
  text = test::replaced(text, "[output]", "[output]\nestimate_error = false");
  test::Folder::write("scene.toml", "accuracy = 0.2\n" + text);
  test::Folder::write("cylinder_on_flat.step", "ISO-10303-21;");
  const auto left = scene::read("scene.toml");
  EXPECT_EQ(left.geometry.fine_zones[0].size_mm, 0.0);
  EXPECT_EQ(left.steps[2].jump_tolerance, 0.1);
  EXPECT_EQ(left.steps[2].jump, 18.0);
  for (int k : {0, 1, 3}) EXPECT_EQ(left.steps.at(k).jump_tolerance, 0.0) << k;
  EXPECT_EQ(left.steps[3].jump, 1.0);
  EXPECT_FALSE(left.output.estimate_error);
}

/// The steps of a spectrum are played in their order, as often as it says, between what stands before and after them.
TEST(Grammar, Spectrum) {
  const auto s = with("[spectrum]\nsteps = [\"run in without wear\", \"wear\"]\ntimes = 3\n");
  std::vector<std::string> names;
  for (const auto& step : s.steps) names.push_back(step.name);
  EXPECT_EQ(names, (std::vector<std::string>{"press", "run in without wear", "wear", "run in without wear", "wear",
                                             "run in without wear", "wear"}));
}

/// Every law with the parameters it takes.
TEST(Grammar, Materials) {
  const auto s = changed("[body.cylinder]", R"(
[material.rubber]
law = "neo_hookean"
E_MPa = 5
nu = 0.45
volumetric = "power"
[material.kirchhoff]
law = "st_venant_kirchhoff"
E_MPa = 6
nu = 0.1
[material.log]
law = "hencky"
E_MPa = 7
nu = 0.2
[material.linear]
law = "hencky_j2"
E_MPa = 8
nu = 0.3
hardening = { law = "linear", yield_MPa = 2 }
[material.voce]
law = "hencky_j2"
E_MPa = 8
nu = 0.3
hardening = { law = "voce", yield_MPa = 2, saturation_MPa = 3, rate = 4, modulus_MPa = 5 }
[material.swift]
law = "hencky_j2"
E_MPa = 8
nu = 0.3
hardening = { law = "swift", strength_MPa = 2, offset = 0.01, exponent = 0.2 }
[material.table]
law = "hencky_j2"
E_MPa = 8
nu = 0.3
hardening = { law = "table", points = [[0, 1], [0.1, 2], [0.4, 2.5]] }
[body.cylinder]
kinematics = "small")");
  const auto& m = s.materials;
  EXPECT_EQ(std::get<material::NeoHookean>(m.at("rubber")).volumetric, material::Volumetric::power);
  EXPECT_EQ(std::get<material::StVenantKirchhoff>(m.at("kirchhoff")).nu, 0.1);
  EXPECT_EQ(std::get<material::Hencky>(m.at("log")).E_MPa, 7.0);
  const auto hardening = [&](const char* name) { return std::get<material::HenckyJ2>(m.at(name)).hardening; };
  EXPECT_EQ(std::get<material::LinearHardening>(hardening("linear")).yield_MPa, 2.0);
  EXPECT_EQ(std::get<material::LinearHardening>(hardening("linear")).modulus_MPa, 0.0);
  EXPECT_EQ(std::get<material::VoceHardening>(hardening("voce")).rate, 4.0);
  EXPECT_EQ(std::get<material::SwiftHardening>(hardening("swift")).exponent, 0.2);
  EXPECT_EQ(std::get<material::TableHardening>(hardening("table")).points.at(2), (std::array{0.4, 2.5}));
  EXPECT_EQ(s.body_material.at("cylinder").kinematics, base::Kinematics::small);
}

/// Elements that lock with their material are warned of by name.
TEST(Grammar, Locking) {
  const auto s = changed("nu    = 0.3", "nu = 0.49");
  EXPECT_TRUE(s.warnings.empty());
  const auto locking = changed("[boundary]", "b_bar = false\n[material.soft]\nE_MPa = 1\nnu = 0.49\n[boundary]");
  EXPECT_TRUE(locking.warnings.empty()) << "steel has nu = 0.3";
}

/// What is odd but no error is a warning with its line.
TEST(Grammar, Warnings) {
  const auto s = changed("press  = [[", "idle = [[0, 0], [1, 1]]\npress  = [[");
  EXPECT_EQ(s.warnings,
            (std::vector<std::string>{"scene.toml:46: history.idle: no step plays it; its factor stays 0",
                                      "scene.toml:46: history.idle: no support, load or imposed sliding names it"}));
}
