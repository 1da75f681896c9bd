#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "sim/study/run.hpp"
#include "support/problem.hpp"
#include "verification/contact_scene.hpp"

using namespace reye;
using verification::number;

/// Interference that is drawn, several elements deep, against closed forms.
namespace {

constexpr double E_hub = 100e3, nu_hub = 0.3, E_shaft = 200e3, nu_shaft = 0.25;
constexpr double bore = 1.0, outside = 2.0, overlap = 0.05;  // mm

struct Fit {
  sim::Problem problem;
  sim::State state;
  sim::Summary summary;
  std::vector<double> pressure;

  double mean() const {
    return std::accumulate(pressure.begin(), pressure.end(), 0.0) / static_cast<double>(pressure.size());
  }
};

Fit fit(const std::string& geo, const std::string& scene) {
  Fit f;
  f.problem = support::problem_from(
      {{"fit.geo", "SetFactory(\"OpenCASCADE\");\n" + geo}, {"scene.toml", "geometry = [\"fit.geo\"]\n" + scene}});
  f.state = sim::initial_state(f.problem);
  sim::Observer watch;
  watch.frame = [&](const sim::Frame& frame) { f.pressure = frame.surfaces.at(0).pressure_MPa; };
  f.summary = sim::run(f.problem, f.state, watch);
  EXPECT_EQ(f.summary.status, sim::RunStatus::done) << f.summary.reason;
  return f;
}

/// Lame in plane strain: displacement of the bore over its radius and the pressure in it.
double ring_compliance() {
  return (1.0 + nu_hub) / E_hub * (bore * bore * (1.0 - 2.0 * nu_hub) + outside * outside) /
         (outside * outside - bore * bore);
}

/// Largest deviation of the pressure of a fit from Lame's, relative: ring of bore 1 and radius 2 on a shaft that is
/// 0.05 larger.
double lame_error(double size, int order) {
  constexpr double height = 0.2;
  const std::string body = "\nmesh = { far_size_mm = " + number(size) + " }\norder = " + number(order).substr(0, 1) +
                           "\nkinematics = \"small\"\n";
  const auto f =
      fit("Rectangle(1) = {0, 0, 0, " + number(bore + overlap) + ", " + number(height) +
              "};\n"
              "Rectangle(2) = {" +
              number(bore) + ", 0, 0, " + number(outside - bore) + ", " + number(height) +
              "};\n"
              "Physical Surface(\"shaft\") = {1};\nPhysical Surface(\"hub\") = {2};\n"
              "Physical Curve(\"seat\") = {2};\nPhysical Curve(\"bore\") = {8};\n"
              "Physical Curve(\"shaft_ends\") = {1, 3};\nPhysical Curve(\"hub_ends\") = {5, 7};\n",
          "analysis = \"axisymmetric\"\n[material.a]\nE_MPa = " + number(E_shaft) + "\nnu = " + number(nu_shaft) +
              "\n[material.b]\nE_MPa = " + number(E_hub) + "\nnu = " + number(nu_hub) +
              "\n[body.shaft]\nmaterial = \"a\"" + body + "[body.hub]\nmaterial = \"b\"" + body +
              "[contact.fit]\nsecondary = \"bore\"\nprimary = [\"seat\"]\n"
              "[support.a]\nedge = \"shaft_ends\"\ny = \"fixed\"\n[support.b]\nedge = \"hub_ends\"\ny = \"fixed\"\n"
              "[[step]]\nname = \"fit\"\nincrements = 2\n");
  EXPECT_TRUE(f.problem.contacts[0].drawn.let_in);
  EXPECT_NEAR(f.problem.contacts[0].drawn.overlap_mm, overlap, 1e-9);
  const double shaft = (1.0 + nu_shaft) * (1.0 - 2.0 * nu_shaft) / E_shaft;
  return verification::worst(f.pressure, overlap / (bore * (ring_compliance() + shaft)));
}

}  // namespace

