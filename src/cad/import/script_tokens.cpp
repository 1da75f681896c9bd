#include "cad/import/script_tokens.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace reye::cad {

namespace {

constexpr std::array<std::string_view, 16> long_signs = {"...", "==", "!=", "<=", ">=", "&&", "||", "++",
                                                         "--",  "+=", "-=", "*=", "/=", "::", ">>", "<<"};
constexpr std::array<std::string_view, 6> turning_words = {"EndIf", "EndFor", "Else", "Return", "Macro", "Function"};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)); }

class Lexer {
 public:
  explicit Lexer(std::string_view script) : rest_(script) {}

  std::vector<Token> all() {
    while (!rest_.empty()) step();
    return std::move(tokens_);
  }

 private:
  void step() {
    const char c = rest_.front();
    if (rest_.starts_with("//")) return skip(std::min(rest_.find('\n'), rest_.size()));
    if (rest_.starts_with("/*")) return block_comment();
    if (c == '"' || c == '\'') return quoted(c);
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f') return take(1);
    if (is_letter(c)) return add(Token::Kind::word, length([](char d) { return is_letter(d) || is_digit(d); }));
    if (is_digit(c) || (c == '.' && rest_.size() > 1 && is_digit(rest_[1]))) return number();
    for (std::string_view sign : long_signs)
      if (rest_.starts_with(sign)) return add(Token::Kind::sign, sign.size());
    if (!std::isprint(static_cast<unsigned char>(c))) refuse("holds a byte that is no part of gmsh's language");
    add(Token::Kind::sign, 1);
  }

  template <class Belongs>
  std::size_t length(Belongs belongs) const {
    return static_cast<std::size_t>(std::find_if_not(rest_.begin(), rest_.end(), belongs) - rest_.begin());
  }

  void number() {
    std::size_t n = 0;
    const auto digits = [&] {
      while (n < rest_.size() && is_digit(rest_[n])) ++n;
    };
    digits();
    if (n < rest_.size() && rest_[n] == '.' && !rest_.substr(n).starts_with("...")) ++n;
    digits();
    if (n < rest_.size() && (rest_[n] == 'e' || rest_[n] == 'E')) {
      const std::size_t sign = n + 1 < rest_.size() && (rest_[n + 1] == '+' || rest_[n + 1] == '-') ? 2 : 1;
      if (n + sign < rest_.size() && is_digit(rest_[n + sign])) n += sign;
      digits();
    }
    add(Token::Kind::number, n);
  }

  /// Skips a comment; one of several lines may not begin behind other text: gmsh goes back to the beginning of a line.
  void block_comment() {
    const std::size_t end = rest_.find("*/", 2);
    if (end == std::string_view::npos) refuse("a comment does not end");
    const bool behind = !tokens_.empty() && tokens_.back().line == line_;
    if (behind && rest_.substr(0, end).find('\n') != std::string_view::npos)
      refuse("a comment of several lines must begin on a line of its own");
    skip(end + 2);
  }

  void quoted(char quote) {
    constexpr std::size_t longest = 255;
    const std::size_t end = rest_.find(quote, 1);
    const std::string_view text = rest_.substr(1, end == std::string_view::npos ? end : end - 1);
    if (end == std::string_view::npos || text.size() > longest || text.find('\n') != std::string_view::npos)
      refuse("a text in quotes must end on its line, after 255 characters at most");
    if (text.find("//") != std::string_view::npos || text.find("/*") != std::string_view::npos)
      refuse("a text in quotes may not hold the beginning of a comment");
    tokens_.push_back({Token::Kind::text, std::string(text), line_});
    skip(end + 1);
  }

  void add(Token::Kind kind, std::size_t n) {
    tokens_.push_back({kind, std::string(rest_.substr(0, n)), line_});
    take(n);
  }

  /// Skips comments and texts, in which gmsh may find words that change its control flow.
  void skip(std::size_t n) {
    for (std::string_view word : turning_words)
      if (rest_.substr(0, n).find(word) != std::string_view::npos)
        refuse("a comment or text may not hold the word " + std::string(word) + ", which gmsh may take for a command");
    take(n);
  }

  void take(std::size_t n) {
    for (char c : rest_.substr(0, n)) {
      if (c == '\0') refuse("holds a byte that is no part of gmsh's language");
      if (c == '\n') ++line_;
    }
    rest_.remove_prefix(n);
  }

  [[noreturn]] void refuse(const std::string& rule) const { throw Unreadable{line_, rule}; }

  std::string_view rest_;
  int line_ = 1;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokens_of(const std::string& script) {
  constexpr std::size_t longest =
      4000;  // gmsh reads lines in pieces of 8 kB, and goes back to the beginning of a piece
  std::vector<Token> tokens = Lexer(script).all();
  const auto turns = [](const Token& t) {
    return t.text == "For" || t.text == "Call" || t.text == "Macro" || t.text == "Function";
  };
  if (const auto turning = std::find_if(tokens.begin(), tokens.end(), turns); turning != tokens.end()) {
    std::size_t begin = 0;
    for (int line = 1; begin < script.size(); ++line) {
      const std::size_t end = std::min(script.find('\n', begin), script.size());
      if (end - begin > longest)
        throw Unreadable{line, "a line of a script with loops or macros must be shorter than 4000 characters"};
      begin = end + 1;
    }
  }
  return tokens;
}

}  // namespace reye::cad
