#include "runs/sweep.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <thread>

#include "base/errors.hpp"
#include "cad/part/beside.hpp"
#include "output/folder/files.hpp"
#include "output/folder/folder.hpp"
#include "output/folder/folder_lock.hpp"
#include "output/run/sweep_page.hpp"
#include "output/run/sweep_table.hpp"
#include "runs/children.hpp"
#include "scene/read.hpp"
#include "scene/solid/solid_keys.hpp"
#include "scene/solid/solid_located.hpp"
#include "scene/sweep.hpp"

namespace reye::apps {

namespace fs = std::filesystem;

namespace {

/// A member and its folder.
struct Place {
  std::string name, dir, sha256;
};

/// What a sweep needs of a scene of any kind.
struct SceneHead {
  std::string name, title, sha256;
};

SceneHead head_of(const std::string& text, const std::string& path) {
  const auto head = [](const auto& scene) { return SceneHead{scene.name, scene.title, scene.sha256}; };
  return scene::is_solid_text(text) ? head(scene::read_solid_text(text, path)) : head(scene::read_text(text, path));
}

struct Job {
  const SweepRequest& request;
  std::string dir, title;
  scene::Sweep sweep;
  std::vector<Place> places;  ///< one per member
  std::vector<std::size_t> wanted;
};

std::string name_of(std::size_t member) {
  const auto number = std::to_string(member);
  return "member_" + std::string(number.size() < 3 ? 3 - number.size() : 0, '0') + number;
}

/// The file in which a member reports why it stopped.
std::string errors_of(const Place& place) { return place.dir + "/errors.txt"; }

/// The file in which Slurm, or the program before the member's run begins, reports why there is none.
constexpr auto slurm_file = "slurm.txt";
std::string slurm_words_of(const Place& place) { return place.dir + '/' + slurm_file; }

/// Issues of one member, named after it; those that another member has already are left out.
void add_issues(const std::string& member, const std::vector<base::Issue>& found, std::set<std::string>& told,
                std::vector<base::Issue>& issues) {
  for (const auto& issue : found) {
    const auto rule = issue.key + (issue.value.empty() ? "" : " = " + issue.value) + ": " + issue.rule;
    if (told.insert(rule).second) issues.push_back({member, "", rule});
  }
}

/// Reads every wanted member as it will be on disk and checks that its folder may be used.
void check_members(Job& job, const std::string& name) {
  std::vector<base::Issue> issues;
  std::set<std::string> told;
  // A member by itself has a folder of its own below; the sweep that submitted it holds that of all.
  if (const auto refusal = job.request.table || job.request.member >= 0
                               ? std::nullopt
                               : output::open_folder(job.dir, name, "", job.request.force))
    issues.push_back({"--out", job.dir, *refusal});
  for (const auto i : job.wanted) {
    auto& place = job.places[i];
    try {
      place.sha256 = head_of(job.sweep.members[i].text, place.dir + "/scene.toml").sha256;
    } catch (const base::InputError& error) {
      add_issues(place.name, error.issues(), told, issues);
      continue;
    }
    if (!issues.empty() || job.request.table) continue;  // `--table` only reads
    if (fs::is_symlink(place.dir))
      issues.push_back({place.name, "", place.dir + " is a symbolic link, which a sweep does not follow"});
    else if (const auto refusal = output::open_folder(place.dir, place.name, place.sha256, job.request.force))
      issues.push_back({place.name, "", *refusal});
  }
  if (!issues.empty()) throw base::InputError(std::move(issues));
}

Job job_of(const SweepRequest& request) {
  if (request.slurm && !is_installed("sbatch"))
    throw base::InputError({{"--slurm", "", "there is no sbatch in PATH; Slurm is not installed here"}});
  const auto text = request.text ? *request.text : scene::text_of(request.path);
  const auto scene = head_of(text, request.path);
  const auto& keys = scene::is_solid_text(text) ? scene::solid_spec() : scene::spec();
  const auto dir = request.out.empty() ? "./" + scene.name + ".sweep" : request.out;
  Job job{request, dir, scene.title, scene::sweep_of(text, request.path, request.vary, keys), {}, {}};
  const auto count = job.sweep.members.size();
  for (std::size_t i = 0; i < count; ++i) job.places.push_back({name_of(i), dir + '/' + name_of(i), {}});
  if (request.member >= static_cast<int>(count)) {
    const auto rule = "the sweep has members 0 to " + std::to_string(count - 1);
    throw base::InputError({{"--member", std::to_string(request.member), rule}});
  }
  for (std::size_t i = 0; i < count; ++i)
    if (request.member < 0 || static_cast<std::size_t>(request.member) == i) job.wanted.push_back(i);
  check_members(job, scene.name);
  return job;
}

/// The text of a file, empty where it cannot be read.
std::string text_in(const std::string& file) {
  std::error_code unreadable;
  if (!fs::is_regular_file(file, unreadable)) return {};
  try {
    return output::read_text(file);
  } catch (const std::runtime_error&) {
    return {};
  }
}

/// The message of a member when it stopped, else that of the job which should have run it.
std::string said_by(const Place& place) {
  const auto message = text_in(errors_of(place));
  return message.empty() ? text_in(slurm_words_of(place)) : message;
}

/// The end of this very member; a summary of another scene in its folder is not its own.
output::RunEnd end_of(const Place& place) {
  auto end = output::read_end(place.dir);
  if (end.status != "damaged" && end.sha256 != place.sha256) end = {};
  if (end.status == "missing") end.reason = said_by(place);
  return end;
}

/// An interrupted run resumes from its last checkpoint.
bool can_go_on(const Place& place, const output::RunEnd& end) {
  const auto holder = output::read_identity(place.dir);
  const bool its_own = holder && holder->sha256 == place.sha256;
  const auto kept = [&](const char* name) { return fs::exists(place.dir + "/checkpoint/" + name); };
  return its_own && end.status != "failed" && (kept("current.bin") || kept("previous.bin"));
}

void write_scene(const Job& job, std::size_t i) {
  const auto file = job.places[i].dir + "/scene.toml";
  fs::create_directories(job.places[i].dir);
  if (!fs::exists(file) || output::read_text(file) != job.sweep.members[i].text)
    output::atomic_write(file, job.sweep.members[i].text);
}

/// The command: this program, or the one that was installed with this module.
std::string command() { return cad::beside_program("reye"); }

Child child_of(const Job& job, std::size_t i) {
  const auto& place = job.places[i];
  Child child{{command(), "run", place.dir + "/scene.toml", "--out", place.dir, "--threads", "1", "--quiet"},
              errors_of(place)};
  if (job.request.trust_geometry) child.words.push_back("--trust-geometry");
  if (job.request.force)
    child.words.push_back("--force");
  else if (can_go_on(place, end_of(place)))
    child.words.push_back("--restart");
  return child;
}

/// Runs members not yet done in separate processes, so that a crash ends one member alone. False when interrupted.
bool run_here(const Job& job, const std::vector<std::size_t>& open, const SweepWatch& watch) {
  std::vector<Child> children;
  for (const auto i : open) children.push_back(child_of(job, i));
  const auto cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::size_t count = 0;
  const auto ended = [&](std::size_t c, int code) {
    const auto& place = job.places[open[c]];
    if (code == 127) output::append_text(errors_of(place), "could not be started\n");
    if (code > 128 && code != 130)
      output::append_text(errors_of(place), "ended by signal " + std::to_string(code - 128) + '\n');
    const auto of = " (" + std::to_string(++count) + " of " + std::to_string(open.size()) + ')';
    if (watch.ended) watch.ended(place.name + ' ' + end_of(place).status + of);
  };
  return run_children(children, job.request.jobs > 0 ? job.request.jobs : cores, ended, watch.stops);
}

std::string shell_quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + '\'';
}

/// The file of each job of the array for what Slurm reports: %3a is the member's number with three digits or more.
std::string slurm_output(const Job& job) {
  std::string text;
  for (const char c : fs::absolute(job.dir).string()) text += c == '%' ? std::string("%%") : std::string(1, c);
  return shell_quoted(text + "/member_%3a/" + slurm_file);
}

/// An array of jobs, one per open member.
std::string slurm_script(const Job& job, const std::vector<std::size_t>& open) {
  std::string array;
  for (const auto i : open) array += (array.empty() ? "" : ",") + std::to_string(i);
  if (open.size() == job.places.size()) array = "0-" + std::to_string(open.size() - 1);
  if (job.request.jobs > 0) array += '%' + std::to_string(job.request.jobs);
  std::string text = "#!/bin/bash\n#SBATCH --job-name=reye-sweep\n#SBATCH --array=" + array +
                     "\n#SBATCH --ntasks=1\n#SBATCH --cpus-per-task=1\n#SBATCH --output=" + slurm_output(job) + '\n';
  text += "exec " + shell_quoted(command()) + " sweep " + shell_quoted(fs::absolute(job.request.path));
  for (const auto& words : job.request.vary) text += " --vary " + shell_quoted(words);
  text += " --out " + shell_quoted(fs::absolute(job.dir)) + (job.request.force ? " --force" : "") +
          (job.request.trust_geometry ? " --trust-geometry" : "");
  return text + " --quiet --member \"$SLURM_ARRAY_TASK_ID\"\n";
}

/// Submits the array and waits for its end; the results of members are read from their folders.
bool run_by_slurm(const Job& job, const std::vector<std::size_t>& open, const SweepWatch& watch) {
  std::error_code kept;  // what an earlier job left, if anything
  for (const auto i : open)
    for (const auto& file : {errors_of(job.places[i]), slurm_words_of(job.places[i])}) fs::remove(file, kept);
  const auto script = job.dir + "/sweep.sbatch";
  output::atomic_write(script, slurm_script(job, open));
  return run_children(
      {{{"sbatch", "--wait", script}, ""}}, 1, [](std::size_t, int) {}, watch.stops);
}

/// "contact.pad.friction = 0.5, step[1].jump = 100"
std::string values_of(const Job& job, std::size_t i) {
  std::string text;
  for (std::size_t k = 0; k < job.sweep.keys.size(); ++k)
    text += (k == 0 ? "" : ", ") + job.sweep.keys[k] + " = " + job.sweep.members[i].values[k];
  return text;
}

/// The members that are not done, one line each.
std::vector<std::string> undone_members(const Job& job) {
  std::vector<std::string> lines;
  for (const auto i : job.wanted) {
    const auto end = end_of(job.places[i]);
    if (end.status == "done") continue;
    auto reason = end.reason;
    while (!reason.empty() && reason.back() == '\n') reason.pop_back();
    lines.push_back(job.places[i].name + " (" + values_of(job, i) + "): " + end.status +
                    (reason.empty() ? "" : ": " + reason));
  }
  return lines;
}

/// Writes table and page; the range of lives.
std::vector<std::string> collect(const Job& job) {
  std::vector<output::SweepRow> rows;
  for (const auto i : job.wanted)
    rows.push_back({job.places[i].name, job.sweep.members[i].values, end_of(job.places[i])});
  fs::create_directories(job.dir);
  output::atomic_write(job.dir + "/sweep.csv", output::sweep_table(job.sweep.keys, rows));
  output::atomic_write(job.dir + "/sweep.html", output::sweep_page(job.title, job.sweep.keys, rows));
  return output::life_bands(rows);
}

}  // namespace

SweepResult sweep(const SweepRequest& request, const SweepWatch& watch) {
  const auto job = job_of(request);
  std::optional<output::FolderLock> lock;
  if (!request.table && request.member < 0) lock.emplace(job.dir);
  std::vector<std::size_t> open;
  for (const auto i : job.wanted)
    if (request.force || end_of(job.places[i]).status != "done") open.push_back(i);
  SweepResult result{job.dir, job.wanted.size(), {}, {}, false};
  if (!request.table && !open.empty()) {
    for (const auto i : open) write_scene(job, i);
    result.interrupted = !(request.slurm ? run_by_slurm(job, open, watch) : run_here(job, open, watch));
  }
  result.undone = undone_members(job);
  if (request.member < 0) result.life_bands = collect(job);
  return result;
}

}  // namespace reye::apps
