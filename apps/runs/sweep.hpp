#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// A sweep: many members of one scene, here or through Slurm, and one table of them.
namespace reye::apps {

struct SweepRequest {
  std::string path;                 ///< scene file
  std::optional<std::string> text;  ///< in place of what the scene file holds
  std::vector<std::string> vary;    ///< as in scene::variation_of
  std::string out;
  int jobs = 0;     ///< members at once; 0: as many as there are cores, or as Slurm allows
  int member = -1;  ///< the only member to run, as a job of an array does
  bool slurm = false, table = false, force = false;
  bool trust_geometry = false;  ///< passed on to every member
};

/// Callbacks that observe a sweep and may stop it.
struct SweepWatch {
  std::function<void(const std::string&)> ended;  ///< "member_000 done (1 of 6)"
  std::function<int()> stops;                     ///< how often a stop has been asked for
};

struct SweepResult {
  std::string dir;
  std::size_t members = 0;
  std::vector<std::string> undone;      ///< a line per member that is not done, with its values and the reason
  std::vector<std::string> life_bands;  ///< a sentence per limit
  bool interrupted = false;
};

/// Runs the members that are not done yet, each by the command `reye` of this installation, and writes table and page.
/// Bad input is thrown as base::InputError, before anything is written.
SweepResult sweep(const SweepRequest& request, const SweepWatch& watch);

}  // namespace reye::apps
