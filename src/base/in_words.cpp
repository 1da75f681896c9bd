#include "base/in_words.hpp"

#include "base/printable.hpp"

namespace reye::base {

std::string in_words(const Issue& issue) {
  std::string text = issue.key + (issue.value.empty() ? "" : " = " + issue.value);
  text += (text.empty() ? "" : ": ") + issue.rule;
  return printable(text);
}

}  // namespace reye::base
