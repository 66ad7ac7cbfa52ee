#include "tests/tools/json_schema.h"

#include <algorithm>
#include <regex>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace candela::cli_test {
namespace {

using Json = nlohmann::json;

constexpr std::string_view understood[] = {
    "$schema", "$id",      "title",      "description",
    "type",    "required", "properties", "additionalProperties",
    "items",   "minItems", "maxItems",   "minimum",
    "enum",    "pattern"};

bool has_type(const Json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "null") return value.is_null();
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  return false;
}

class Validator {
 public:
  std::vector<std::string> violations;

  void validate(const Json& schema, const Json& value, const std::string& place) {
    check_keywords(schema, place);
    if (schema.contains("type") && !check_type(schema["type"], value, place)) return;
    check_scalar(schema, value, place);
    if (value.is_object()) check_object(schema, value, place);
    if (value.is_array()) check_array(schema, value, place);
  }

 private:
  void fail(const std::string& place, const std::string& what) {
    violations.push_back(fmt::format("{}: {}", place.empty() ? "/" : place, what));
  }

  void check_keywords(const Json& schema, const std::string& place) {
    for (const auto& [keyword, ignored] : schema.items())
      if (std::find(std::begin(understood), std::end(understood), keyword) == std::end(understood))
        fail(place, "the schema's keyword '" + keyword + "' is not understood");
  }

  bool check_type(const Json& types, const Json& value, const std::string& place) {
    const Json list = types.is_array() ? types : Json::array({types});
    for (const Json& type : list)
      if (has_type(value, type.get<std::string>())) return true;
    fail(place, fmt::format("{} is not of type {}", value.dump(), types.dump()));
    return false;
  }

  void check_scalar(const Json& schema, const Json& value, const std::string& place) {
    if (schema.contains("enum") &&
        std::find(schema["enum"].begin(), schema["enum"].end(), value) == schema["enum"].end())
      fail(place, value.dump() + " is not one of " + schema["enum"].dump());
    if (schema.contains("minimum") && value.is_number() &&
        value.get<double>() < schema["minimum"].get<double>())
      fail(place, value.dump() + " is below " + schema["minimum"].dump());
    if (schema.contains("pattern") && value.is_string() &&
        !std::regex_search(value.get<std::string>(),
                           std::regex(schema["pattern"].get<std::string>())))
      fail(place, value.dump() + " does not match " + schema["pattern"].dump());
  }

  void check_object(const Json& schema, const Json& value, const std::string& place) {
    const Json properties = schema.value("properties", Json::object());
    for (const Json& name : schema.value("required", Json::array()))
      if (!value.contains(name.get<std::string>())) fail(place, "lacks " + name.dump());
    for (const auto& [name, member] : value.items()) {
      if (properties.contains(name))
        validate(properties[name], member, place + "/" + name);
      else if (schema.contains("additionalProperties") && schema["additionalProperties"] == false)
        fail(place, "'" + name + "' is not in the schema");
    }
  }

  void check_array(const Json& schema, const Json& value, const std::string& place) {
    if (schema.contains("minItems") && value.size() < schema["minItems"].get<std::size_t>())
      fail(place, "too few items");
    if (schema.contains("maxItems") && value.size() > schema["maxItems"].get<std::size_t>())
      fail(place, "too many items");
    if (!schema.contains("items")) return;
    for (std::size_t i = 0; i < value.size(); ++i)
      validate(schema["items"], value[i], fmt::format("{}/{}", place, i));
  }
};

}  // namespace

std::vector<std::string> schema_violations(const std::string& schema, const std::string& value) {
  Validator validator;
  validator.validate(Json::parse(schema), Json::parse(value), "");
  return validator.violations;
}

}  // namespace candela::cli_test
