#include <gtest/gtest.h>

#include <limits>

#include "problem_of.hpp"
#include "sim/measure/intact.hpp"
#include "sim/study/run.hpp"

using namespace reye;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// What is said of a state; empty when nothing is.
std::string said(const sim::Problem& problem, const sim::State& state) {
  sim::Cache cache;
  try {
    sim::check_state(problem, state, cache);
    return {};
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

/// The state with another mesh of its first body.
template <class Change>
sim::State with_mesh(sim::State state, Change change) {
  auto shape = *state.shapes[0];
  change(shape.mesh);
  state.shapes[0] = std::make_shared<const body::Shape>(std::move(shape));
  return state;
}

}  // namespace

// Every state that a run keeps must be taken for one of its problem, the first one, too.
TEST(Intact, StatesOfARun) {
  const auto problem = test::problem_of(test::block_scene);
  sim::State state = sim::initial_state(problem);
  EXPECT_EQ(said(problem, state), "");
  int blocks = 0;
  sim::Observer observer;
  observer.block = [&](const sim::State& at) { EXPECT_EQ(said(problem, at), "") << "block " << ++blocks; };
  EXPECT_EQ(sim::run(problem, state, observer).status, sim::RunStatus::done);
  EXPECT_EQ(said(problem, state), "");
}

// A state with anything that cannot be must be refused with what that is.
TEST(Intact, WhatCannotBe) {
  const auto problem = test::problem_of(test::block_scene);
  sim::State good = sim::initial_state(problem);
  ASSERT_EQ(sim::run(problem, good, {}).status, sim::RunStatus::done);
  using Change = void (*)(sim::State&);
  const std::pair<Change, const char*> changes[] = {
      {[](sim::State& s) { s.shapes.pop_back(); }, "it has another number of bodies"},
      {[](sim::State& s) { s.shapes[0] = nullptr; }, "body slider has no shape"},
      {[](sim::State& s) { std::swap(s.shapes[0], s.shapes[1]); }, "has lost its boundary"},
      {[](sim::State& s) { s.step = 7; }, "it is in a step that the scene lacks"},
      {[](sim::State& s) { s.step = -1; }, "it is in a step that the scene lacks"},
      {[](sim::State& s) { s.cycle = none; }, "its number of cycles is not a number"},
      {[](sim::State& s) { s.step = 1, s.step_cycles = 41.0; }, "more cycles than the step has"},
      {[](sim::State& s) { s.factors["other"] = 1.0; }, "history other"},
      {[](sim::State& s) { s.factors["press"] = none; }, "history press"},
      {[](sim::State& s) { s.life_cycles["other"] = 1.0; }, "limit other"},
      {[](sim::State& s) { s.counts.blocks = -1; }, "its counts are below zero"},
      {[](sim::State& s) { s.approached = false; }, "it is under way and has not begun"},
      {[](sim::State& s) { s.solution.q.high.conservativeResize(3); }, "its displacements"},
      {[](sim::State& s) { s.solution.q.high[0] = none; }, "its displacements"},
      {[](sim::State& s) { s.solution.contacts.clear(); }, "a contact too many or too few"},
      {[](sim::State& s) { s.solution.contacts[0].lambda.pop_back(); }, "contact pad has a value too many or too few"},
      {[](sim::State& s) { s.solution.contacts[0].removed_primary[0] = none; },
       "contact pad has a value that is not a number"},
      {[](sim::State& s) { s.solution.contacts[0].status[0] = static_cast<contact::ContactStatus>(3); },
       "neither open nor sticks nor slips"},
      {[](sim::State& s) {
         s.solution.contacts[0].reference[0].M = {{99, 0.5}};
       },
       "its primary side lacks"},
      {[](sim::State& s) {
         s.solution.contacts[0].reference[0].off = {{-1, 0.5}};
       },
       "its secondary side lacks"},
      {[](sim::State& s) { s.recall.played.begin()->second.dq.conservativeResize(1); },
       "the recalled end of an increment is impossible"},
      {[](sim::State& s) { s.renewed_at.resize(1); }, "the position of a support is not a number"},
      {[](sim::State& s) { s.displaced.resize(2), s.displaced[0].resize(1); }, "displaced at nodes that it lacks"},
      {[](sim::State& s) { s.watch.resize(5); }, "contacts that do not exist"},
  };
  for (const auto& [change, sentence] : changes) {
    auto state = good;
    change(state);
    const auto text = said(problem, state);
    EXPECT_TRUE(text.starts_with("altered: ") && text.find(sentence) != std::string::npos) << sentence << ": " << text;
  }
}

// A mesh that breaks one of its promises must be refused before anything is made of it.
TEST(Intact, Meshes) {
  const auto problem = test::problem_of(test::block_scene);
  const sim::State good = sim::initial_state(problem);
  using Change = void (*)(mesh::Mesh&);
  const Change changes[] = {
      [](mesh::Mesh& m) { m.cells[0][0] = m.node_count(); },
      [](mesh::Mesh& m) { m.cells[0][1] = -5; },
      [](mesh::Mesh& m) { m.cells.clear(); },
      [](mesh::Mesh& m) { m.cells.pop_back(); },
      [](mesh::Mesh& m) { m.kind = static_cast<mesh::CellKind>(17); },
      [](mesh::Mesh& m) { m.kind = mesh::CellKind::quad8; },
      [](mesh::Mesh& m) { m.X[0].x() = none; },
      [](mesh::Mesh& m) {
        m.X[0] = {50.0, 50.0};
      },
      [](mesh::Mesh& m) { m.X.emplace_back(0.0, 0.0); },
      [](mesh::Mesh& m) { m.outline[0][1] = 100000; },
      [](mesh::Mesh& m) { m.outline.clear(); },
      [](mesh::Mesh& m) { m.boundaries.begin()->second[0][0] = -1; },
      [](mesh::Mesh& m) { m.boundaries.erase(m.boundaries.begin()); },
      [](mesh::Mesh& m) { m.points.push_back(100000); },
      [](mesh::Mesh& m) { m.arc_origin["slider_top"] = {-3}; },
  };
  for (std::size_t k = 0; k < std::size(changes); ++k)
    EXPECT_TRUE(said(problem, with_mesh(good, changes[k])).starts_with("altered: ")) << k;
}
