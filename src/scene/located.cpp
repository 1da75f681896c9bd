#include "scene/located.hpp"

#include <algorithm>
#include <filesystem>

#include "base/in_words.hpp"
#include "base/printable.hpp"

namespace reye::scene {

namespace fs = std::filesystem;

namespace {

void add_lines(const Node& node, Lines& lines) {
  if (!node.key.empty()) lines[node.key] = node.line;
  for (const auto& child : node.children) add_lines(child, lines);
}

/// The line of the longest part of the key that the file has.
int line_of(std::string key, const Lines& lines) {
  while (!key.empty()) {
    if (const auto found = lines.find(key); found != lines.end()) return found->second;
    const auto cut = key.find_last_of(".[");
    key.resize(cut == std::string::npos ? 0 : cut);
  }
  return 1;
}

std::string in_words(const base::Issue& issue, int line, const std::string& path) {
  return base::printable(path) + ':' + std::to_string(line) + ": " + base::in_words(issue);
}

}  // namespace

Lines lines_of(const Node& document) {
  Lines lines;
  add_lines(document, lines);
  return lines;
}

std::vector<std::string> in_words(Issues& issues, const Lines& lines, const std::string& path) {
  std::stable_sort(issues.begin(), issues.end(),
                   [&](const auto& a, const auto& b) { return line_of(a.key, lines) < line_of(b.key, lines); });
  std::vector<std::string> texts;
  for (const auto& issue : issues) texts.push_back(in_words(issue, line_of(issue.key, lines), path));
  return texts;
}

base::InputError located(Issues issues, const Lines& lines, const std::string& path) {
  std::string text;
  for (const auto& line : in_words(issues, lines, path)) text += (text.empty() ? "" : "\n") + line;
  return {std::move(issues), text};
}

Node document_of(const std::string& text, const std::string& path) {
  try {
    return parse(text);
  } catch (const SyntaxError& error) {
    const base::Issue issue{"", "", std::string("is not TOML: ") + error.what()};
    throw base::InputError({issue}, in_words(issue, error.line, path));
  }
}

std::string name_of(const std::string& path) {
  const auto file = fs::absolute(path).lexically_normal();
  return file.filename() == "scene.toml" ? file.parent_path().filename().string() : file.stem().string();
}

}  // namespace reye::scene
