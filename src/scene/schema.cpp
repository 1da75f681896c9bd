#include "scene/schema.hpp"

#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>

#include "scene/check.hpp"

namespace reye::scene {

namespace {

using Json = nlohmann::ordered_json;

/// Adds the bounds of a number.
void bound(Json& number, const Range& range) {
  if (std::isfinite(range.low)) number[range.low_open ? "exclusiveMinimum" : "minimum"] = range.low;
  if (std::isfinite(range.high)) number[range.high_open ? "exclusiveMaximum" : "maximum"] = range.high;
}

Json number_of(const Range& range, const char* type = "number") {
  Json number = {{"type", type}};
  bound(number, range);
  return number;
}

/// A list; `least` or `most` = 0: without that bound.
Json list_of(Json element, std::size_t least, std::size_t most) {
  Json list = {{"type", "array"}, {"items", std::move(element)}};
  if (least > 0) list["minItems"] = least;
  if (most > 0) list["maxItems"] = most;
  return list;
}

Range whole_range(Range range) {
  range.low = std::max(range.low, -whole_limit);
  range.high = std::min(range.high, whole_limit);
  return range;
}

/// A plain value of this key, without its choices.
Json plain_of(const Key& key) {
  const Json number = number_of(key.range), text = {{"type", "string"}, {"minLength", 1}};
  switch (key.type) {
    case Type::text:
      return text;
    case Type::texts:
      return list_of({{"type", "string"}}, 0, 0);
    case Type::number:
      return number;
    case Type::formula: {
      Json either = text;
      either.update(number);
      either["type"] = {"number", "string"};
      return either;
    }
    case Type::whole:
      return number_of(whole_range(key.range), "integer");
    case Type::flag:
      return {{"type", "boolean"}};
    case Type::pair:
      return list_of(number, 2, 2);
    case Type::triple:
      return list_of(number, 3, 3);
    case Type::box:
      return list_of(number, 4, 4);
    case Type::solid_box:
      return list_of(number, 6, 6);
    case Type::numbers:
      return list_of(number, 1, 0);
    case Type::curve:
    case Type::history:
      return list_of(list_of(number, 2, 2), 2, most_pairs);
    case Type::refused:
      break;
  }
  return Json::object();
}

/// A default or a choice, as it is written in the table of keys.
Json value_of(const Key& key, const std::string& written) {
  switch (key.type) {
    case Type::text:
      return written;
    case Type::texts:
      assert(written == "[]");
      return Json::array();
    case Type::flag:
      return written == "true";
    case Type::whole:
      return std::stoi(written);
    default:
      return std::stod(written);
  }
}

Json choices_in(const Key& key) {
  Json choices = Json::array();
  for (const auto& choice : split(key.range.choices, '|')) choices.push_back(value_of(key, choice));
  return choices;
}

std::string description(const Key& key) {
  const std::string unit(key.unit), fallback(key.fallback);
  return std::string(key.doc) + "\n\n" + takes(key) + (unit.empty() ? "" : ", " + unit) +
         (fallback.empty()       ? ""
          : fallback == required ? ", required"
                                 : ", default " + fallback);
}

Json schema_of(const Spec& place);

void add_table(Json& schema, const Spec& place) {
  Json names = Json::object(), missing = Json::array();
  for (const auto& [name, child] : place.named) {
    if (child->key && child->key->type == Type::refused) continue;
    names[name] = schema_of(*child);
    if (child->key && child->key->fallback == required) missing.push_back(name);
  }
  schema["properties"] = std::move(names);
  if (!missing.empty()) schema["required"] = std::move(missing);
  if (place.any) schema["patternProperties"] = {{"^[A-Za-z0-9_-]+$", schema_of(*place.any)}};
  schema["additionalProperties"] = false;
}

/// A value that may be plain, a table, a list of tables, or one of these: each keyword speaks of values of one type, so
/// that an error stands where it is and not at a list of what the value might have been.
Json schema_of(const Spec& place) {
  Json schema = place.key ? plain_of(*place.key) : Json::object();
  Json types = Json::array();
  if (place.key) types = schema["type"].is_array() ? schema["type"] : Json::array({schema["type"]});
  if (place.is_table() && !place.list) types.push_back("object");
  if (place.list || place.list_or_table) {
    assert(!schema.contains("items") && "a list of tables beside a list of plain values cannot be said");
    types.push_back("array");
    Json element = {{"type", "object"}};
    add_table(element, place);
    schema["items"] = std::move(element);
    schema["minItems"] = 1;
  }
  schema["type"] = types.size() == 1 ? types[0] : types;
  if (place.is_table() && !place.list) add_table(schema, place);
  if (!place.key) return schema;
  const auto& key = *place.key;
  schema["description"] = description(key);
  if (!key.fallback.empty() && key.fallback != required) schema["default"] = value_of(key, std::string(key.fallback));
  if (key.range.choices.empty()) return schema;
  if (place.is_table())
    schema["anyOf"] = {{{"enum", choices_in(key)}}, {{"type", {"object", "array"}}}};
  else
    schema["enum"] = choices_in(key);
  return schema;
}

}  // namespace

std::string schema(const Spec& plane, const Spec& solids) {
  const Json of_plane = {{"$ref", "#/definitions/plane"}}, of_solids = {{"$ref", "#/definitions/solid"}};
  Json whole = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                {"title", "Reye scene"},
                {"description", "Input of Reye, which computes how contacts wear. Made by `reye schema`."}};
  whole["if"] = {{"properties", {{"analysis", {{"const", "solid"}}}}}, {"required", {"analysis"}}};
  whole["then"] = of_solids;
  whole["else"] = of_plane;
  // Always true: editors that do not follow `if` find here what to complete and explain.
  whole["anyOf"] = {of_plane, of_solids, Json::object()};
  whole["definitions"] = {{"plane", schema_of(plane)}, {"solid", schema_of(solids)}};
  return whole.dump(1) + '\n';
}

}  // namespace reye::scene
