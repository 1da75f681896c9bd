#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "base/formatted.hpp"
#include "scene/names.hpp"
#include "scene/nearest.hpp"
#include "scene/validate.hpp"

namespace reye::scene {

void refer(const Entry& entry, std::string_view key, const std::string& what, const NameList& names, Issues& issues) {
  const auto name = entry.text(key);
  if (name.empty() || holds(names, name)) return;
  issues.push_back({entry.key(key), entry.written(key), unknown_name_rule(what, name, names)});
}

namespace {

void check_play(const Entry& step, const NameList& histories, Issues& issues) {
  std::set<std::string> seen;
  for (const auto& name : step.texts("play")) {
    if (!holds(histories, name))
      issues.push_back({step.key("play"), step.written("play"), unknown_name_rule("history", name, histories)});
    if (!seen.insert(name).second)
      issues.push_back({step.key("play"), step.written("play"), "names \"" + name + "\" twice"});
  }
}

}  // namespace

void check_plays(const Entry& root, const NameList& histories, Issues& issues) {
  std::set<std::string> seen;
  for (const auto& step : root.all("step")) {
    check_play(step, histories, issues);
    if (step.given("name") && !seen.insert(step.text("name")).second)
      issues.push_back({step.key("name"), step.written("name"), "another step has this name"});
  }
  if (!root.given("step")) issues.push_back({"step", "", "missing; a scene has at least one [[step]]"});
}

std::string open_cycle_rule(const std::string& name, const std::vector<std::array<double, 2>>& corners, bool measured) {
  const double start = corners.front()[1], end = corners.back()[1];
  if (start == end) return {};
  std::ostringstream text;
  text << "history \"" << name << "\" ends a cycle at " << end << " and began it at " << start
       << "; give it the way back: ";
  if (measured)
    text << "close = true in its table";
  else
    text << "a last corner [1, " << start << ']';
  return text.str();
}

void warn_of_idle(const Entry& root, const Played& played, const std::set<std::string>& acting, Issues& found) {
  std::set<std::string> in_steps;
  for (const auto& step : played.steps) in_steps.insert(step.play.begin(), step.play.end());
  for (const auto& [name, history] : played.histories) {
    const auto key = root.at("history").key(name);
    if (!in_steps.count(name)) found.push_back({key, "", "no step plays it; its factor stays 0"});
    if (!acting.count(name)) found.push_back({key, "", "no support, load or imposed sliding names it"});
  }
}

/// Warns of what thinning has taken from a measured history, and of a duration that is not its own.
void warn_of_measured(const Entry& root, const std::map<std::string, Measured>& all, Issues& found) {
  constexpr double least = 0.02, off = 0.01;
  for (const auto& entry : root.all("history")) {
    const auto at = all.find(entry.name());
    if (at == all.end()) continue;
    const auto& measured = at->second;
    if (measured.way_lost > std::max(least, measured.tolerance))
      found.push_back({entry.key("file"), entry.written("file"),
                       base::formatted("its way up and down is %.3g %% shorter without the oscillations below %g %% of "
                                       "its range: where they slide, wear is less by as much; write a smaller "
                                       "tolerance, or smooth them if they are noise",
                                       100.0 * measured.way_lost, 100.0 * measured.tolerance)});
    for (const auto& step : root.all("step")) {
      const auto play = step.texts("play");
      const double period = step.number("period_s"), own = measured.duration_s;
      if (period == 0.0 || own == 0.0 || std::abs(period - own) <= off * own) continue;
      if (std::find(play.begin(), play.end(), entry.name()) != play.end())
        found.push_back({step.key("period_s"), step.written("period_s"),
                         base::formatted("history \"%s\" was measured over %.4g s", entry.name().c_str(), own)});
    }
  }
}

}  // namespace reye::scene
