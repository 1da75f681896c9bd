#include "wear/formula.hpp"

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/formatted.hpp"

namespace reye::wear {

namespace {

constexpr std::size_t longest = 2000;  ///< characters

struct Named {
  Variable variable;
  const char* name;
};

constexpr std::array<Named, 5> names{{{Variable::pressure, "pressure_MPa"},
                                      {Variable::speed, "speed_mm_per_s"},
                                      {Variable::path, "path_mm"},
                                      {Variable::depth, "depth_mm"},
                                      {Variable::cycle, "cycle"}}};

/// Whether a text assigns to a variable, which the parser would allow.
bool assigns(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    const bool second = i > 0 && (text[i - 1] == '=' || text[i - 1] == '<' || text[i - 1] == '>' || text[i - 1] == '!');
    const bool first = i + 1 < text.size() && text[i + 1] == '=';
    if (!second && !first) return true;
  }
  return false;
}

std::string all_names() {
  std::string text;
  for (const auto& named : names) text += (text.empty() ? "" : ", ") + std::string(named.name);
  return text;
}

}  // namespace

double& Place::at(Variable variable) {
  switch (variable) {
    case Variable::pressure:
      return pressure;
    case Variable::speed:
      return speed;
    case Variable::path:
      return path;
    case Variable::depth:
      return depth;
    case Variable::cycle:
      break;
  }
  return cycle;
}

struct Formula::Parsed {
  std::string text;
  mutable Place place;  ///< bound to the variables of the parser: one thread at a time evaluates a formula
  mu::Parser parser;
  std::array<bool, names.size()> used{};

  double value() const {
    try {
      return parser.Eval();
    } catch (const mu::ParserError& error) {
      throw FormulaError("the formula \"" + text + "\": " + error.GetMsg());
    }
  }
};

Formula::Formula(const std::string& text) {
  if (text.size() > longest) throw FormulaError("it has more than 2000 characters");
  if (assigns(text)) throw FormulaError("it assigns with \"=\"; equality is written ==");
  auto parsed = std::make_shared<Parsed>();
  parsed->text = text;
  try {
    for (const auto& named : names) parsed->parser.DefineVar(named.name, &parsed->place.at(named.variable));
    parsed->parser.SetExpr(text);
    const auto& used = parsed->parser.GetUsedVar();
    for (const auto& [name, where] : used)
      if (std::none_of(names.begin(), names.end(), [&n = name](const auto& known) { return n == known.name; }))
        throw FormulaError("it names \"" + name + "\", which is none of " + all_names());
    for (const auto& named : names) parsed->used[static_cast<std::size_t>(named.variable)] = used.contains(named.name);
    int results = 0;
    parsed->parser.Eval(results);
    if (results != 1) throw FormulaError("it has " + std::to_string(results) + " parts between commas");
  } catch (const mu::ParserError& error) {
    throw FormulaError(error.GetMsg());
  }
  parsed_ = std::move(parsed);
}

const std::string& Formula::text() const {
  static const std::string none;
  return parsed_ ? parsed_->text : none;
}

bool Formula::uses(Variable variable) const { return parsed_ && parsed_->used[static_cast<std::size_t>(variable)]; }

double Formula::at(Place place) const {
  place.pressure = std::max(place.pressure, least_pressure_MPa);
  place.speed = std::max(place.speed, least_speed_mm_per_s);
  parsed_->place = place;
  const double value = parsed_->value();
  if (value >= 0.0 && std::isfinite(value)) return value;
  std::string where;
  for (const auto& named : names)
    if (uses(named.variable))
      where += (where.empty() ? " at " : ", ") + base::formatted("%s = %.6g", named.name, place.at(named.variable));
  throw FormulaError(base::formatted("the formula \"%s\" is %.6g%s; it must be finite and not negative",
                                     parsed_->text.c_str(), value, where.c_str()));
}

double Formula::slope(Place place, Variable variable) const {
  if (!uses(variable)) return 0.0;
  const double x = place.at(variable);
  const double least = variable == Variable::pressure ? least_pressure_MPa
                       : variable == Variable::speed  ? least_speed_mm_per_s
                                                      : 0.0;
  if (x <= least) return 0.0;
  const double step = 1e-3 * x;
  const auto shifted = [&](double by) {
    Place there = place;
    there.at(variable) = x + by * step;
    return at(there);
  };
  return (8.0 * (shifted(1.0) - shifted(-1.0)) - (shifted(2.0) - shifted(-2.0))) / (12.0 * step);
}

double at_start(const Formula& formula) {
  double most = 0.0;
  for (const double pressure : {1.0, 100.0})
    for (const double speed : {1.0, 100.0}) most = std::max(most, formula.at({.pressure = pressure, .speed = speed}));
  return most;
}

std::string broken_formula(const std::string& text) {
  try {
    at_start(Formula(text));
  } catch (const FormulaError& error) {
    return error.what();
  }
  return {};
}

}  // namespace reye::wear
