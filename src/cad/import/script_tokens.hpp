#pragma once
#include <string>
#include <vector>

namespace reye::cad {

/// One token of a gmsh script: a word (letters, digits, _), a number, a text in quotes (without them), or a sign.
struct Token {
  enum class Kind { word, number, text, sign };
  Kind kind = Kind::sign;
  std::string text;
  int line = 1;
};

/// Why a script cannot be checked, and where.
struct Unreadable {
  int line = 1;
  std::string rule;
};

/// The script as gmsh reads it, without comments. gmsh leaves out parts of a script (branches not taken, loops, macros)
/// by searching its bytes for `EndIf` and the like, and goes back line by line: where gmsh could therefore read a
/// script other than the one checked here, the script is refused. Throws Unreadable.
std::vector<Token> tokens_of(const std::string& script);

}  // namespace reye::cad
