#include "shown.hpp"

#include <cstdio>
#include <optional>

#include "base/printable.hpp"
#include "progress_line.hpp"
#include "signals.hpp"

namespace reye::apps {

namespace {

template <class Scene>
auto run_and_show(const Request& request, const Scene& scene, const std::string& dir) {
  ignore_lost_output();
  std::optional<StopSignals> stop;
  ProgressLine line(!request.quiet);
  RunWatch watch;
  watch.begins = [&](const std::vector<std::string>& plan, const std::vector<std::string>& warnings) {
    if (!request.quiet) {
      tell_lines(plan);
      std::fflush(stdout);  // a file or a pipe shows them during the run
      tell_warnings(warnings);
    }
    stop.emplace(true);
  };
  watch.progress = [&](const sim::Progress& p) { line.show(p); };
  watch.interrupted = [] { return StopSignals::count() > 0; };
  watch.note = [](const std::string& text) { std::fprintf(stderr, "%s\n", base::printable(text).c_str()); };
  const auto result = run(scene, {dir, request.restart, request.force}, watch);
  line.end();
  return result.summary;
}

}  // namespace

void tell_lines(const std::vector<std::string>& lines) {
  for (const auto& text : lines) std::printf("%s\n", base::printable(text).c_str());
}

void tell_warnings(const std::vector<std::string>& warnings) {
  for (const auto& text : warnings) std::fprintf(stderr, "warning: %s\n", base::printable(text).c_str());
}

void tell_end(const std::vector<std::string>& warnings, const std::string& reason) {
  tell_warnings(warnings);
  if (!reason.empty()) std::fprintf(stderr, "reye: %s\n", base::printable(reason).c_str());
}

int code_of(sim::RunStatus status) {
  return status == sim::RunStatus::done ? 0 : status == sim::RunStatus::failed ? 1 : 130;
}

sim::Summary shown_run(const Request& request, const scene::Scene& scene, const std::string& dir) {
  return run_and_show(request, scene, dir);
}

sim::SolidSummary shown_run(const Request& request, const scene::SolidScene& scene, const std::string& dir) {
  return run_and_show(request, scene, dir);
}

}  // namespace reye::apps
