#include "sim/measure/measure.hpp"
#include "verification/contact_scene.hpp"

using namespace reye;
using namespace reye::verification;

namespace {

/// Half widths of the stick zone of geo/cattaneo_mindlin (references B2) [mm].
struct Stick {
  static constexpr double loaded = 0.0645843, unloaded = 0.0790993;
};

double mindlin(double x, double stick, double limit) {
  return hertz(x, Hertz::a, limit) - hertz(x, stick, limit * stick / Hertz::a);
}
double shear_loaded(double x) { return mindlin(x, Stick::loaded, Hertz::mu * Hertz::p0); }
double shear_unloaded(double x) { return shear_loaded(x) - mindlin(x, Stick::unloaded, 2.0 * Hertz::mu * Hertz::p0); }

const std::map<std::string, sim::Frame>& frames() {
  static const auto all = frames_of(scene_text("cattaneo_mindlin"));
  return all;
}

const sim::SurfaceRecord& flat(const std::string& step) { return frames().at(step).surfaces.at(0); }

/// L2 error of the shear in parts of the full-slip traction's norm.
double shear_error(const std::string& step, const Curve& exact) {
  const auto& s = flat(step);
  return l2_error(profile(s, s.shear_MPa), 2.0 * Hertz::a, exact) /
         (Hertz::mu * Hertz::p0 * std::sqrt(4.0 / 3.0 * Hertz::a));
}

double largest(const std::vector<double>& v) { return *std::max_element(v.begin(), v.end()); }

}  // namespace

// At Q = mu P / 2 the stick half width must be within 1 % of Cattaneo and Mindlin's at 40 elements across; the shear on
// the flat, which the cylinder drags towards +x, must be positive along increasing x.
TEST(PartialSlip, Loading) {
  EXPECT_NEAR(sim::stick_half_width(flat("load"), Hertz::mu).value(), Stick::loaded, 0.01 * Stick::loaded);
  EXPECT_LT(shear_error("load", shear_loaded), 0.03);
  EXPECT_GT(flat("load").shear_MPa[flat("load").shear_MPa.size() / 2], 0.0);
}

// The largest shear, a cusp at the stick edge, must come within one element's fall of mu p0 sqrt(Q / mu P).
TEST(PartialSlip, PeakShear) {
  const double h = 0.0045, exact = Hertz::mu * Hertz::p0 * std::sqrt(0.5);
  EXPECT_NEAR(largest(flat("load").shear_MPa), exact, exact - shear_loaded(Stick::loaded - h));
}

// Back at Q = 0 reversed slip must reach in to c', the locked-in shear must follow the superposed profile.
TEST(PartialSlip, Unloading) {
  sim::SurfaceRecord change = flat("unload");
  for (std::size_t i = 0; i < change.node.size(); ++i) change.shear_MPa[i] -= flat("load").shear_MPa[i];
  EXPECT_NEAR(sim::stick_half_width(change, 2.0 * Hertz::mu).value(), Stick::unloaded, 0.01 * Stick::unloaded);
  EXPECT_LT(shear_error("unload", shear_unloaded), 0.06);
}

// Fully reversed, the shear must be the mirror image of the first loading.
TEST(PartialSlip, Reversal) {
  EXPECT_NEAR(sim::stick_half_width(flat("reverse"), Hertz::mu).value(), Stick::loaded, 0.01 * Stick::loaded);
  EXPECT_LT(shear_error("reverse", [](double x) { return -shear_loaded(x); }), 0.03);
}
