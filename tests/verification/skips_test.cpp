#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "sim/march/block.hpp"
#include "verification/wear_scene.hpp"

using namespace reye;
using namespace reye::verification;

// What a run leaves out where it is not needed must not be seen in its results: the same scene with and without it.
namespace {

constexpr double same = 1e-9;  ///< relative

/// Tight, so that what remains is not the solver's tolerance.
const solver::NewtonOptions tight{.force_tolerance = 1e-12, .condition_tolerance = 1e-11};

/// Plays all steps of a scene block by block, as a run does but with a solver and a watch of one's own.
struct Player {
  sim::Problem problem;
  solver::NewtonOptions options = tight;
  sim::Cache cache{};
  sim::State state{};
  sim::Observer observer{};
  std::function<void()> between{};  ///< after each block
  bool shows = false;               ///< the end of each block

  explicit Player(const std::string& text) : problem(prepared(text)) {}

  void begin() {
    cache.newton = solver::Newton(options);
    state = sim::initial_state(problem);
    sim::begin_state(problem, state, cache);
  }

  const sim::State& play() {
    if (!state.approached) begin();
    for (const auto& step : problem.scene.steps) {
      const bool cycles = step.cycles > 0.0;
      for (double left = cycles ? step.cycles : 1.0; left > 0.0; left -= cycles ? step.jump : 1.0) {
        const sim::BlockSpan span{&step, cycles ? step.jump : 1.0, cycles, left <= step.jump, shows};
        auto outcome = sim::play_block(problem, state, cache, span, observer);
        EXPECT_EQ(outcome.failure, "");
        state = std::move(outcome.state);
        if (between) between();
      }
    }
    return state;
  }
};

/// Largest difference over the largest value.
template <class Values>
double apart(const Values& a, const Values& b) {
  EXPECT_EQ(a.size(), b.size());
  double difference = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < std::min<std::size_t>(a.size(), b.size()); ++i) {
    const auto size = [](const auto& x) {
      if constexpr (requires { x.norm(); })
        return x.norm();
      else
        return std::abs(x);
    };
    difference = std::max(difference, size(typename Values::value_type(a[i] - b[i])));
    largest = std::max(largest, size(b[i]));
  }
  return largest > 0.0 ? difference / largest : difference;
}

/// All that evolves.
void expect_same(const sim::State& a, const sim::State& b, const std::string& what) {
  SCOPED_TRACE(what);
  ASSERT_EQ(a.shapes.size(), b.shapes.size());
  for (std::size_t k = 0; k < a.shapes.size(); ++k) EXPECT_LT(apart(a.shapes[k]->mesh.X, b.shapes[k]->mesh.X), same);
  EXPECT_LT(apart(a.solution.q.high, b.solution.q.high), same);
  for (std::size_t k = 0; k < a.solution.interiors.size(); ++k) {
    if (a.solution.interiors[k].y.size() != b.solution.interiors[k].y.size()) continue;
    EXPECT_LT(apart(a.solution.interiors[k].y.high, b.solution.interiors[k].y.high), same);
  }
  for (std::size_t c = 0; c < a.solution.contacts.size(); ++c) {
    const auto &p = a.solution.contacts[c], &q = b.solution.contacts[c];
    EXPECT_LT(apart(p.lambda, q.lambda), same);
    EXPECT_LT(apart(p.slip, q.slip), same);
    EXPECT_LT(apart(p.removed_secondary, q.removed_secondary), same);
    EXPECT_LT(apart(p.removed_primary, q.removed_primary), same);
    EXPECT_NEAR(p.frictional_work, q.frictional_work, same * std::abs(q.frictional_work));
    EXPECT_EQ(p.status, q.status);
  }
}

/// Fretting, coarse and short: partial slip, then wear with the shape following.
std::string fretting(const Replacements& changes = {}) {
  return replaced(scene_text("fretting_demo", {{"jump = { tolerance = 0.01 }", "jump = 600"},
                                               {"size_mm = 0.020", "size_mm = 0.04"},
                                               {"increments = 40", "increments = 16"},
                                               {"cycles = 18000", "cycles = 1800"}}),
                  changes);
}

/// Finite strain: a rubber pin that wears. No fresh mesh: another rounding is enough for other elements.
std::string rubber_pin() {
  return scene_text("rubber_pin_wear", {{"size_mm = 0.08", "size_mm = 0.16"},
                                        {"increments = 40", "increments = 20"},
                                        {"cycles = 200", "cycles = 20"},
                                        {"[output]", "[remesh]\nautomatic = false\n[output]"}});
}

const std::pair<const char*, std::string> scenes[] = {{"fretting", fretting()}, {"pin", rubber_pin()}};

