#pragma once
#include <string>
#include <string_view>

namespace reye::output {

/// Bytes in a container: 8 bytes of magic, length and checksum of the body, then the body.
std::string sealed(std::string_view magic, const std::string& body);

/// The body of a whole container with this magic. The last byte of the magic is its layout: one of another layout is
/// refused as that of an older program. Throws std::runtime_error with the reason; `what`: "a checkpoint".
std::string unsealed(std::string_view magic, const std::string& bytes, const std::string& what);

}  // namespace reye::output
