#pragma once
#include <string>
#include <vector>

namespace reye::cad {

/// One thing of a gmsh script: a word (letters, digits, _), a number, a text in quotes (without them), or a sign.
struct Token {
  enum class Kind { word, number, text, sign };
  Kind kind = Kind::sign;
  std::string text;
  int line = 1;
};

/// What makes a script unfit to be looked through, and where.
struct Unreadable {
  int line = 1;
  std::string rule;
};

/// The script as gmsh reads it, without comments. gmsh leaves out parts of a script (branches not taken, loops, macros)
/// by searching its bytes for `EndIf` and the like, and goes back line by line: where that could make it see another
/// script than is seen here, the script is refused. Throws Unreadable.
std::vector<Token> tokens_of(const std::string& script);

}  // namespace reye::cad