/// Plays a scene as runs do, and once more after `change` has made a player not leave something out. True: they took
/// different paths, decided by the last digits.
bool expect_unseen(const std::string& text, const std::string& what, const std::function<void(Player&)>& change) {
  Player usual(text), other(text);
  usual.play();
  change(other);
  other.play();
  expect_same(usual.state, other.state, what);
  return usual.state.solution.q.high != other.state.solution.q.high;
}

}  // namespace

// Contact nodes of linear bodies far from contact that are condensed out, and the whole boundary in every iteration.
TEST(Skips, ReachIsLimited) {
  EXPECT_TRUE(expect_unseen(fretting(), "fretting", [](Player& p) { p.options.limit_reach = false; }));
}

// A factorised matrix that is kept while the error falls fast, and a new one in every iteration.
TEST(Skips, MatricesAreKept) {
  for (const auto& [name, text] : scenes)
    EXPECT_TRUE(expect_unseen(text, name, [](Player& p) { p.options.chords = false; }));
}

// What the solver keeps from one increment to the next (its extrapolated start and its reach), and a new solver for
// each. At small strain: a finitely strained surface may meet all equations in two neighbouring states (of the pin, at
// one increment, with the same nodes in contact and without friction, too; 2e-6 of the peak pressure apart), and the
// start then chooses.
TEST(Skips, SolverIsKept) {
  EXPECT_TRUE(expect_unseen(fretting(), "fretting", [](Player& p) {
    p.observer.increment = [&p](const sim::IncrementRecord&) { p.cache.newton = solver::Newton(p.options); };
  }));
}

// Increments that start from where they led a block before, and such that start from the last increment: the same wear,
// with fewer solves.
TEST(Skips, CyclesAreRecalled) {
  const std::string text = fretting({{"jump = 600", "jump = 100"}, {"cycles = 1800", "cycles = 1200"}});
  Player usual(text), forgetful(text);
  forgetful.between = [&] { forgetful.state.recall = {}; };
  usual.play();
  forgetful.play();
  ASSERT_EQ(forgetful.state.counts.cutbacks, 0);
  expect_same(usual.state, forgetful.state, "fretting");
  EXPECT_LT(usual.state.counts.newton_iterations, 9 * forgetful.state.counts.newton_iterations / 10);
}

// Recalled cycles must give the same results for bodies that yield, once they have shaken down.
TEST(Skips, CyclesOfPlasticBodiesAreRecalled) {
  const std::string text = scene_text("plastic_fretting", {{"size_mm = 0.012", "size_mm = 0.04"},
                                                           {"increments = 40", "increments = 12"},
                                                           {"cycles = 400", "cycles = 100"}});
  Player usual(text), forgetful(text);
  forgetful.between = [&] { forgetful.state.recall = {}; };
  usual.play();
  forgetful.play();
  expect_same(usual.state, forgetful.state, "plastic fretting");
  EXPECT_LT(usual.state.counts.newton_iterations, 9 * forgetful.state.counts.newton_iterations / 10);
}

// Operators, their factorisations and all other derived data that are kept from block to block, and none of it.
TEST(Skips, CacheIsKept) {
  for (const auto& [name, text] : scenes)
    expect_unseen(text, name, [](Player& p) {
      p.between = [&p] {
        p.cache.key = {};
        p.cache.newton = solver::Newton(p.options);
      };
    });
}

// Frames and rows of the history that nobody asks for, and all of them: not a bit of the results is touched.
TEST(Skips, OutputIsBuiltWhenAskedFor) {
  for (const auto& [name, text] : scenes) {
    Player plain(text), watched(text);
    watched.problem.scene.output.frames.every_increment = true;
    int frames = 0, rows = 0;
    watched.observer.frame = [&](const sim::Frame&) { ++frames; };
    watched.observer.increment = [&](const sim::IncrementRecord&) { ++rows; };
    const auto &a = plain.play(), &b = watched.play();
    EXPECT_GT(frames, 10);
    EXPECT_GE(rows, frames);
    EXPECT_EQ(a.solution.q.high, b.solution.q.high) << name;
    EXPECT_EQ(a.solution.contacts[0].lambda, b.solution.contacts[0].lambda) << name;
    EXPECT_EQ(a.solution.contacts[0].removed_secondary, b.solution.contacts[0].removed_secondary) << name;
  }
}

// A contact that does not wear, without wear in its equations and without shape steps, and one whose coefficients are
// all but zero.
TEST(Skips, WearIsAbsent) {
  Player none(fretting({{"3.222e-5", "0.0"}, {"2.111e-5", "0.0"}}));
  Player tiny(fretting({{"3.222e-5", "1e-25"}, {"2.111e-5", "1e-25"}}));
  EXPECT_FALSE(none.problem.contacts[0].options.wear.wears());
  EXPECT_TRUE(tiny.problem.contacts[0].options.wear.wears());
  none.play();
  auto worn = tiny.play();
  auto& contact = worn.solution.contacts[0];
  EXPECT_GT(*std::max_element(contact.removed_secondary.begin(), contact.removed_secondary.end()), 0.0);
  for (auto* removed : {&contact.removed_secondary, &contact.removed_primary})
    std::fill(removed->begin(), removed->end(), 0.0);
  expect_same(none.state, worn, "wear");
}

