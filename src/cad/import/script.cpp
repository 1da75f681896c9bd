#include "cad/import/script.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "cad/import/script_tokens.hpp"
#include "cad/import/script_words.hpp"

namespace reye::cad {

namespace {

namespace fs = std::filesystem;
using Kind = Token::Kind;

constexpr const char* mend = "; take it out, or run with --trust-geometry if you trust the file";

/// A script of the file with those it includes.
struct Script {
  fs::path path;
  std::vector<Token> tokens;

  const Token& at(std::size_t i) const {
    static const Token none{};
    return i < tokens.size() ? tokens[i] : none;
  }
  bool is(std::size_t i, std::string_view sign) const {
    return i < tokens.size() && at(i).kind == Kind::sign && at(i).text == sign;
  }
  bool is_word(std::size_t i) const { return i < tokens.size() && at(i).kind == Kind::word; }

  /// Behind the bracket that closes the one at i.
  std::size_t behind_bracket(std::size_t i) const {
    int depth = 0;
    for (; i < tokens.size(); ++i) {
      if (is(i, "(") || is(i, "[") || is(i, "{")) ++depth;
      if ((is(i, ")") || is(i, "]") || is(i, "}")) && --depth == 0) return i + 1;
    }
    return i;
  }
};

/// Whether a value is given to the word at i: `a =`, `a[2] +=`, `a~{i}() =`, `a++`.
bool is_set(const Script& script, std::size_t i) {
  for (++i; script.is(i, "~") || script.is(i, "[") || script.is(i, "(") || script.is(i, "{");)
    i = script.is(i, "~") ? i + 1 : script.behind_bracket(i);
  constexpr std::array signs = {"=", "+=", "-=", "*=", "/=", "++", "--"};
  return std::any_of(signs.begin(), signs.end(), [&](const char* sign) { return script.is(i, sign); });
}

bool is_one_of(const Token& token, std::initializer_list<std::string_view> texts) {
  return std::find(texts.begin(), texts.end(), token.text) != texts.end();
}

/// Whether a command may begin with the word at i, by what stands before it.
bool may_begin(const Script& script, std::size_t i) {
  if (i == 0) return true;
  const Token& before = script.at(i - 1);
  if (before.kind == Kind::word) return is_one_of(before, {"Else", "EndIf", "EndFor", "Return"});
  return before.kind != Kind::sign || is_one_of(before, {";", "}", ")", "]"});
}

class Search {
 public:
  Search(std::string path, const std::string& folder) : named_(std::move(path)) {
    for (const fs::path& open : {fs::path(folder), fs::path(named_).parent_path()})
      if (!open.empty()) folders_.push_back(fs::weakly_canonical(open));
    open(named_);
    for (std::size_t k = 0; k < scripts_.size(); ++k) include(k);
    for (const Script& script : scripts_) note_variables(script);
    for (const Script& script : scripts_)
      for (std::size_t i = 0; i < script.tokens.size(); ++i) look_at(script, i);
  }

  std::vector<base::Issue> issues() && { return std::move(issues_); }

 private:
  void open(const fs::path& path) {
    constexpr std::uintmax_t most_bytes = 32 << 20;
    constexpr std::size_t most_files = 100;
    Script script{path, {}};
    std::error_code error;
    if (fs::file_size(path, error) > most_bytes || error) return refuse(script, 1, "the script is larger than 32 MB");
    if (scripts_.size() >= most_files) return refuse(script, 1, "a script may include 100 files at most");
    std::ifstream file(path, std::ios::binary);
    try {
      script.tokens = tokens_of({std::istreambuf_iterator<char>(file), {}});
    } catch (const Unreadable& found) {
      return refuse(script, found.line, found.rule + mend);
    }
    scripts_.push_back(std::move(script));
  }

