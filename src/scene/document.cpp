#include "scene/document.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace reye::scene {

namespace {

/// The lines of the file, to show values as the user wrote them.
struct Source {
  std::vector<std::string> lines;
  std::vector<std::size_t> starts;  ///< byte at which each begins
  std::map<unsigned, std::vector<std::size_t>>
      characters;  ///< where they begin, and the end, in lines of more than ASCII

  explicit Source(const std::string& toml) : lines(1), starts{0} {
    for (std::size_t i = 0; i < toml.size(); ++i) {
      if (toml[i] == '\n') {
        lines.emplace_back();
        starts.push_back(i + 1);
      } else {
        lines.back() += toml[i];
      }
    }
    for (unsigned i = 0; i < lines.size(); ++i) note_characters(i);
  }

  void note_characters(unsigned i) {
    const auto& line = lines[i];
    if (std::none_of(line.begin(), line.end(), [](char c) { return (static_cast<unsigned char>(c) & 0x80U) != 0; }))
      return;
    for (std::size_t at = 0; at <= line.size(); ++at)
      if (at == line.size() || (static_cast<unsigned char>(line[at]) & 0xC0U) != 0x80U) characters[i + 1].push_back(at);
  }

  /// Offset in bytes of a column, which counts characters.
  std::size_t offset(const toml::source_position& place) const {
    const auto found = characters.find(place.line);
    if (found == characters.end()) return std::min<std::size_t>(place.column - 1, lines.at(place.line - 1).size());
    return found->second.at(std::clamp<std::size_t>(place.column, 1, found->second.size()) - 1);
  }

  /// Byte of a place in the whole text.
  std::size_t byte(const toml::source_position& place) const { return starts.at(place.line - 1) + offset(place); }

  /// A value on one line; long or broken values are shortened for messages.
  std::string slice(const toml::source_region& region) const {
    const auto& line = lines.at(region.begin.line - 1);
    const auto from = offset(region.begin);
    const bool one_line = region.end.line == region.begin.line;
    auto value = line.substr(from, one_line ? offset(region.end) - from : std::string::npos);
    while (!value.empty() && (value.back() == '\r' || value.back() == ' ')) value.pop_back();
    constexpr std::size_t longest = 60;
    if (value.size() > longest) value.resize(longest);
    return one_line && value.size() < longest ? value : value + " ...";
  }
};

constexpr int most_nested = 64;  ///< values inside one another; the functions below call each other for each

Node convert(const toml::node& value, const Source& source, std::string key, std::string name, int depth);

void add_children(Node& node, const toml::table& table, const Source& source, int depth) {
  std::vector<std::tuple<toml::source_position, Node>> placed;
  for (const auto& [name, value] : table) {
    const std::string child(name.str());
    placed.emplace_back(name.source().begin,
                        convert(value, source, node.key.empty() ? child : node.key + '.' + child, child, depth));
    if (name.source().begin) std::get<Node>(placed.back()).line = static_cast<int>(name.source().begin.line);
  }
  std::stable_sort(placed.begin(), placed.end(),
                   [](const auto& a, const auto& b) { return std::get<0>(a) < std::get<0>(b); });
  for (auto& [place, child] : placed) node.children.push_back(std::move(child));
}

void add_elements(Node& node, const toml::array& list, const Source& source, int depth) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto index = '[' + std::to_string(i) + ']';
    node.children.push_back(convert(*list.get(i), source, node.key + index, node.name + index, depth));
  }
}

/// Where a value stands in the file; of a value that is no table, how it is written.
void locate(Node& node, const toml::node& value, const Source& source) {
  if (!value.source().begin) return;
  node.line = static_cast<int>(value.source().begin.line);
  node.begin = source.byte(value.source().begin);
  node.end = source.byte(value.source().end);
  if (!value.is_table() && !value.is_array_of_tables()) node.written = source.slice(value.source());
}

/// The value of a node that has no others below it.
void read_value(Node& node, const toml::node& value) {
  if (const auto* text = value.as_string()) {
    node.kind = NodeKind::text;
    node.text = text->get();
  } else if (const auto* flag = value.as_boolean()) {
    node.kind = NodeKind::flag;
    node.flag = flag->get();
  } else if (const auto number = value.value<double>()) {
    node.kind = value.is_integer() ? NodeKind::whole : NodeKind::number;
    node.number = *number;
  }
}

Node convert(const toml::node& value, const Source& source, std::string key, std::string name, int depth) {
  if (depth > most_nested)
    throw SyntaxError("values nested more than 64 deep", static_cast<int>(value.source().begin.line));
  Node node;
  node.kind = NodeKind::other;
  node.key = std::move(key);
  node.name = std::move(name);
  locate(node, value, source);
  if (const auto* table = value.as_table()) {
    node.kind = NodeKind::table;
    add_children(node, *table, source, depth + 1);
  } else if (const auto* list = value.as_array()) {
    node.kind = NodeKind::list;
    add_elements(node, *list, source, depth + 1);
  } else {
    read_value(node, value);
  }
  return node;
}

/// The message of the parser, which for a text that continues beyond its line only sees the line's end.
std::string in_words(const std::string& description) {
  const bool open = description.find("parsing string") != std::string::npos &&
                    description.find("control characters") != std::string::npos;
  return open ? "a text lacks its closing quotation mark" : description;
}

/// Limits the parts of dotted keys, since the parser recurses for each without a bound.
void check_depth(const std::vector<std::string>& lines) {
  constexpr int most = 32;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    int parts = 1;
    char quote = '\0';
    for (char c : lines[i]) {
      if (c == quote)
        quote = '\0';
      else if (quote != '\0')
        continue;
      else if (c == '"' || c == '\'')
        quote = c;
      else if (c == '#')
        break;
      else if (c == '.')
        ++parts;
      else if (std::string_view(",=[]{}").find(c) != std::string_view::npos)
        parts = 1;
      if (parts > most) throw SyntaxError("a key of more than 32 parts", static_cast<int>(i) + 1);
    }
  }
}

}  // namespace

const Node* Node::find(std::string_view child) const {
  const auto found = std::find_if(children.begin(), children.end(), [&](const Node& n) { return n.name == child; });
  return found == children.end() ? nullptr : &*found;
}

Node parse(const std::string& toml) {
  const Source source(toml);
  check_depth(source.lines);
  try {
    auto root = convert(toml::parse(toml), source, "", "", 0);
    root.line = 1;
    return root;
  } catch (const toml::parse_error& error) {
    throw SyntaxError(in_words(std::string(error.description())), static_cast<int>(error.source().begin.line));
  }
}

}  // namespace reye::scene
