#pragma once
#include <string>

/// The commands of `reye`; each returns the exit code of the contract: 0 done, 1 failed, 2 bad input, 130 interrupted.
namespace reye::apps {

struct Request {
  std::string path;  ///< scene file, or output folder for `report`
  std::string out;
  std::string picture;   ///< file for a picture of the scene; empty: none
  double trial_s = 2.0;  ///< how long `plan` plays the run to judge its time; 0: not at all
  int threads = 0;       ///< cores to compute on; 0: all physical ones
  bool restart = false, force = false, quiet = false, animation = false;
  bool trust_geometry = false;  ///< geometry scripts may use all of gmsh's language
};

std::string version();

/// The table of scene keys, of plane scenes or of solids, as markdown: the tables in geo/REFERENCE.md.
std::string reference(bool of_solids);

/// The JSON Schema of scenes: geo/scene.schema.json.
std::string schema();

int run(const Request& request);
int plan(const Request& request);
int check(const Request& request);
int mesh(const Request& request);
int report(const Request& request);

}  // namespace reye::apps
