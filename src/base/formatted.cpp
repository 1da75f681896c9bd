#include "base/formatted.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

namespace reye::base {

std::string formatted(const char* format, ...) {
  std::va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  std::array<char, 256> most{};  // long enough for nearly all, which are then printed once
  const auto size = static_cast<std::size_t>(std::vsnprintf(most.data(), most.size(), format, arguments));
  va_end(arguments);
  std::string text(most.data(), std::min(size, most.size() - 1));
  if (size > text.size()) {
    text.resize(size);
    std::vsnprintf(text.data(), size + 1, format, again);
  }
  va_end(again);
  return text;
}

std::string fixed(double value, int decimals) {
  std::array<char, 400> digits{};  // 309 before the point
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals);
  return {digits.data(), end.ptr};
}

void append_tenths(double value, std::string& text) {
  const long tenths = std::lround(10.0 * value);
  if (tenths < 0) text += '-';
  std::array<char, 24> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), std::abs(tenths) / 10);
  text.append(digits.data(), end.ptr);
  text += '.';
  text += static_cast<char>('0' + std::abs(tenths) % 10);
}

}  // namespace reye::base
