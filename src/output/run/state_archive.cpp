#include "output/run/state_archive.hpp"

#include "contact/fields.hpp"
#include "output/run/checksum.hpp"
#include "output/run/layout.hpp"
#include "output/run/run_writer.hpp"
#include "output/run/serialize.hpp"
#include "output/run/serialize_records.hpp"

namespace reye::base {

template <class Archive>
void serialize(Archive& archive, TwoPart& v) {
  archive(v.high, v.low);
}

}  // namespace reye::base

namespace reye::contact {

template <class Archive>
void serialize(Archive& archive, MortarRow& row) {
  archive(row.D, row.cover, row.covered, row.off, row.M);
}

template <class Archive>
void serialize(Archive& archive, ContactState& s) {
  for_each_field(s, [&archive](const Field&, auto& member) { archive(member); });
}

}  // namespace reye::contact

namespace reye::material {

template <class Archive>
void serialize(Archive& archive, PlasticState& s) {
  archive(s.strain, s.accumulated);
}

}  // namespace reye::material

namespace reye::body {

template <class Archive>
void serialize(Archive& archive, Interior& s) {
  archive(s.y, s.history, s.F0);
}

}  // namespace reye::body

namespace reye::solver {

template <class Archive>
void serialize(Archive& archive, SolverState& s) {
  archive(s.q, s.interiors, s.contacts);
}

template <class Archive>
void serialize(Archive& archive, Guess& s) {
  archive(s.dq, s.inside, s.lambda, s.status);
}

}  // namespace reye::solver

namespace reye::sim {

template <class Archive>
void serialize(Archive& archive, Pressed& p) {
  archive(p.force, p.peak_mm, p.across, p.length_mm, p.size_mm, p.bounded, p.cut, p.beside_zone, p.facets_mm);
}

template <class Archive>
void serialize(Archive& archive, ContactWatch& w) {
  archive(w.force_most, w.widest, w.slipped_most, w.pressed);
}

template <class Archive>
void serialize(Archive& archive, TractionPeak& p) {
  archive(p.MPa, p.at_mm, p.cycle, p.at_end);
}

template <class Archive>
void serialize(Archive& archive, BondTraction& b) {
  archive(b.tension, b.shear, b.mean_tension_MPa, b.mean_shear_MPa);
}

template <class Archive>
void serialize(Archive& archive, Recall& r) {
  archive(r.step, r.played);
}

}  // namespace reye::sim

namespace reye::output {

namespace {

/// Shapes are shared as pointers to const; the archive holds them as plain ones.
std::vector<std::shared_ptr<body::Shape>> plain(const std::vector<body::ShapePtr>& shapes) {
  std::vector<std::shared_ptr<body::Shape>> list;
  for (const auto& shape : shapes) list.push_back(std::const_pointer_cast<body::Shape>(shape));
  return list;
}

template <class Archive, class State>
void fields(Archive& archive, State& s) {
  archive(s.cycle, s.step, s.step_cycles, s.step_blocks, s.jump, s.jump_rate, s.block_cycles, s.flow, s.levels_at_once,
          s.last_wear, s.jump_error, s.factors, s.solution, s.recall, s.renewed_at, s.displaced, s.approached,
          s.life_cycles, s.life_error, s.limit_measure, s.limit_rate, s.small_strain_error, s.warnings, s.watch,
          s.bonds, s.counts, s.shown, s.cutback_reasons);
}

}  // namespace

std::string state_to_bytes(const sim::State& state) {
  std::ostringstream stream(std::ios::binary);
  cereal::BinaryOutputArchive archive(stream);
  archive(plain(state.shapes));
  fields(archive, state);
  return stream.str();
}

sim::State state_from_bytes(const std::string& bytes) {
  sim::State state;
  std::vector<std::shared_ptr<body::Shape>> shapes;
  try {
    BoundedInput archive(bytes);
    archive(shapes);
    fields(archive, state);
    archive.end();
  } catch (const cereal::Exception& error) {
    throw std::runtime_error(std::string("altered: ") + error.what());
  }
  state.shapes.assign(shapes.begin(), shapes.end());
  return state;
}

std::uint64_t state_layout() {
  LayoutArchive archive;
  sim::State state;
  archive(std::vector<std::shared_ptr<body::Shape>>{}, Counters{});
  fields(archive, state);
  return checksum(archive.text());
}

}  // namespace reye::output
