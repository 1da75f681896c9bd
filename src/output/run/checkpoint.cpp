#include "output/run/checkpoint.hpp"

#include <filesystem>
#include <stdexcept>

#include "base/printable.hpp"
#include "output/folder/files.hpp"
#include "output/folder/tables.hpp"
#include "output/folder/text.hpp"
#include "output/run/checksum.hpp"
#include "output/run/commit.hpp"
#include "output/run/layout.hpp"
#include "output/run/serialize.hpp"
#include "output/run/state_archive.hpp"

namespace reye::output {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view magic = "REYECKP4";
constexpr std::size_t same_magic = 7;  ///< of it, in every layout of the container
constexpr std::size_t head_size = 24;

std::string little_endian(std::uint64_t value) {
  std::string bytes;
  for (int i = 0; i < 8; ++i) bytes += static_cast<char>((value >> (8 * i)) & 0xff);
  return bytes;
}

std::uint64_t from_little_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (int i = 7; i >= 0; --i) value = (value << 8) | static_cast<unsigned char>(bytes[static_cast<std::size_t>(i)]);
  return value;
}

/// The body of a whole container; throws with the reason otherwise.
std::string checked_body(const std::string& bytes) {
  if (bytes.size() < head_size) throw std::runtime_error("truncated");
  if (bytes.compare(0, same_magic, magic, 0, same_magic) != 0)
    throw std::runtime_error("altered: not a checkpoint of this program");
  const std::string_view view(bytes);
  const std::uint64_t length = from_little_endian(view.substr(8, 8));
  if (view.size() - head_size < length) throw std::runtime_error("truncated");
  if (view.size() - head_size > length) throw std::runtime_error("altered: longer than it was written");
  if (from_little_endian(view.substr(16, 8)) != checksum(view.substr(head_size)))
    throw std::runtime_error("altered: wrong checksum");
  if (bytes.compare(0, magic.size(), magic) != 0)
    throw std::runtime_error(std::string("written by an older program, whose layout this one, built from commit ") +
                             commit() + ", cannot read");
  return bytes.substr(head_size);
}

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

Origin own_origin(const std::string& scene_sha256, const std::string& fixed_sha256) {
  return {version, commit(), state_layout(), scene_sha256, fixed_sha256};
}

std::string packed(const Checkpoint& checkpoint) {
  const auto& o = checkpoint.origin;
  const std::string body = to_bytes(o.layout, o.commit, o.version, o.scene_sha256, o.fixed_sha256, checkpoint.ended,
                                    checkpoint.counters, checkpoint.payload);
  return std::string(magic) + little_endian(body.size()) + little_endian(checksum(body)) + body;
}

Checkpoint unpacked(const std::string& bytes, std::uint64_t layout) {
  const std::string body = checked_body(bytes);
  Checkpoint checkpoint;
  auto& o = checkpoint.origin;
  try {
    BoundedInput archive(body);
    archive(o.layout, o.commit);
    if (o.layout != layout)
      throw std::runtime_error("written by the build of commit " + base::printable(o.commit) +
                               ", whose layout the build of commit " + commit() +
                               " cannot read; resume with a build of that commit, or start a new run");
    archive(o.version, o.scene_sha256, o.fixed_sha256, checkpoint.ended, checkpoint.counters, checkpoint.payload);
    archive.end();
  } catch (const cereal::Exception& error) {
    throw std::runtime_error(std::string("altered: ") + error.what());
  }
  return checkpoint;
}

void save_checkpoint(const std::string& dir, const Checkpoint& checkpoint) {
  const std::string current = file_in(dir, "current"), fresh = file_in(dir, "fresh");
  for (const auto& [file, rows] : tables_of(checkpoint.counters)) sync_file((fs::path(dir) / file).string());
  make_folder(fs::path(current).parent_path().string());
  atomic_write(fresh, packed(checkpoint));
  if (fs::exists(current)) fs::rename(current, file_in(dir, "previous"));
  fs::rename(fresh, current);
  sync_folder(fs::path(current).parent_path().string());
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
