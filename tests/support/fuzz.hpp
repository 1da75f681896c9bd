#pragma once
#include <algorithm>
#include <iterator>
#include <random>
#include <string>
#include <vector>

/// Damage to texts and bytes, the same for the same seed on every machine.
namespace reye::test {

class Damage {
 public:
  explicit Damage(unsigned seed) : random_(seed) {}

  /// A whole number in [0, n).
  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }

  template <class List>
  const auto& one_of(const List& list) {
    return *std::next(std::begin(list), static_cast<std::ptrdiff_t>(below(std::size(list))));
  }

  /// The text with one to four places damaged.
  std::string on(std::string text) {
    for (std::size_t n = 1 + below(4); n > 0 && !text.empty(); --n) text = once(std::move(text));
    return text;
  }

 private:
  std::string once(std::string text) {
    switch (below(9)) {
      case 0:
        return without_line(std::move(text));
      case 1:
        return with_line_twice(std::move(text));
      case 2:
        return text.substr(0, below(text.size()));
      case 3:
        text[below(text.size())] = static_cast<char>(below(256));
        return text;
      case 4:
        return text.erase(below(text.size()), 1 + below(20));
      default:
        return with_other_number(std::move(text));
    }
  }

  std::pair<std::size_t, std::size_t> line_of(const std::string& text) {
    const std::size_t at = below(text.size());
    const std::size_t begin = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;  // npos + 1 is 0
    return {begin, std::min(text.find('\n', at), text.size() - 1) + 1 - begin};
  }

  std::string without_line(std::string text) {
    const auto [begin, size] = line_of(text);
    return text.erase(begin, size);
  }

  std::string with_line_twice(std::string text) {
    const auto [begin, size] = line_of(text);
    return text.insert(below(text.size()), text.substr(begin, size));
  }

  /// A number of the text, from a place on, is another: of the text, or one at the rim of what can be written.
  std::string with_other_number(std::string text) {
    static const std::vector<std::string> odd = {"0",      "-1",         "1",      "2",    "1e300",      "-1e300",
                                                 "1e-300", "1e-9",       "1e9",    "1e5",  "2147483647", "-2147483648",
                                                 "nan",    "4294967296", "0.0001", "-0.0", "inf",        "1e400",
                                                 "255",    "0.5",        "100",    "1000", "9999999",    "\"\""};
    const auto number_at = [&](std::size_t from) {
      const std::size_t begin = std::min(text.find_first_of("0123456789", from), text.size());
      return std::pair(begin, std::min(text.find_first_not_of("0123456789.eE+-", begin), text.size()) - begin);
    };
    const auto [begin, size] = number_at(below(text.size()));
    const auto [other, length] = number_at(below(text.size()));
    const std::string value = below(3) == 0 ? text.substr(other, length) : one_of(odd);
    return text.replace(begin, size, value);
  }

  std::mt19937 random_;
};

}  // namespace reye::test
