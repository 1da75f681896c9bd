#include "cad/import/messages.hpp"

#include <unistd.h>

#include <cstdint>
#include <cstdlib>

namespace reye::cad {

namespace {

bool read_request(char* to, std::size_t bytes) {
  while (bytes > 0) {
    const ssize_t n = ::read(STDIN_FILENO, to, bytes);
    if (n <= 0) return false;
    to += n;
    bytes -= static_cast<std::size_t>(n);
  }
  return true;
}

}  // namespace

void say(const std::string& bytes) {
  constexpr int pipe = 3;
  const std::uint64_t size = bytes.size();
  std::string all(reinterpret_cast<const char*>(&size), sizeof size);
  all += bytes;
  for (std::size_t at = 0; at < all.size();) {
    const ssize_t n = ::write(pipe, all.data() + at, all.size() - at);
    if (n <= 0) std::_Exit(1);
    at += static_cast<std::size_t>(n);
  }
}

std::optional<std::string> next_request() {
  std::uint64_t size = 0;
  if (!read_request(reinterpret_cast<char*>(&size), sizeof size)) return std::nullopt;
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (!read_request(bytes.data(), bytes.size())) return std::nullopt;
  return bytes;
}

}  // namespace reye::cad
