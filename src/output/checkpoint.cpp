#include "output/checkpoint.hpp"

#include <cereal/archives/portable_binary.hpp>
#include <cereal/types/map.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "output/files.hpp"

namespace reye::output {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view magic = "REYECKP2";
constexpr std::size_t head_size = 24;

/// FNV-1a: any single altered byte alters it for certain, several almost for certain.
std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t hash = 14695981039346656037ull;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  return hash;
}

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
  if (bytes.compare(0, magic.size(), magic) != 0) throw std::runtime_error("altered: not a checkpoint of this program");
  const std::string_view view(bytes);
  const std::uint64_t length = from_little_endian(view.substr(8, 8));
  if (view.size() - head_size < length) throw std::runtime_error("truncated");
  if (view.size() - head_size > length) throw std::runtime_error("altered: longer than it was written");
  if (from_little_endian(view.substr(16, 8)) != checksum(view.substr(head_size)))
    throw std::runtime_error("altered: wrong checksum");
  return bytes.substr(head_size);
}

Checkpoint unpacked(const std::string& bytes) {
  std::istringstream stream(checked_body(bytes), std::ios::binary);
  Checkpoint checkpoint;
  try {
    cereal::PortableBinaryInputArchive archive(stream);
    archive(checkpoint.info, checkpoint.payload);
  } catch (const cereal::Exception&) {
    // Whole by its checksum, so it was written like this: by a program with another layout.
    throw std::runtime_error("of another version");
  }
  return checkpoint;
}

std::string file_in(const std::string& dir, const char* name) {
  return (fs::path(dir) / "checkpoint" / (std::string(name) + ".bin")).string();
}

/// One candidate, or the reason against it.
Checkpoint candidate(const std::string& path, const std::string& version, const std::string& sha256) {
  if (!fs::is_regular_file(path)) throw std::runtime_error("missing");
  Checkpoint checkpoint = unpacked(read_text(path));
  if (checkpoint.info.version != version)
    throw std::runtime_error("of another version, " + checkpoint.info.version + " instead of " + version);
  if (checkpoint.info.scene_sha256 != sha256) throw std::runtime_error("of another scene");
  return checkpoint;
}

}  // namespace

std::string packed(const Checkpoint& checkpoint) {
  std::ostringstream stream(std::ios::binary);
  {
    cereal::PortableBinaryOutputArchive archive(stream);
    archive(checkpoint.info, checkpoint.payload);
  }
  const std::string body = stream.str();
  return std::string(magic) + little_endian(body.size()) + little_endian(checksum(body)) + body;
}

void save_checkpoint(const std::string& dir, const Checkpoint& checkpoint) {
  const std::string current = file_in(dir, "current"), fresh = file_in(dir, "fresh");
  fs::create_directories(fs::path(current).parent_path());
  atomic_write(fresh, packed(checkpoint));
  if (fs::exists(current)) fs::rename(current, file_in(dir, "previous"));
  fs::rename(fresh, current);
}

CheckpointSearch load_checkpoint(const std::string& dir, const std::string& version, const std::string& scene_sha256) {
  CheckpointSearch search;
  for (const char* name : {"current", "previous"}) {
    const std::string path = file_in(dir, name);
    try {
      search.found = candidate(path, version, scene_sha256);
      return search;
    } catch (const std::exception& error) {
      search.refusals.push_back(path + ": " + error.what());
    }
  }
  return search;
}

}  // namespace reye::output