// A ring on a shaft, both elastic and held between plates, must carry Lame's pressure: second order in the element size
// on facets of first order, and better on those of second.
TEST(PressFit, Lame) {
  const double coarse = lame_error(0.04, 1), fine = lame_error(0.02, 1);
  RecordProperty("coarse", std::to_string(coarse));
  RecordProperty("fine", std::to_string(fine));
  EXPECT_LT(fine, 5e-4);
  EXPECT_GT(coarse / fine, 3.0);
  const double second = lame_error(0.04, 2);
  RecordProperty("second", std::to_string(second));
  EXPECT_LT(second, 1e-5);
}

// Two columns drawn four elements into one another must be compressed uniformly, to round-off: p = E / (1 - nu^2) depth
// / height.
TEST(PressFit, Columns) {
  const auto f =
      fit("Rectangle(1) = {0, 0, 0, 1, 1};\nRectangle(2) = {0, 0.8, 0, 1, 1};\n"
          "Physical Surface(\"lower\") = {1};\nPhysical Surface(\"upper\") = {2};\n"
          "Physical Curve(\"foot\") = {1};\nPhysical Curve(\"top\") = {3};\n"
          "Physical Curve(\"face\") = {5};\nPhysical Curve(\"head\") = {7};\n",
          "[material.m]\nE_MPa = 1000\nnu = 0.3\n"
          "[body.lower]\nmaterial = \"m\"\nkinematics = \"small\"\nmesh = { far_size_mm = 0.05 }\n"
          "[body.upper]\nmaterial = \"m\"\nkinematics = \"small\"\nmesh = { far_size_mm = 0.05 }\n"
          "[contact.fit]\nsecondary = \"face\"\nprimary = [\"top\"]\n"
          "[support.foot]\nedge = \"foot\"\ny = \"fixed\"\n[support.head]\nedge = \"head\"\ny = \"fixed\"\n"
          "[support.left]\npoint_mm = [0, 0]\nx = \"fixed\"\n[support.right]\npoint_mm = [0, 1.8]\nx = \"fixed\"\n"
          "[[step]]\nname = \"fit\"\nincrements = 2\n");
  EXPECT_NEAR(f.problem.contacts[0].drawn.overlap_mm, 0.2, 1e-12);
  EXPECT_LT(verification::worst(f.pressure, 1000.0 / (1.0 - 0.09) * 0.2 / 2.0), 1e-9);
}

// A rigid shaft all round in a ring of plane strain must press on it with Lame's pressure.
TEST(PressFit, RigidShaftAllRound) {
  for (int order : {1, 2}) {
    const std::string radius = number(bore + overlap);
    const auto f =
        fit("Disk(1) = {0, 0, 0, 2};\nDisk(2) = {0, 0, 0, 1};\nBooleanDifference(3) = { Surface{1}; Delete; }{ "
            "Surface{2}; Delete; };\n"
            "Disk(4) = {0, 0, 0, " +
                radius + "};\nPhysical Surface(\"ring\") = {3};\nPhysical Surface(\"shaft\") = {4};\n",
            "[material.b]\nE_MPa = " + number(E_hub) + "\nnu = " + number(nu_hub) +
                "\n[body.ring]\nat = [1.5, 0]\nmaterial = \"b\"\nkinematics = \"small\"\norder = " +
                number(order).substr(0, 1) +
                "\nmesh = { far_size_mm = 0.05 }\n[body.shaft]\nat = [0, 0]\nrigid = true\nmesh = { far_size_mm = 0.05 "
                "}\norder = " +
                number(order).substr(0, 1) +
                "\n[boundary]\nbore = { body = \"ring\", nearest_mm = [1, 0] }\nseat = { body = \"shaft\", nearest_mm "
                "= [1.05, 0] }\n"
                "[contact.fit]\nsecondary = \"bore\"\nprimary = [\"seat\"]\n"
                "[support.shaft]\nedge = \"seat\"\nx = \"fixed\"\ny = \"fixed\"\nrotation = \"fixed\"\n"
                "[support.east]\nbody = \"ring\"\npoint_mm = [2, 0]\ny = \"fixed\"\n"
                "[support.west]\nbody = \"ring\"\npoint_mm = [-2, 0]\ny = \"fixed\"\n"
                "[support.north]\nbody = \"ring\"\npoint_mm = [0, 2]\nx = \"fixed\"\n"
                "[[step]]\nname = \"fit\"\nincrements = 2\n");
    const double exact = overlap / (bore * ring_compliance());
    RecordProperty("mean_" + std::to_string(order), std::to_string(f.mean() / exact));
    EXPECT_NEAR(f.mean(), exact, (order == 1 ? 0.01 : 1e-3) * f.mean());
    EXPECT_LT(verification::worst(f.pressure, f.mean()), order == 1 ? 0.05 : 4e-3);
  }
}

