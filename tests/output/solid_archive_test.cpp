#include "output/solid/solid_archive.hpp"

#include <gtest/gtest.h>

#include <random>

#include "output/folder/files.hpp"
#include "output/run/serialize.hpp"
#include "output/run/state_archive.hpp"
#include "output/solid/drawn_meshes.hpp"
#include "solid_sample.hpp"
#include "support/solid_blocks.hpp"
#include "support/texts.hpp"

using namespace reye;
using namespace reye::output;
using reye::support::holds;

namespace {

/// A made-up state with another value in each member.
sim::SolidRunState made_up_state() {
  sim::SolidRunState s;
  s.solution = {{{{0.1, 0.2, 1.0 / 3.0}, {1.0, 2.0, 3.0}}},
                {{contact::SkinStatus::slip, contact::SkinStatus::stick}},
                {},
                base::Vector::LinSpaced(3, 0.1, 0.3),
                base::Vector::LinSpaced(2, 1.0, 2.0),
                base::Vector::LinSpaced(6, -0.1, 1e-310),
                {base::Turn(0.5, 0.5, -0.5, 0.5)}};
  s.touchable = {{0, 1, 1}, {1, 0}};
  solver::SolidSolution solved;
  solved.converged = true;
  solved.reason = "none";
  solved.loose = true;
  solved.iterations = 7;
  solved.errors = {0.5, 1e-10};
  solved.state = s.solution;
  contact::SkinPlace place;
  place.Q.resize(2, 5);
  place.Q.insert(0, 4) = -0.25;
  place.Q.insert(0, 1) = 0.75;
  place.Q.insert(1, 0) = 1.0 / 3.0;
  place.covered = base::Vector::LinSpaced(2, 0.3, 0.4);
  place.area = base::Vector::LinSpaced(2, 0.5, 0.6);
  place.frame = {{base::Vec3::UnitZ(), {base::Vec3::UnitX(), base::Vec3::UnitY()}, 1}, {}};
  place.carries = {1, 0};
  solved.place = {place};
  solved.nodes = {{{{1.0, 2.0, 3.0}, 0.125, {4.0, 5.0, 6.0}, 0.5}, {}}};
  s.solved = solved;
  s.factors = {{"press", 1.0}, {"slide", -0.5}};
  s.step = 1;
  s.step_cycles = 2.0;
  s.step_blocks = 2;
  s.jump = 8.0;
  s.jump_rate = 0.25;
  s.block_cycles = 4.0;
  s.share_per_cycle = 0.125;
  s.jump_error = 0.01;
  s.points = {{{{0, 1}, {0, 2}}, {{1, 3}}}};
  contact::SkinWear wear;
  wear.pending_secondary = {0.1, 0.2};
  wear.removed_primary = {0.3};
  wear.law_volume = 0.6;
  s.solution.wear = s.block_wear = {wear};
  s.slid = {{1, 0}};
  s.life_cycles = {{"deep", 7.0}};
  s.life_error = {{"deep", 0.5}};
  s.limit_measure = {{"deep", 0.2}};
  s.limit_rate = {{"deep", 0.01}};
  s.increment = 3;
  s.cycle = 4.5;
  s.energy_last_cycle_mJ = {0.3};
  s.widest_stick = {{0.2, 0.3, 0.01}};
  s.warnings = {{"edge", "contact pad", "The pressure rises.", 1.5}};
  s.counts = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  s.cutback_reasons = {"why"};
  s.balance = 1e-14;
  s.retained = 5;
  return s;
}

const std::vector<std::uint64_t> meshes{11, 12};

}  // namespace

// A state must come back with every bit, members of each kind among them; times of a process must not.
TEST(SolidArchive, ReadsBack) {
  auto state = made_up_state();
  const auto bytes = solid_state_to_bytes(state, meshes);
  const auto back = solid_state_from_bytes(bytes, meshes);
  EXPECT_EQ(solid_state_to_bytes(back, meshes), bytes);
  EXPECT_EQ(back.solution.traction, state.solution.traction);
  EXPECT_EQ(back.solution.status, state.solution.status);
  EXPECT_EQ(back.solution.u, state.solution.u);
  EXPECT_EQ(back.touchable, state.touchable);
  ASSERT_TRUE(back.solved);
  EXPECT_TRUE(back.solved->converged && back.solved->loose);
  EXPECT_EQ(back.solved->errors, state.solved->errors);
  EXPECT_EQ(base::Matrix(back.solved->place[0].Q), base::Matrix(state.solved->place[0].Q));
  EXPECT_EQ(back.solved->place[0].frame[0].free, 1);
  EXPECT_EQ(back.solved->nodes[0][0].gap, 0.125);
  EXPECT_EQ(std::tie(back.step, back.step_cycles, back.increment, back.cycle, back.retained),
            std::tie(state.step, state.step_cycles, state.increment, state.cycle, state.retained));
  EXPECT_EQ(back.energy_last_cycle_mJ, state.energy_last_cycle_mJ);
  EXPECT_EQ(back.warnings[0].severity, 1.5);
  EXPECT_EQ(back.counts.refused_blocks, 8);
  state.factor_s = state.mortar_s = state.interface_s = state.solved->mortar_s = state.solved->interface_s = 9.0;
  EXPECT_EQ(solid_state_to_bytes(state, meshes), bytes);
}

