#pragma once

namespace reye::support {

/// Whether AddressSanitizer watches this build: it holds freed memory back, and ends the program where an allocation
/// that no memory holds would else throw.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool address_sanitizer = true;
#else
inline constexpr bool address_sanitizer = false;
#endif

}  // namespace reye::support
