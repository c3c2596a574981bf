#include "reports/run_folder/schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <stdexcept>

#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

using Fault = std::optional<std::string>;

std::string description(const Json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "an array";
  return shown(value.dump());
}

bool is_type(const Json& value, const std::string& type) {
  if (type == "null") return value.is_null();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  if (type == "string") return value.is_string();
  if (type == "array") return value.is_array();
  if (type == "object") return value.is_object();
  throw std::logic_error("schema: unknown type " + type);
}

class Checker {
 public:
  explicit Checker(const Json& root) : root_(root) {}

  Fault check(const Json& schema, const Json& value, const std::string& where) {
    for (const auto& [keyword, rule] : schema.items()) {
      if (Fault fault = check_keyword(keyword, rule, schema, value, where)) return fault;
    }
    return std::nullopt;
  }

 private:
  static Fault wrong(const std::string& where, const Json& value, const std::string& problem) {
    return fmt::format("{}: {} {}", where.empty() ? "/" : where, description(value), problem);
  }

  Fault check_keyword(const std::string& keyword, const Json& rule, const Json& schema, const Json& value,
                      const std::string& where) {
    if (keyword == "$ref") {
      return check(root_.at(Json::json_pointer(rule.get<std::string>().substr(1))), value, where);
    }
    if (keyword == "type") return check_type(rule, value, where);
    if (keyword == "const") return value == rule ? Fault() : wrong(where, value, "is not " + rule.dump());
    if (keyword == "enum") {
      const bool found = std::find(rule.begin(), rule.end(), value) != rule.end();
      return found ? Fault() : wrong(where, value, "is not one of " + rule.dump());
    }
    if (keyword == "anyOf") return check_any(rule, value, where);
    if (keyword == "minimum" || keyword == "maximum") {
      const bool is_bad = value.is_number() && (keyword == "minimum" ? value < rule : value > rule);
      return is_bad ? wrong(where, value, fmt::format("is outside the {} of {}", keyword, rule.dump())) : Fault();
    }
    if (keyword == "minLength" || keyword == "maxLength" || keyword == "pattern") {
      return value.is_string() ? check_text(keyword, rule, schema, value, where) : Fault();
    }
    if (keyword == "required" || keyword == "properties" || keyword == "additionalProperties") {
      return value.is_object() ? check_members(keyword, rule, schema, value, where) : Fault();
    }
    if (keyword == "propertyNames") return value.is_object() ? check_names(rule, value, where) : Fault();
    if (keyword == "items" || keyword == "minItems" || keyword == "maxItems" || keyword == "uniqueItems") {
      return value.is_array() ? check_items(keyword, rule, value, where) : Fault();
    }
    for (const char* note : {"$schema", "$defs", "title", "description"}) {
      if (keyword == note) return std::nullopt;
    }
    throw std::logic_error("schema: unknown keyword " + keyword);
  }

  static Fault check_type(const Json& rule, const Json& value, const std::string& where) {
    const Json types = rule.is_array() ? rule : Json::array({rule});
    for (const Json& type : types) {
      if (is_type(value, type.get<std::string>())) return std::nullopt;
    }
    return wrong(where, value,
                 rule.is_array() ? "is not one of " + rule.dump() : "is not of type " + rule.get<std::string>());
  }

  Fault check_any(const Json& rule, const Json& value, const std::string& where) {
    Fault last;
    for (const Json& choice : rule) {
      last = check(choice, value, where);
      if (!last) return std::nullopt;
    }
    return last;
  }

  // The length is counted in bytes, which is at least as strict as in characters. A text over its limit never reaches
  // the regular expression, whose depth of recursion grows with the text.
  Fault check_text(const std::string& keyword, const Json& rule, const Json& schema, const Json& value,
                   const std::string& where) {
    const auto& text = value.get_ref<const std::string&>();
    if (keyword == "minLength") return text.size() < rule ? wrong(where, value, "is empty") : Fault();
    if (keyword == "maxLength") return text.size() > rule ? wrong(where, value, "is too long") : Fault();
    if (!schema.contains("maxLength")) throw std::logic_error("schema: pattern without maxLength at " + where);
    const auto& pattern = rule.get_ref<const std::string&>();
    if (text.size() > schema.at("maxLength")) return std::nullopt;  // the keyword maxLength says so
    const auto found = patterns_.try_emplace(pattern, pattern).first;
    return std::regex_search(text, found->second) ? Fault() : wrong(where, value, "does not match " + pattern);
  }

  Fault check_members(const std::string& keyword, const Json& rule, const Json& schema, const Json& value,
                      const std::string& where) {
    if (keyword == "required") {
      for (const Json& name : rule) {
        if (!value.contains(name)) return wrong(where, value, "without " + name.dump());
      }
      return std::nullopt;
    }
    for (const auto& [name, member] : value.items()) {
      const bool is_known = schema.contains("properties") && schema.at("properties").contains(name);
      if (is_known != (keyword == "properties")) continue;
      const std::string place = where + "/" + shown(name);
      if (rule.is_boolean() && !rule.get<bool>()) return wrong(place, member, "under a name that is not in the schema");
      if (Fault fault = check(is_known ? rule.at(name) : rule, member, place)) return fault;
    }
    return std::nullopt;
  }

  Fault check_names(const Json& rule, const Json& value, const std::string& where) {
    for (const auto& [name, member] : value.items()) {
      if (Fault fault = check(rule, Json(name), where + "/" + shown(name))) return fault;
    }
    return std::nullopt;
  }

  Fault check_items(const std::string& keyword, const Json& rule, const Json& value, const std::string& where) {
    if (keyword == "minItems") return value.size() < rule ? wrong(where, value, "with too few items") : Fault();
    if (keyword == "maxItems") return value.size() > rule ? wrong(where, value, "with too many items") : Fault();
    for (std::size_t i = 0; i < value.size(); ++i) {
      const std::string place = fmt::format("{}/{}", where, i);
      if (keyword == "items") {
        if (Fault fault = check(rule, value[i], place)) return fault;
      } else if (std::find(value.begin(), value.begin() + static_cast<std::ptrdiff_t>(i), value[i]) !=
                 value.begin() + static_cast<std::ptrdiff_t>(i)) {
        return wrong(place, value[i], "appears twice");
      }
    }
    return std::nullopt;
  }

  const Json& root_;
  std::map<std::string, std::regex> patterns_;
};

}  // namespace

std::optional<std::string> schema_fault(const Json& schema, const Json& value) {
  return Checker(schema).check(schema, value, "");
}

void require_format(const Json& value, std::string_view format, const std::string& name, const std::string& advice) {
  if (!value.is_object() || !value.contains("schema"))
    throw Error(fmt::format("{}: has no \"schema\": \"{}\", which axiscert writes; {}", name, format, advice));
  if (value["schema"] != format) {
    throw Error(
        fmt::format("{}: its schema is {}, but this axiscert reads \"{}\"; use the axiscert that wrote it, or run "
                    "again",
                    name, shown(value["schema"].dump()), format));
  }
}

void refuse_file(std::string_view format, const std::string& fault, const std::string& name,
                 const std::string& advice) {
  throw Error(fmt::format("{}: does not conform to {}: {}; {}", name, format, fault, advice));
}

}  // namespace axiscert
