#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>

#include "scene/scene.hpp"

/// The output folder and whose run it holds.
namespace reye::output {

/// What the marker in the folder says of its run; enough for a report of a run that was killed.
struct Identity {
  std::string name, title, sha256;
  base::Analysis analysis = base::Analysis::plane_strain;
  std::map<std::string, std::optional<double>> friction;  ///< by contact; empty where it changes over the cycles
  std::map<std::string, std::array<std::string, 2>>
      sides{};                               ///< by contact: secondary and primary edges with their bodies
  std::string fixed_sha256{}, scene_text{};  ///< by which an extension of the run is known
};

Identity identity_of(const scene::Scene& scene);

/// The run the folder holds; empty when there is no readable marker.
std::optional<Identity> read_identity(const std::string& dir);

/// Asks whether a run of this scene may go to the folder, there or not; makes, removes and writes nothing.
/// A run belongs to the same scene when scene and geometry files have the same hash.
/// Returns why not, or nothing when it may. `force` takes over a folder that holds something else, but not through a
/// symbolic link, and none that is being written to.
std::optional<std::string> open_folder(const std::string& dir, const std::string& name, const std::string& sha256,
                                       bool force);

/// Takes the folder over: once the new marker is safely on disk, the results of the former run go.
/// Files that a run does not write are left alone.
void claim_folder(const std::string& dir, const Identity& identity);

/// Says whose the folder is, its results left as they are: an extension of the run that wrote them resumes there.
void mark_folder(const std::string& dir, const Identity& identity);

/// Removes what a killed run left half written under temporary names.
void remove_temporaries(const std::string& dir);

}  // namespace reye::output
