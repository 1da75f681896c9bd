#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>

#include "scene/scene.hpp"

/// The output folder and the run it holds.
namespace reye::output {

/// The data of its run in the folder's marker, enough for a report of a run that was killed.
struct Identity {
  std::string name, title, sha256;
  base::Analysis analysis = base::Analysis::plane_strain;
  std::map<std::string, std::optional<double>> friction;  ///< by contact; empty where it changes
  std::map<std::string, std::array<std::string, 2>>
      sides{};                               ///< by contact: secondary and primary edges with their bodies
  std::string fixed_sha256{}, scene_text{};  ///< by which an extension of the run is recognised
  bool solid = false;                        ///< a run of solids: `analysis` does not count
};

Identity identity_of(const scene::Scene& scene);

/// The run the folder holds; empty when there is no readable marker.
std::optional<Identity> read_identity(const std::string& dir);

/// Checks whether a run of this scene may use the folder, which need not exist; makes, removes and writes nothing.
/// A run belongs to the same scene when scene and geometry files have the same hash.
/// Returns why not, or nothing when it may. `force` allows a folder that holds another run, except through a symbolic
/// link or while a run writes to it.
std::optional<std::string> open_folder(const std::string& dir, const std::string& name, const std::string& sha256,
                                       bool force);

/// Takes the folder over: once the new marker is safely on disk, the results of the former run are removed.
/// Files that a run does not write are left alone.
void claim_folder(const std::string& dir, const Identity& identity);

/// Writes the marker and keeps the results: an extension of the run that wrote them resumes there.
void mark_folder(const std::string& dir, const Identity& identity);

/// Removes half-written temporary files of a killed run.
void remove_temporaries(const std::string& dir);

}  // namespace reye::output
