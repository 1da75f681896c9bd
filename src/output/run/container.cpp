#include "output/run/container.hpp"

#include <cstdint>
#include <stdexcept>

#include "output/run/checksum.hpp"
#include "output/run/commit.hpp"

namespace reye::output {

namespace {

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

}  // namespace

std::string sealed(std::string_view magic, const std::string& body) {
  return std::string(magic) + little_endian(body.size()) + little_endian(checksum(body)) + body;
}

std::string unsealed(std::string_view magic, const std::string& bytes, const std::string& what) {
  if (bytes.size() < head_size) throw std::runtime_error("truncated");
  const std::size_t same = magic.size() - 1;  // of it, in every layout of the container
  if (bytes.compare(0, same, magic, 0, same) != 0)
    throw std::runtime_error("altered: not " + what + " of this program");
  if (bytes.compare(0, magic.size(), magic) != 0)
    throw std::runtime_error(std::string("written by an older program, whose layout this one, built from commit ") +
                             commit() + ", cannot read");
  const std::string_view view(bytes);
  const std::uint64_t length = from_little_endian(view.substr(8, 8));
  if (view.size() - head_size < length) throw std::runtime_error("truncated");
  if (view.size() - head_size > length) throw std::runtime_error("altered: longer than it was written");
  if (from_little_endian(view.substr(16, 8)) != checksum(view.substr(head_size)))
    throw std::runtime_error("altered: wrong checksum");
  return bytes.substr(head_size);
}

}  // namespace reye::output
