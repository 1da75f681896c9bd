#include "scene/rewrite.hpp"

#include <algorithm>
#include <cassert>
#include <filesystem>

#include "scene/document.hpp"
#include "scene/geometry_files.hpp"

namespace reye::scene {

namespace {

/// The innermost place of the file that holds the key, and the rest of the key below it.
struct Place {
  const Node* node;
  std::string below;
};

Place place_of(const Node& node, const std::string& key) {
  if (node.key == key) return {&node, ""};
  for (const auto& child : node.children) {
    const auto size = child.key.size();
    const bool leads = key.starts_with(child.key) && (key.size() == size || key[size] == '.' || key[size] == '[');
    if (leads) return place_of(child, key);
  }
  return {&node, node.key.empty() ? key : key.substr(node.key.size() + 1)};
}

/// "step[1].jump" as a header names it: "step.jump".
std::string without_indices(const std::string& key) {
  std::string name;
  bool inside = false;
  for (const char c : key) {
    inside = c == '[' || (inside && c != ']');
    if (!inside && c != ']') name += c;
  }
  return name;
}

/// Whether the header [a.b] or [[a.b]] that stands at the node is its own, not one of a table below it.
bool has_own_header(const std::string& text, const Node& table) {
  auto name = text.substr(table.begin, table.end - table.begin);
  std::erase_if(name, [](char c) { return c == '[' || c == ']' || c == ' ' || c == '\t' || c == '"'; });
  return name == without_indices(table.key);
}

std::size_t line_start(const std::string& text, std::size_t at) {
  const auto before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  return before == std::string::npos ? 0 : before + 1;
}

/// The text with `name = value` put into a table, in the form in which the table is written.
std::string added(std::string text, const Node& table, const std::string& name, const std::string& value) {
  const auto line = name + " = " + value;
  if (table.key.empty()) return line + '\n' + text;
  const auto first = line_start(text, table.begin);
  if (text[table.begin] == '{') return text.insert(table.begin + 1, ' ' + line + (table.children.empty() ? " " : ","));
  if (text[table.begin] != '[')  // made by a dotted key: one more of its kind
    return text.insert(first, text.substr(first, table.end - first) + '.' + line + '\n');
  if (!has_own_header(text, table)) return text.insert(first, '[' + table.key + "]\n" + line + '\n');
  const auto end = text.find('\n', table.end);
  return end == std::string::npos ? text + '\n' + line + '\n' : text.insert(end + 1, line + '\n');
}

/// Whether the text can be read and has `value` at `key`.
bool says(const std::string& text, const std::string& key, const std::string& value) {
  try {
    const auto root = parse(text);
    const auto place = place_of(root, key);
    return place.below.empty() && text.substr(place.node->begin, place.node->end - place.node->begin) == value;
  } catch (const SyntaxError&) {
    return false;
  }
}

void add_paths(const Node& root, std::vector<const Node*>& paths) {
  const auto* geometry = root.find("geometry");
  if (geometry)
    for (const auto& file : geometry->children) paths.push_back(&file);
  const auto add_each = [&](const char* tables, const char* key) {
    if (const auto* all = root.find(tables))
      for (const auto& table : all->children)
        if (const auto* path = table.find(key)) paths.push_back(path);
  };
  add_each("boundary", "profile");
  add_each("history", "file");
  if (const auto* spectrum = root.find("spectrum"))
    if (const auto* levels = spectrum->find("levels")) paths.push_back(levels);
}

}  // namespace

std::optional<std::string> with_value(const std::string& text, const std::string& key, const std::string& value) {
  const auto root = parse(text);
  const auto [node, below] = place_of(root, key);
  const bool table = node->kind == NodeKind::table;
  const bool on_its_own = table && (node->key.empty() || text[node->begin] != '{');  // a value could not replace it
  if (below.empty() && on_its_own) return {};
  auto changed = text;
  if (table && !below.empty())
    changed = added(text, *node, below, value);
  else
    changed.replace(node->begin, node->end - node->begin, below.empty() ? value : "{ " + below + " = " + value + " }");
  return says(changed, key, value) ? std::optional(changed) : std::nullopt;
}

std::string with_absolute_paths(std::string text, const std::string& path) {
  const auto root = parse(text);
  std::vector<const Node*> paths;
  add_paths(root, paths);
  std::sort(paths.begin(), paths.end(), [](const Node* a, const Node* b) { return a->begin > b->begin; });
  for (const auto* node : paths)  // from the last one on: the places before it stay valid
    if (node->kind == NodeKind::text && !node->text.empty())
      text.replace(node->begin, node->end - node->begin, quoted(beside(path, node->text)));
  return text;
}

std::string quoted(const std::string& text) {
  std::string inside;
  for (const char c : text) {
    if (c == '"' || c == '\\') inside += '\\';
    inside += c;
  }
  return '"' + inside + '"';
}

}  // namespace reye::scene