// A frictionless contact, without stick and slip in its equations, and one whose friction is all but zero.
TEST(Skips, FrictionIsAbsent) {
  const Replacements no_wear{{"3.222e-5", "0.0"}, {"2.111e-5", "0.0"}};
  Player none(replaced(fretting(no_wear), {{"friction  = 0.9", "friction  = 0.0"}}));
  Player tiny(replaced(fretting(no_wear), {{"friction  = 0.9", "friction  = 1e-14"}}));
  none.play();
  tiny.play();
  EXPECT_LT(apart(none.state.solution.q.high, tiny.state.solution.q.high), same);
  EXPECT_LT(apart(none.state.solution.contacts[0].lambda, tiny.state.solution.contacts[0].lambda), same);
}

// A linear elastic body of small strain, condensed once, and the same one linearised and condensed in every iteration.
TEST(Skips, LinearBodiesAreCondensedOnce) {
  const Replacements shorter{{"jump = 600", "jump = 60"}, {"cycles = 1800", "cycles = 180"}};
  const std::string text = "shape = \"off\"\n" + fretting(shorter);
  EXPECT_TRUE(expect_unseen(text, "linear", [](Player& p) {
    p.state = sim::initial_state(p.problem);
    const auto kept = sim::system_of(p.problem, p.state, p.cache);
    const auto& usual = *kept;
    std::vector<body::Operator> bodies;
    for (int b = 0; b < p.problem.body_count(); ++b)
      bodies.emplace_back(body::NonlinearBody(p.state.shapes[b], p.problem.inputs[b]));
    p.cache.system = std::make_shared<const solver::System>(solver::make_system(std::move(bodies), usual.contacts));
    p.begin();
  }));
}

// Outlines that wait for enough wear to move must wear as those that move after every block, for a fraction of the
// factorisations; and what is shown has moved.
TEST(Skips, OutlinesWaitForWear) {
  const std::string text = fretting({{"jump = 600", "jump = 60"}});
  Player waits(text), moves(text);
  moves.shows = true;
  std::size_t waited = 0;
  const auto waiting = [](const sim::State& state) {
    const auto& pending = state.solution.contacts.at(0).pending_secondary;
    return std::any_of(pending.begin(), pending.end(), [](double v) { return v > 0.0; });
  };
  waits.between = [&] { waited += waiting(waits.state); };
  moves.between = [&] { EXPECT_FALSE(waiting(moves.state)); };
  const auto &a = waits.play().solution.contacts.at(0), &b = moves.play().solution.contacts.at(0);
  EXPECT_GE(waited, 20U);
  EXPECT_FALSE(waiting(waits.state));
  EXPECT_LT(waits.state.counts.factorisations, 0.4 * static_cast<double>(moves.state.counts.factorisations));
  EXPECT_LT(apart(a.removed_secondary, b.removed_secondary), 1e-3);
  EXPECT_LT(apart(a.removed_primary, b.removed_primary), 1e-3);
  EXPECT_LT(apart(a.lambda, b.lambda), 2e-3);
  EXPECT_NEAR(a.strip_secondary + a.strip_primary, a.law_volume, 1e-12 * a.law_volume);
}

// A run that fails while wear waits must show its last good state worn as deep as its tables say.
TEST(Skips, WornOutlineOfAFailedRun) {
  const auto problem = prepared(fretting({{"jump = 600", "jump = 60"}}));
  auto state = sim::initial_state(problem);
  sim::Observer watch;
  sim::Frame last;
  watch.frame = [&](const sim::Frame& frame) { last = frame; };
  bool failed = false;
  watch.increment = [&](const sim::IncrementRecord& row) {
    if (row.cycle > 500.0 && !std::exchange(failed, true)) throw base::SolveError("as if the solver had failed");
  };
  EXPECT_EQ(sim::run(problem, state, watch).status, sim::RunStatus::failed);
  EXPECT_EQ(last.step, "last good state");
  const auto& pending = state.solution.contacts.at(0).pending_secondary;
  EXPECT_TRUE(std::any_of(pending.begin(), pending.end(), [](double v) { return v > 0.0; }));
  const auto& face = last.surfaces.at(0);
  const double deepest = *std::max_element(face.wear_depth_mm.begin(), face.wear_depth_mm.end());
  EXPECT_GT(deepest, 0.0);
  for (std::size_t i = 0; i < face.y_mm.size(); ++i) EXPECT_NEAR(-face.y_mm[i], face.wear_depth_mm[i], 1e-3 * deepest);
}
