#include "output/run/checkpoint.hpp"

#include <filesystem>
#include <stdexcept>

#include "base/printable.hpp"
#include "output/folder/files.hpp"
#include "output/folder/tables.hpp"
#include "output/folder/text.hpp"
#include "output/run/commit.hpp"
#include "output/run/container.hpp"
#include "output/run/serialize.hpp"

namespace reye::output {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view magic = "REYECKP6";
std::string file_in(const std::string& dir, const char* name) {
  return (fs::path(dir) / "checkpoint" / (std::string(name) + ".bin")).string();
}

/// Checks a table of the folder, which must hold so many rows.
void check_rows(const std::string& dir, const std::string& file, long rows) {
  // The name comes out of a file that may have been altered.
  if (rows < 0 || fs::path(file).filename() != fs::path(file))
    throw std::runtime_error("altered: it counts rows that no table has");
  (void)size_of_rows((fs::path(dir) / file).string(), rows);
}

/// Every table that the counters name, with its rows.
std::map<std::string, long> tables_of(const Counters& counters) {
  auto tables = counters.surface_rows;
  tables["history.csv"] = counters.history_rows;
  if (counters.remesh_rows != 0) tables["remesh.csv"] = counters.remesh_rows;
  return tables;
}

bool same_scene(const Origin& theirs, const Origin& own) {
  return own.scene_sha256.empty() ? theirs.fixed_sha256 == own.fixed_sha256 : theirs.scene_sha256 == own.scene_sha256;
}

/// One candidate, or the reason against it.
Checkpoint candidate(const std::string& dir, const char* name, const Origin& own, const Examine& examine) {
  const std::string path = file_in(dir, name);
  if (!fs::is_regular_file(path)) throw std::runtime_error("missing");
  Checkpoint checkpoint = unpacked(read_text(path), own.layout);
  if (checkpoint.origin.version != own.version)
    throw std::runtime_error("of another version, " + base::printable(checkpoint.origin.version) + " instead of " +
                             own.version);
  if (!same_scene(checkpoint.origin, own)) throw std::runtime_error("of another scene");
  for (const auto& [file, rows] : tables_of(checkpoint.counters)) check_rows(dir, file, rows);
  if (examine) examine(checkpoint);
  return checkpoint;
}

}  // namespace

Origin own_origin(std::uint64_t layout, const std::string& scene_sha256, const std::string& fixed_sha256) {
  return {version, commit(), layout, scene_sha256, fixed_sha256};
}

std::string packed(const Checkpoint& checkpoint) {
  const auto& o = checkpoint.origin;
  return sealed(magic, to_bytes(o.layout, o.commit, o.version, o.scene_sha256, o.fixed_sha256, o.file_sha256,
                                checkpoint.ended, checkpoint.counters, checkpoint.payload));
}

Checkpoint unpacked(const std::string& bytes, std::uint64_t layout) {
  const std::string body = unsealed(magic, bytes, "a checkpoint");
  Checkpoint checkpoint;
  auto& o = checkpoint.origin;
  try {
    BoundedInput archive(body);
    archive(o.layout, o.commit);
    if (o.layout != layout)
      throw std::runtime_error("written by the build of commit " + base::printable(o.commit) +
                               ", whose layout the build of commit " + commit() +
                               " cannot read; resume with a build of that commit, or start a new run");
    archive(o.version, o.scene_sha256, o.fixed_sha256, o.file_sha256, checkpoint.ended, checkpoint.counters,
            checkpoint.payload);
    archive.end();
  } catch (const cereal::Exception& error) {
    throw std::runtime_error(std::string("altered: ") + error.what());
  }
  return checkpoint;
}

void save_checkpoint(const std::string& dir, const Checkpoint& checkpoint, Former former) {
  const std::string current = file_in(dir, "current"), fresh = file_in(dir, "fresh");
  for (const auto& [file, rows] : tables_of(checkpoint.counters)) sync_file((fs::path(dir) / file).string());
  make_folder(fs::path(current).parent_path().string());
  atomic_write(fresh, packed(checkpoint));
  if (former == Former::kept && fs::exists(current)) fs::rename(current, file_in(dir, "previous"));
  fs::rename(fresh, current);
  sync_folder(fs::path(current).parent_path().string());
}

std::map<std::string, std::string> files_of_run(const std::string& dir, std::uint64_t layout) {
  for (const char* name : {"current", "previous"}) {
    try {
      return unpacked(read_text(file_in(dir, name)), layout).origin.file_sha256;
    } catch (const std::runtime_error&) {
      continue;  // the search for a checkpoint gives the reason
    }
  }
  return {};
}

void restore_previous(const std::string& dir) {
  fs::rename(file_in(dir, "previous"), file_in(dir, "current"));
  sync_folder((fs::path(dir) / "checkpoint").string());
}

CheckpointSearch load_checkpoint(const std::string& dir, const Origin& own, const Examine& examine) {
  CheckpointSearch search;
  for (const char* name : {"current", "previous"}) {
    try {
      search.found = candidate(dir, name, own, examine);
      search.previous = name == std::string_view("previous");
      return search;
    } catch (const std::exception& error) {
      search.refusals.push_back(file_in(dir, name) + ": " + error.what());
    }
  }
  return search;
}

}  // namespace reye::output