  void include(std::size_t k) {
    for (std::size_t i = 0; i < scripts_[k].tokens.size(); ++i) {
      if (!scripts_[k].is_word(i) || scripts_[k].at(i).text != "Include") continue;
      const Token name = scripts_[k].at(i + 1);
      if (name.kind != Kind::text || !scripts_[k].is(i + 2, ";")) {
        refuse(scripts_[k], scripts_[k].at(i).line, std::string("Include must name its file in quotes") + mend);
        continue;
      }
      std::error_code error;
      const fs::path file = fs::canonical(scripts_[k].path.parent_path() / name.text, error);
      const bool below = std::any_of(folders_.begin(), folders_.end(), [&](const fs::path& folder) {
        const fs::path way = file.lexically_relative(folder);
        return !way.empty() && *way.begin() != "..";
      });
      if (error || !fs::is_regular_file(file, error))
        refuse(scripts_[k], name.line, "Include \"" + name.text + "\": there is no such file");
      else if (!below)
        refuse(scripts_[k], name.line,
               "Include \"" + name.text +
                   "\": the file must lie in the folder of the scene or of the script, or below" + mend);
      else if (seen_.insert(file).second)
        open(file);
    }
  }

  void note_variables(const Script& script) {
    for (std::size_t i = 0; i < script.tokens.size(); ++i)
      if (script.is_word(i) && (is_set(script, i) || (i > 0 && script.at(i - 1).text == "For")))
        variables_.insert(script.at(i).text);
  }

  void look_at(const Script& script, std::size_t i) {
    if (!script.is_word(i)) return;
    const std::string& word = script.at(i).text;
    const int line = script.at(i).line;
    if (i > 1 && script.is(i - 1, ".")) return look_at_option(script, i);
    const std::size_t behind = script.behind_bracket(i + 1);
    if (word == "Printf" && (script.is(behind, ">") || script.is(behind, ">>")))
      return refuse(script, line, std::string("Printf may not write a file") + mend);
    if (is_allowed_word(word) || is_harmless_name(script, i)) return;
    refuse(script, line, word + " is neither a command that Reye lets a script use nor a variable that it sets" + mend);
  }

  /// A macro's name, or a variable where it is set or stands in an expression; not what begins a command or takes a
  /// text.
  bool is_harmless_name(const Script& script, std::size_t i) const {
    if (script.at(i + 1).kind == Kind::text) return false;
    if (i > 0 && is_one_of(script.at(i - 1), {"Call", "Macro", "Function"})) return !script.is(i + 1, "(");
    if (!variables_.contains(script.at(i).text)) return false;
    if (script.is_word(i + 1) && !is_allowed_word(script.at(i + 1).text)) return false;
    return !may_begin(script, i) || is_set(script, i);
  }

  /// `Mesh.Algorithm`, `Field[1].InField`: the word behind the point.
  void look_at_option(const Script& script, std::size_t i) {
    const std::string& option = script.at(i).text;
    std::size_t group = i - 2;
    while (group > 0 && !script.is_word(group)) --group;
    const std::string& name = script.at(group).text;
    const bool plain = group == i - 2, field = name == "Field" && script.behind_bracket(group + 1) == i - 1;
    if ((plain && is_allowed_option(name, option)) || (field && is_allowed_field_option(option))) return;
    refuse(script, script.at(i).line,
           name + (field ? "[...]." : ".") + option + " is not an option that a script may set" + mend);
  }

  void refuse(const Script& script, int line, const std::string& rule) {
    constexpr std::size_t most = 20;
    const std::string where = script.path == named_ ? "" : "of " + script.path.filename().string() + ", ";
    const std::string text = where + "line " + std::to_string(line) + ": " + rule;
    if (issues_.size() < most && told_.insert(text).second) issues_.push_back({"geometry", "\"" + named_ + "\"", text});
  }

  std::string named_;
  std::vector<fs::path> folders_;
  std::vector<Script> scripts_;
  std::set<fs::path> seen_;
  std::set<std::string> variables_, told_;
  std::vector<base::Issue> issues_;
};

}  // namespace

std::vector<base::Issue> unsafe_commands(const std::string& path, const std::string& folder) {
  return Search(path, folder).issues();
}

}  // namespace reye::cad
