#include "session.hpp"

#include <chrono>

#include "algebra/blas.hpp"
#include "base/cores.hpp"
#include "base/errors.hpp"
#include "output/report/run_data.hpp"
#include "runs/calibrate.hpp"
#include "runs/run.hpp"
#include "runs/words.hpp"
#include "scene/key_rule.hpp"
#include "scene/located.hpp"
#include "scene/read.hpp"
#include "scene/rewrite.hpp"
#include "scene/solid/solid_keys.hpp"
#include "scene/solid/solid_located.hpp"
#include "sim/study/forecast.hpp"
#include "sim/study/prepare.hpp"
#include "sim/study/solid_accuracy.hpp"

namespace reye::apps {

namespace {

/// Calls `work` with the scene of the kind that the text says.
template <class Work>
auto with_scene(const Text& text, const Work& work) {
  const auto call = [&](auto scene) {
    scene.geometry.trusted = text.trust_geometry;
    return work(std::move(scene));
  };
  return scene::is_solid_text(text.text) ? call(scene::read_solid_text(text.text, text.path))
                                         : call(scene::read_text(text.text, text.path));
}

/// Cores of the process while it computes; algebra has one thread meanwhile, and as many as before afterwards.
struct Machine {
  explicit Machine(int threads) : cores(threads > 0 ? threads : base::physical_cores()) {}
  const algebra::SingleThread algebra;
  const base::Cores cores;
};

template <class Scene>
double all_cycles(const Scene& scene) {
  double cycles = 0.0;
  for (const auto& step : scene.steps) cycles += step.cycles;
  return cycles;
}

SessionPlan planned(const scene::Scene& scene, double trial_s) {
  using clock = std::chrono::steady_clock;
  const auto start = clock::now();
  sim::Cache cache;
  const sim::Problem problem = sim::prepare(scene, &cache);
  SessionPlan plan{problem.plan.lines, problem.plan.skipped, in_words(problem.scene, problem.warnings), {}, {}};
  if (!(trial_s > 0.0)) return plan;
  const double prepared_s = std::chrono::duration<double>(clock::now() - start).count();
  const auto f = sim::forecast(problem, cache, trial_s, prepared_s);
  plan.in_words = sim::in_words(f);
  plan.forecast = {{"blocks", f.blocks}, {"cycles", f.cycles}, {"increments", f.increments}};
  if (f.unknown.empty()) plan.forecast.insert({{"seconds", f.seconds}, {"spread", f.spread}});
  plan.forecast["memory_MB"] = f.memory_MB;
  return plan;
}

SessionPlan planned(const scene::SolidScene& scene, double) {
  const sim::SolidProblem problem = sim::prepare(scene);
  const sim::SolidPlan plan = sim::solid_plan(problem);
  refuse_what_does_not_fit(plan);
  return {plan.lines, {}, in_words(problem.warnings), {}, {{"increments", plan.increments}}};
}

SessionCheck checked(const scene::Scene& scene) {
  const sim::Problem problem = sim::prepare(scene);
  auto lines = body_lines(problem);
  lines.insert(lines.end(), problem.plan.lines.begin(), problem.plan.lines.end());
  return {std::move(lines), in_words(problem.scene, problem.warnings)};
}

SessionCheck checked(const scene::SolidScene& scene) {
  const sim::SolidProblem problem = sim::prepare(scene);
  const sim::SolidPlan plan = sim::solid_plan(problem);
  refuse_what_does_not_fit(plan);
  auto lines = body_lines(problem);
  lines.insert(lines.end(), plan.lines.begin(), plan.lines.end());
  return {std::move(lines), in_words(problem.warnings)};
}

base::InputError located(const Text& scene, const base::Issue& issue) {
  return scene::located({issue}, scene::lines_of(scene::document_of(scene.text, scene.path)), scene.path);
}

}  // namespace

void read(const Text& scene) {
  with_scene(scene, [](const auto&) {});
}

SessionRun run(const Text& text, const RunPlace& place, int threads, const SessionWatch& watch) {
  return with_scene(text, [&](const auto& scene) {
    const Machine machine(threads);
    const double cycles = all_cycles(scene);
    SessionRun session;
    sim::Progress last;
    RunWatch inner;
    inner.begins = [&](const auto&, const auto&) { watch.begins(); };
    inner.progress = [&](const sim::Progress& p) { last = p; };
    inner.block = [&](double cycle) {
      watch.block({last.step, cycle, cycles, last.fraction, last.depth_max_mm, last.solved, last.to_be_solved});
    };
    inner.interrupted = watch.interrupted;
    inner.note = [&](const std::string& note) { session.notes.push_back(note); };
    session.tables = run(scene, place, inner).tables;
    return session;
  });
}

SessionCalibration calibrate(const Text& text, const CalibrateRequest& request, int threads,
                             const std::function<bool()>& interrupted) {
  return with_scene(text, [&](const auto& scene) {
    const Machine machine(threads);
    const auto result = calibrate(scene, request, {nullptr, interrupted});
    SessionCalibration session{calibration_folder(scene.name, request), result.failure, result.measured.warnings};
    if (!result.estimate.poor.empty()) session.warnings.push_back("the fit is poor: " + result.estimate.poor);
    for (const auto& text : in_words(result.warnings)) session.warnings.push_back(text);
    return session;
  });
}

SessionPlan plan(const Text& text, double trial_s, int threads) {
  return with_scene(text, [&](const auto& scene) {
    const Machine machine(threads);
    return planned(scene, trial_s);
  });
}

SessionCheck check(const Text& text) {
  return with_scene(text, [](const auto& scene) {
    const Machine machine(1);
    return checked(scene);
  });
}

std::string rule_of_key(const Text& scene, const std::string& key) {
  const auto& keys = scene::is_solid_text(scene.text) ? scene::solid_spec() : scene::spec();
  return scene::key_rule(key, scene::document_of(scene.text, scene.path), keys);
}

std::string text_with(const Text& scene, const std::string& key, const std::string& value) {
  if (const auto rule = rule_of_key(scene, key); !rule.empty()) throw located(scene, {key, "", rule});
  auto changed = scene::with_value(scene.text, key, value);
  if (!changed) throw located(scene, {key, value, "cannot be put there"});
  return std::move(*changed);
}

std::vector<Column> columns_of(const std::string& csv) {
  auto table = output::parse_csv(csv);
  std::vector<Column> columns;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    Column column{table.columns[c], std::move(table.values[c]), {}};
    if (output::is_text_column(column.name)) {
      for (const double cell : column.numbers) column.texts.push_back(table.word(cell));
      column.numbers.clear();
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

}  // namespace reye::apps
