#pragma once
#include "cad/part/importer_process.hpp"
#include "cad/solid/raw_solid.hpp"
#include "cad/solid/solid_options.hpp"

namespace reye::cad {

/// A file of solids with the importer that has it open, in a process of its own.
class SolidFile {
 public:
  /// Starts the importer. Throws std::runtime_error where there is none.
  SolidFile(std::string path, const SolidGeometryOptions& options);

  /// The solids of the file; none, and issues, where it cannot be used. Asked once.
  std::vector<RawSolid> solids(const Points3& probes, std::vector<base::Issue>& issues);

  /// The mesh of one of them, whose skin has so many faces. Throws base::MeshError with the reason why there is none.
  RawSolidMesh mesh(const SolidOrder& order, std::size_t faces);

  const std::string& path() const { return path_; }
  bool guarded() const { return guarded_; }

 private:
  /// Words of the importer, with its path of the file as this program knows it.
  std::string as_known(std::string text) const;

  std::string path_;
  bool trusted_ = false, guarded_ = true;
  ImporterProcess importer_;
};

}  // namespace reye::cad