// Each member that is changed must change the bytes: none is left out.
TEST(SolidArchive, EveryMemberCounts) {
  using State = sim::SolidRunState;
  void (*const changes[])(State&) = {
      [](State& s) { s.solution.a[0] += 1.0; },
      [](State& s) { s.solution.s[0] += 1.0; },
      [](State& s) { s.solution.turn[0].x() = 0.1; },
      [](State& s) { s.touchable[0][0] = 1; },
      [](State& s) { s.solved->iterations = 8; },
      [](State& s) { s.solved->reason = "other"; },
      [](State& s) { s.solved->state.u[0] += 1.0; },
      [](State& s) { s.solved->place[0].covered[0] += 1.0; },
      [](State& s) { s.solved->place[0].area[0] += 1.0; },
      [](State& s) { s.solved->place[0].carries[1] = 1; },
      [](State& s) { s.solved->place[0].frame[0].tangent[1].x() = 1.0; },
      [](State& s) { s.solved->nodes[0][1].slip.x() = 1.0; },
      [](State& s) { s.solved.reset(); },
      [](State& s) { s.factors["press"] = 2.0; },
      [](State& s) { s.energy_last_cycle_mJ[0] = 1.0; },
      [](State& s) { s.widest_stick[0].contact_mm = 1.0; },
      [](State& s) { s.solution.wear[0].pending_secondary[1] = 1.0; },
      [](State& s) { s.block_wear[0].law_volume = 1.0; },
      [](State& s) { s.points[0].primary[0][1] = 4; },
      [](State& s) { s.slid[0][1] = 1; },
      [](State& s) { s.jump_error.reset(); },
      [](State& s) { s.jump = s.jump_rate = 0.0; },
      [](State& s) { s.block_cycles = 0.0; },
      [](State& s) { s.share_per_cycle = 0.0; },
      [](State& s) { s.step_blocks = 0; },
      [](State& s) { s.life_cycles.clear(); },
      [](State& s) { s.life_error.clear(); },
      [](State& s) { s.limit_measure.clear(); },
      [](State& s) { s.limit_rate.clear(); },
      [](State& s) { s.cutback_reasons.clear(); },
      [](State& s) { s.balance = 0.0; },
      [](State& s) { s.counts.cutbacks = 0; },
  };
  const auto bytes = solid_state_to_bytes(made_up_state(), meshes);
  for (std::size_t k = 0; k < std::size(changes); ++k) {
    auto state = made_up_state();
    changes[k](state);
    EXPECT_NE(solid_state_to_bytes(state, meshes), bytes) << k;
  }
  EXPECT_NE(solid_state_layout(), state_layout());
}

// Meshes that wear has changed must come back with every bit; those that are as drawn must not be stored.
TEST(SolidArchive, WornMeshes) {
  const auto drawn_one =
      std::make_shared<const mesh::SolidMesh>(support::block(mesh::SolidKind::hex8, {1, 1, 1}, base::Vec3::Ones()));
  auto moved = *drawn_one;
  moved.X[7].z() -= 1e-3;
  const sim::SolidMeshes drawn{drawn_one, drawn_one};
  auto state = made_up_state();
  state.meshes = drawn;
  const auto plain = solid_state_to_bytes(state, meshes, drawn);
  state.meshes[1] = std::make_shared<const mesh::SolidMesh>(moved);
  const auto bytes = solid_state_to_bytes(state, meshes, drawn);
  EXPECT_GT(bytes.size(), plain.size() + 8 * 24);
  const auto back = solid_state_from_bytes(bytes, meshes, drawn);
  EXPECT_EQ(back.meshes[0], drawn_one);
  EXPECT_EQ(back.meshes[1]->X, moved.X);
  EXPECT_EQ(back.meshes[1]->faces, moved.faces);
}

