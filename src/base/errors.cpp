#include "base/errors.hpp"

#include "base/in_words.hpp"

namespace reye::base {

namespace {
std::string joined(const std::vector<Issue>& issues) {
  std::string text;
  for (const auto& issue : issues) {
    if (!text.empty()) text += '\n';
    text += in_words(issue);
  }
  return text;
}
}  // namespace

InputError::InputError(std::vector<Issue> issues) : std::runtime_error(joined(issues)), issues_(std::move(issues)) {}

InputError::InputError(std::vector<Issue> issues, const std::string& text)
    : std::runtime_error(text), issues_(std::move(issues)) {}

}  // namespace reye::base
