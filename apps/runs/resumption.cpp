#include "runs/resumption.hpp"

#include <stdexcept>

#include "base/printable.hpp"
#include "output/run/commit.hpp"

namespace reye::apps {

namespace {

[[noreturn]] void refuse(const std::string& dir, const std::vector<std::string>& refusals) {
  std::string reasons;
  for (const auto& refusal : refusals) reasons += (reasons.empty() ? "" : "; ") + refusal;
  throw base::InputError({{"--restart", dir, "no checkpoint to resume from: " + reasons}});
}

/// The newest state is asked first whether it may resume so; where it has ended or is within a block, the run resumes
/// from the one before.
output::CheckpointSearch search_extended(const std::string& dir, const Reading& reading) {
  output::Origin origin = reading.own;
  origin.scene_sha256.clear();
  std::vector<base::Issue> issues;
  const auto extended = [&](const output::Checkpoint& checkpoint) { issues = reading.extend(checkpoint); };
  auto newest = output::load_checkpoint(dir, origin, extended);
  if (!issues.empty()) throw reading.located(issues);
  const auto fits = [&](const output::Checkpoint& checkpoint) {
    return !checkpoint.ended && reading.standing() == Standing::between_blocks;
  };
  if (!newest.found || fits(*newest.found)) return newest;
  auto before = output::load_checkpoint(dir, origin, [&](const output::Checkpoint& checkpoint) {
    extended(checkpoint);
    if (!fits(checkpoint)) throw std::runtime_error("the run ended with it, or was within a block");
  });
  if (before.found) before.refusals = newest.refusals;
  return before;
}

bool can_resume(const std::string& dir, const output::Origin& own) {
  return output::load_checkpoint(dir, own).found.has_value();
}

}  // namespace

Resumption resumption_of(const std::string& dir, const Reading& reading,
                         const std::optional<scene::Extension>& extension) {
  const auto search =
      extension ? search_extended(dir, reading) : output::load_checkpoint(dir, reading.own, reading.resume);
  if (!search.found) refuse(dir, search.refusals);
  Resumption resumption{search.found->counters, search.previous, extension.has_value(), search.refusals};
  if (const auto& commit = search.found->origin.commit; commit != output::commit())
    resumption.notes.push_back("written by the build of commit " + base::printable(commit) +
                               ", resumed by that of commit " + output::commit() +
                               ": results may differ in their last digits from an unbroken run");
  return resumption;
}

std::optional<output::Identity> extensible_run(const std::string& dir, const std::string& name,
                                               const std::string& sha256, const std::string& fixed_sha256) {
  auto holder = output::read_identity(dir);
  if (!holder || holder->sha256 == sha256 || holder->scene_text.empty()) return {};
  if (holder->fixed_sha256 != fixed_sha256 && holder->name != name) return {};
  return holder;
}

void open_or_refuse(const std::string& dir, const std::string& name, const std::string& sha256, bool extends,
                    bool force) {
  const std::string held = extends ? output::read_identity(dir)->sha256 : sha256;
  if (const auto refusal = output::open_folder(dir, name, held, force))
    throw base::InputError({{"--out", dir, *refusal}});
}

void accept(const std::string& dir, const Resumption& resumption, const RunWatch& watch) {
  for (const auto& note : resumption.notes)
    if (watch.note) watch.note("checkpoint: " + note);
  if (resumption.previous) output::restore_previous(dir);
}

void play_guarded(const std::string& dir, const output::Origin& own, const std::function<void()>& play) {
  try {
    play();
  } catch (const std::exception& error) {
    throw std::runtime_error(
        error.what() + std::string(can_resume(dir, own) ? "; the last checkpoint is intact: --restart resumes from it"
                                                        : "; there is no checkpoint to resume from"));
  }
}

}  // namespace reye::apps