// A state of other meshes must be refused with that reason.
TEST(SolidArchive, OtherMeshesAreRefused) {
  try {
    solid_state_from_bytes(solid_state_to_bytes(made_up_state(), meshes), {11, 13});
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(holds(error.what(), "its bodies have other meshes")) << error.what();
  }
}

// Bytes that end early or were altered must be refused or read as a state: no crash, no memory for sizes that they
// cannot hold, no entry beside its matrix.
TEST(SolidArchive, AlteredBytes) {
  const auto whole = solid_state_to_bytes(made_up_state(), meshes);
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_THROW(solid_state_from_bytes(whole.substr(0, size), meshes), std::runtime_error) << size;
  std::mt19937 random(3);
  for (int k = 0; k < 20000; ++k) {
    auto bytes = whole;
    for (int n = 1 + static_cast<int>(random() % 3); n > 0; --n)
      bytes[random() % bytes.size()] = static_cast<char>(random() % 5 == 0 ? 0xff : random());
    try {
      const auto state = solid_state_from_bytes(bytes, meshes);
      if (!state.solved) continue;
      for (const auto& place : state.solved->place)
        for (int row = 0; row < place.Q.rows(); ++row)
          for (contact::SkinRows::InnerIterator it(place.Q, row); it; ++it) ASSERT_LT(it.col(), place.Q.cols());
    } catch (const std::runtime_error&) {
      continue;
    }
  }
}

// A sparse matrix must come back with its entries in their places; one whose arrays contradict each other is an error.
TEST(Serialize, SparseReadsBack) {
  base::SparseMatrix columns(3, 2), none(0, 0), back(1, 1);
  columns.insert(2, 0) = 1.5;
  columns.insert(0, 1) = -2.5;
  for (const auto& matrix : {columns, none}) {
    from_bytes(to_bytes(matrix), back);
    EXPECT_EQ(base::Matrix(back), base::Matrix(matrix));
  }
  const auto refused = [&](std::int64_t inner_size, std::vector<int> begin, std::vector<int> inner) {
    const std::vector<double> values(2, 1.0);
    EXPECT_THROW(from_bytes(to_bytes(inner_size, begin, inner, values), back), cereal::Exception);
  };
  refused(-1, {0, 1, 2}, {0, 0});
  refused(3, {}, {0, 0});
  refused(3, {1, 1, 2}, {0, 0});
  refused(3, {0, 2, 1}, {0, 0});
  refused(3, {0, 1, 3}, {0, 0});
  refused(3, {0, 1, 2}, {0, 3});
  refused(3, {0, 1, 2}, {-1, 0});
  refused(3, {0, 2, 2}, {1, 1});
}

// Meshes must come back as they were drawn, with what was said of them; those of another scene, damaged or with a node
// that does not exist must not.
TEST(DrawnMeshes, ReadBack) {
  const reye::support::TemporaryFolder dir;
  sim::SolidProblem problem;
  problem.scene.fixed_sha256 = "abc";
  for (const auto& mesh : {solid_sample::lower(), solid_sample::upper()}) {
    body::SolidInput input;
    input.mesh = mesh;
    problem.inputs.push_back(input);
  }
  problem.warnings = {{sim::geometry_warning, "", "It is 1 km large.", 0.0}, {"other", "", "x", 0.0}};
  EXPECT_FALSE(load_meshes(dir.str(), "abc"));
  save_meshes(dir.str(), problem);
  const auto back = load_meshes(dir.str(), "abc");
  ASSERT_TRUE(back);
  ASSERT_EQ(back->bodies.size(), 2u);
  for (std::size_t b = 0; b < 2; ++b) EXPECT_EQ(back->bodies[b].X, problem.inputs[b].mesh->X);
  EXPECT_EQ(back->bodies[1].faces, problem.inputs[1].mesh->faces);
  EXPECT_EQ(back->warnings, std::vector<std::string>{"It is 1 km large."});
  const auto sums = mesh_checksums(problem);
  EXPECT_NE(sums[0], sums[1]);
  EXPECT_FALSE(load_meshes(dir.str(), "def"));
  const auto file = dir / "checkpoint/meshes.bin";
  auto bytes = read_text(file);
  bytes.back() = static_cast<char>(bytes.back() ^ 1);
  atomic_write(file, bytes);
  EXPECT_FALSE(load_meshes(dir.str(), "abc"));
  auto broken = *solid_sample::lower();
  broken.cells[0][3] = 1000;
  problem.inputs[0].mesh = std::make_shared<const mesh::SolidMesh>(broken);
  save_meshes(dir.str(), problem);
  EXPECT_FALSE(load_meshes(dir.str(), "abc"));
}
