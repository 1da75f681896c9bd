#include "stability/played.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "base/errors.hpp"
#include "scene/rewrite.hpp"
#include "sim/march/block.hpp"
#include "sim/problem/drive.hpp"
#include "sim/study/run.hpp"
#include "support/problem.hpp"

namespace reye::test {

namespace {

using base::Vec2;

std::string scene_of(const Member& member) {
  std::string text = in_units(member.scene, member.units);
  for (const auto& [key, value] : member.changes) {
    const auto changed = scene::with_value(text, key, in_units(value, member.units));
    if (!changed) throw std::runtime_error(member.name + ": the scene takes no " + key);
    text = *changed;
  }
  return text;
}

sim::Problem prepared(const Member& member) {
  return support::problem_from({{"slider.msh", slider_file(member.blocks, member.units.length)},
                                {"base.msh", base_file(member.blocks, member.units.length)},
                                {"scene.toml", scene_of(member)}});
}

/// Watches one run.
class Watch {
 public:
  Watch(const sim::Problem& problem, const Member& member, Played& played) : p_(problem), m_(member), out_(played) {}

  sim::Observer observer() {
    sim::Observer o;
    o.increment = [this](const sim::IncrementRecord& r) { increment(r); };
    o.frame = [this](const sim::Frame& f) { frame(f); };
    o.block = [this](const sim::State& s) { block(s); };
    o.interrupted = [this] { return newton_ > m_.budget; };
    return o;
  }

  void finish() {
    if (largest_force_ > 0.0) out_.balance = left_over_ / largest_force_;
    out_.multiplier = largest_multiplier_ > 0.0 ? smallest_multiplier_ / largest_multiplier_ : 0.0;
  }

 private:
  /// No loads but those of the supports: they must cancel.
  void increment(const sim::IncrementRecord& r) {
    Vec2 sum = Vec2::Zero();
    for (const Vec2& f : r.support_forces) {
      sum += f;
      largest_force_ = std::max(largest_force_, f.norm());
    }
    left_over_ = std::max(left_over_, sum.norm());
    newton_ += r.newton;
    out_.newton_most = std::max(out_.newton_most, r.newton);
  }

  void multiplier(double value) {
    smallest_multiplier_ = std::min(smallest_multiplier_, value);
    largest_multiplier_ = std::max(largest_multiplier_, value);
  }

  void frame(const sim::Frame& f) {
    for (const auto& surface : f.surfaces)
      if (surface.side == sim::Side::secondary)
        for (double p : surface.pressure_MPa) multiplier(p);
  }

  /// Supports and contact must hold each body, on the shape that wear has left.
  void block(const sim::State& state) {
    const auto kept = sim::system_of(p_, state, cache_);
    const auto& system = *kept;
    const auto& step = p_.scene.steps[std::min<std::size_t>(state.step, p_.scene.steps.size() - 1)];
    auto controls = sim::controls_at(p_, system, state.factors, step, 1.0, 1.0, 1.0);
    sim::count_from_renewal(controls, p_, system, state);
    const auto forces = sim::support_forces(p_, system, solver::reactions(system, state.solution, controls));
    std::vector<Vec2> sum(p_.inputs.size(), Vec2::Zero());
    for (std::size_t s = 0; s < forces.size(); ++s) sum[p_.support_body[s]] += forces[s];
    for (std::size_t c = 0; c < system.contacts.size(); ++c) {
      const auto& contact = state.solution.contacts[c];
      for (std::size_t j = 0; j < contact.lambda.size(); ++j) {
        sum[p_.contacts[c].secondary.body] -= contact.reference[j].carried() * contact.lambda[j];
        for (const auto& [l, M] : contact.reference[j].M)
          sum[system.contacts[c].primary_nodes[l].body] += M * contact.lambda[j];
        multiplier(contact.lambda[j].dot(contact.normal[j]));
      }
    }
    for (const Vec2& f : sum) left_over_ = std::max(left_over_, f.norm());
  }

  const sim::Problem& p_;
  const Member& m_;
  Played& out_;
  sim::Cache cache_;
  long newton_ = 0;
  double left_over_ = 0.0, largest_force_ = 0.0, smallest_multiplier_ = 0.0, largest_multiplier_ = 0.0;
};

std::vector<double> figures_of(const sim::ContactSummary& c, const Units& u) {
  const double pressure = u.force / (u.length * u.length), force = u.force / u.length, energy = u.force,
               length = u.length;
  return {c.peak_pressure_MPa.value_or(0.0) / pressure,
          c.normal_force / force,
          c.tangential_force / force,
          c.dissipated_energy / energy,
          c.secondary.max_depth_mm / length,
          c.primary.max_depth_mm / length,
          c.secondary.worn_area / (length * length),
          c.primary.worn_area / (length * length)};
}

}  // namespace

Played play(const Member& member) {
  Played out;
  try {
    const auto problem = prepared(member);
    auto state = sim::initial_state(problem);
    Watch watch(problem, member, out);
    const auto summary = sim::run(problem, state, watch.observer());
    watch.finish();
    out.status = summary.status == sim::RunStatus::done     ? "done"
                 : summary.status == sim::RunStatus::failed ? "failed"
                                                            : "over budget";
    out.reason = summary.reason;
    out.increments = summary.counts.increments;
    out.newton = summary.counts.newton_iterations + summary.counts.equilibrium_iterations;
    out.factorisations = summary.counts.factorisations;
    out.cutbacks = summary.counts.cutbacks;
    out.remeshes = summary.counts.remeshes;
    out.cpu_s = summary.cpu_s;
    if (!summary.contacts.empty()) {
      out.ledger = summary.contacts[0].ledger_relative_error.value_or(0.0);
      out.figures = figures_of(summary.contacts[0], member.units);
    }
  } catch (const base::InputError& error) {
    out.status = "refused";
    out.reason = error.what();
  } catch (const base::MeshError& error) {
    out.status = "refused";
    out.reason = error.what();
  }
  return out;
}

double difference(const Played& a, const Played& b) {
  double worst = a.figures.size() == b.figures.size() ? 0.0 : 1.0;
  for (std::size_t i = 0; i < std::min(a.figures.size(), b.figures.size()); ++i) {
    // Shear may vanish: it is measured against the normal force before it.
    const double scale = i == 2 ? std::abs(b.figures[1]) : std::abs(b.figures[i]);
    const double by = std::abs(a.figures[i] - b.figures[i]);
    if (by > 0.0) worst = std::max(worst, by / scale);
  }
  return worst;
}

}  // namespace reye::test
