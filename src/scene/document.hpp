#pragma once
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// A TOML text as a plain tree with places; hides the reader behind it.
namespace reye::scene {

enum class NodeKind { table, list, text, number, whole, flag, other };

/// One value of the file with the key it stands under. Children in the order of the file.
struct Node {
  NodeKind kind = NodeKind::table;
  std::string key;   ///< whole key: "material.steel.nu", "step[0].cycles"
  std::string name;  ///< its last part
  int line = 1;
  std::string written;  ///< the value as written in the file; empty for tables
  /// Bytes [begin, end) of the value in the text; of a headed table its header, of one made by a dotted key that part
  /// of it.
  std::size_t begin = 0, end = 0;
  std::string text;
  double number = 0.0;
  bool flag = false;
  std::vector<Node> children;

  const Node* find(std::string_view child) const;
  bool is_number() const { return kind == NodeKind::number || kind == NodeKind::whole; }
};

/// The text is not TOML: what() says why.
struct SyntaxError : std::runtime_error {
  SyntaxError(const std::string& why, int at_line) : std::runtime_error(why), line(at_line) {}
  int line;
};

Node parse(const std::string& toml);

}  // namespace reye::scene