namespace {

/// A lip of rubber with a round edge on a rigid shaft, drawn `drawn` into it and moved by the rest of 0.25 mm.
Fit lip(double drawn) {
  const std::string left = number(1.0 - drawn);
  return fit("x = " + left +
                 ";\nPoint(1) = {x + 0.1, -0.1, 0}; Point(2) = {x + 0.1, 0, 0}; Point(3) = {x + 0.1, 0.1, "
                 "0};\nPoint(7) = {x, 0, 0};\n"
                 "Point(4) = {x + 1, 0.6, 0}; Point(5) = {x + 2, 0.6, 0}; Point(6) = {x + 2, -0.6, 0}; Point(8) = {x + "
                 "1, -0.6, 0};\n"
                 "Circle(1) = {3, 2, 7}; Circle(2) = {7, 2, 1}; Line(3) = {1, 8}; Line(4) = {8, 6}; Line(5) = {6, 5}; "
                 "Line(6) = {5, 4}; Line(7) = {4, 3};\n"
                 "Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7}; Plane Surface(1) = {1};\nDelete { Point{2}; }\nRectangle(2) = "
                 "{0, -2, 0, 1, 4};\n"
                 "Physical Surface(\"lip\") = {1};\nPhysical Surface(\"shaft\") = {2};\nPhysical Curve(\"edge\") = {1, "
                 "2, 3, 7};\n"
                 "Physical Curve(\"back\") = {5};\nPhysical Curve(\"surface\") = {9};\n",
             "[material.nbr]\nlaw = \"neo_hookean\"\nE_MPa = 8\nnu = 0.45\n"
             "[body.lip]\nmaterial = \"nbr\"\nkinematics = \"finite\"\nmesh = { far_size_mm = 0.1 "
             "}\n[body.shaft]\nrigid = true\n"
             "[contact.seal]\nsecondary = \"edge\"\nprimary = [\"surface\"]\nfriction = 0.2\n"
             "fine_zone = { centre_mm = [" +
                 left +
                 ", 0], half_width_mm = 0.2, depth_mm = 0.15, size_mm = 0.03, angle_deg = 90 }\n"
                 "[support.back]\nedge = \"back\"\nx = { motion_mm = " +
                 number(drawn - 0.25) +
                 ", history = \"mount\" }\ny = \"fixed\"\n"
                 "[support.shaft]\nedge = \"surface\"\nx = \"fixed\"\ny = \"fixed\"\nrotation = \"fixed\"\n"
                 "[history]\nmount = [[0, 0], [1, 1]]\n[[step]]\nname = \"mount\"\nplay = [\"mount\"]\nincrements = "
                 "10\nwear = false\n");
}

}  // namespace

// A rubber lip that is drawn eight elements into its shaft must press on it as one that is moved so far, to a percent:
// its mesh is renewed on the way.
TEST(PressFit, RubberLip) {
  const auto drawn = lip(0.25), moved = lip(0.0);
  const double force = moved.summary.contacts[0].normal_force;
  EXPECT_GT(force, 0.05);
  RecordProperty("ratio", std::to_string(drawn.summary.contacts[0].normal_force / force));
  EXPECT_NEAR(drawn.summary.contacts[0].normal_force, force, 0.01 * force);
}
