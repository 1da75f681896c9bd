#pragma once
#include <string>
#include <vector>

/// `reye sweep`: many members of one scene, here or through Slurm, and one table of them.
namespace reye::apps {

struct SweepRequest {
  std::string path;               ///< scene file
  std::vector<std::string> vary;  ///< as in scene::variation_of
  std::string out;
  int jobs = 0;     ///< members at once; 0: as many as there are cores, or as Slurm allows
  int member = -1;  ///< the only member to run, as a job of an array does
  bool slurm = false, table = false, force = false, quiet = false;
  bool trust_geometry = false;  ///< passed on to every member
};

/// 0 when every member is done, 1 when one is not, 130 when interrupted; bad input is thrown as base::InputError.
int sweep(const SweepRequest& request);

}  // namespace reye::apps
