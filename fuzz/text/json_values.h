// Values as JSON, JSON read and checked as values, and the JSON Schema of what is read. json_form.h has those of
// structs.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <regex>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "exact/numbers/rational.h"
#include "fuzz/text/json.h"
#include "fuzz/text/number_text.h"
#include "fuzz/text/values.h"
#include "kernel/base/enums.h"
#include "kernel/base/error.h"

namespace axiscert {

template <class T>
Json json_of(const T& value) {
  return JsonForm<T>::write(value);
}
template <class T>
Json json_schema_of() {
  return JsonForm<T>::schema();
}

// JSON that is not what was expected: "/kernels/0/id: 7 is not of type string".
struct JsonFault : Error {
  using Error::Error;
};

// A value with its place in the file, as a JSON pointer.
class JsonPlace {
 public:
  explicit JsonPlace(const Json& value) : value_(value) {}
  const Json& value() const { return value_; }
  bool has(std::string_view member) const { return value_.contains(member); }
  JsonPlace at(std::string_view member) const;  // refused where there is none
  JsonPlace at(std::size_t i) const;

  [[noreturn]] void refuse(const std::string& problem) const;
  void require_type(bool is_it, std::string_view type) const;

 private:
  JsonPlace(const Json& value, std::string path) : value_(value), path_(std::move(path)) {}

  const Json& value_;
  std::string path_;
};

template <class T>
void read_json(const JsonPlace& place, T& into) {
  JsonForm<T>::read(place, into);
}
// Throws JsonFault.
template <class T>
T read_as(const Json& json) {
  T value = T();
  read_json(JsonPlace(json), value);
  return value;
}

// The code of every type that is read and written is made of these.
Json type_schema(std::string_view type);
Json nullable(Json schema);
Json array_schema(Json items, std::optional<std::size_t> size = {});
Json map_schema(Json values, Json names = nullptr);  // null: any names
void put_member(Json& object, std::string_view name, Json value);
[[noreturn]] void refuse_name(const JsonPlace& place, std::string_view member);
void refuse_other_names(const JsonPlace& place, bool (*is_known)(std::string_view));

// Numbers.

template <>
struct JsonForm<bool> {
  static Json write(bool value) { return value; }
  static void read(const JsonPlace& place, bool& into) {
    place.require_type(place.value().is_boolean(), "boolean");
    into = place.value();
  }
  static Json schema() { return type_schema("boolean"); }
};

// A count. At most 2^53 - 1, so that every reader of JSON keeps it.
template <>
struct JsonForm<std::uint64_t> {
  static constexpr std::uint64_t most = (std::uint64_t{1} << 53) - 1;
  static Json write(std::uint64_t value) { return value; }
  static void read(const JsonPlace& place, std::uint64_t& into) {
    place.require_type(place.value().is_number_integer(), "integer");
    if (!place.value().is_number_unsigned() && place.value() < 0) place.refuse("is outside the minimum of 0");
    into = place.value();
    if (into > most) place.refuse(fmt::format("is outside the maximum of {}", most));
  }
  static Json schema() { return {{"type", "integer"}, {"minimum", 0}, {"maximum", most}}; }
};

template <>
struct JsonForm<int> {
  static Json write(int value) { return value; }
  static void read(const JsonPlace& place, int& into) {
    place.require_type(place.value().is_number_integer(), "integer");
    if (place.value() < INT32_MIN || place.value() > INT32_MAX) place.refuse("is outside the range of 32 bits");
    into = place.value();
  }
  static Json schema() { return {{"type", "integer"}, {"minimum", INT32_MIN}, {"maximum", INT32_MAX}}; }
};

// A finite number, not negative.
template <>
struct JsonForm<double> {
  static Json write(double value) { return value; }
  static void read(const JsonPlace& place, double& into) {
    place.require_type(place.value().is_number(), "number");
    if (place.value() < 0) place.refuse("is outside the minimum of 0");
    into = place.value();
  }
  static Json schema() { return {{"type", "number"}, {"minimum", 0}}; }
};

template <>
struct JsonForm<SignedNumber> {
  static Json write(SignedNumber number) { return number.value; }
  static void read(const JsonPlace& place, SignedNumber& into) {
    place.require_type(place.value().is_number(), "number");
    into.value = place.value();
  }
  static Json schema() { return type_schema("number"); }
};

template <>
struct JsonForm<WholeNumber> {
  static Json write(WholeNumber number) { return number.value; }
  static void read(const JsonPlace& place, WholeNumber& into) {
    place.require_type(place.value().is_number_integer(), "integer");
    if (!place.value().is_number_unsigned() && place.value() < 0) place.refuse("is outside the minimum of 0");
    into.value = place.value();
  }
  static Json schema() { return {{"type", "integer"}, {"minimum", 0}}; }
};

template <>
struct JsonForm<ErrorNumber> {
  static Json write(const ErrorNumber& error) { return error.text.empty() ? Json(error.value) : Json(error.text); }
  static void read(const JsonPlace& place, ErrorNumber& into);
  static Json schema();
};

// An error: a number, or its text where binary64 cannot represent it.
template <>
struct JsonForm<Decimal6> {
  static Json write(Decimal6 value) {
    const double number = value.value();
    return std::isfinite(number) ? Json(number) : Json(value.text());
  }
  static void read(const JsonPlace& place, Decimal6& into);
  static Json schema() { return json_schema_of<ErrorNumber>(); }
};

void check_text(const JsonPlace& place, std::size_t longest, bool may_be_empty, const std::regex* pattern,
                std::string_view pattern_text);
Json text_schema(std::size_t longest, bool may_be_empty, std::string_view pattern);

template <class Rule>
struct JsonForm<Text<Rule>> {
  static constexpr bool may_be_empty = requires { Rule::may_be_empty; };
  static constexpr std::string_view pattern() {
    if constexpr (requires { Rule::pattern; }) return Rule::pattern;
    else return {};
  }
  static Json write(const Text<Rule>& value) { return static_cast<const std::string&>(value); }
  static void read(const JsonPlace& place, Text<Rule>& into) {
    static const std::regex compiled{std::string(pattern())};
    check_text(place, Rule::longest, may_be_empty, pattern().empty() ? nullptr : &compiled, pattern());
    into = printable_line(place.value().template get_ref<const std::string&>());
  }
  static Json schema() { return text_schema(Rule::longest, may_be_empty, pattern()); }
};

template <>
struct JsonForm<std::string> {
  static Json write(const std::string& value) { return value; }
  static void read(const JsonPlace& place, std::string& into) {
    place.require_type(place.value().is_string(), "string");
    into = printable_line(place.value().get_ref<const std::string&>());
  }
  static Json schema() { return type_schema("string"); }
};

template <>
struct JsonForm<WholeText> {
  static Json write(const WholeText& value) { return static_cast<const std::string&>(value); }
  static void read(const JsonPlace& place, WholeText& into) {
    place.require_type(place.value().is_string(), "string");
    into = place.value().get_ref<const std::string&>();
  }
  static Json schema() { return type_schema("string"); }
};

template <>
struct JsonForm<QueryLine> {
  static Json write(const QueryLine& line) { return Json::parse(static_cast<const std::string&>(line)); }
  static void read(const JsonPlace& place, QueryLine& into) {
    place.require_type(place.value().is_object(), "object");
    into = place.value().dump();
  }
  static Json schema() { return {{"description", "A line of a query file."}, {"type", "object"}}; }
};

// Any JSON.
template <>
struct JsonForm<Json> {
  static Json write(const Json& value) { return value; }
  static void read(const JsonPlace& place, Json& into) { into = place.value(); }
  static Json schema() { return Json::object(); }
};

// An enumerator by its name().
template <Enumeration Enum>
  requires(enum_count<Enum> > 0)
struct JsonForm<Enum> {
  static Json names() {
    Json all = Json::array();
    for (const Enum one : enumerators<Enum>) all.push_back(name(one));
    return all;
  }
  static bool is_name(std::string_view text) { return enumerator_named<Enum>(text).has_value(); }
  static Json write(Enum value) { return name(value); }
  static void read(const JsonPlace& place, Enum& into) {
    for (const Enum one : enumerators<Enum>) {
      if (place.value() != name(one)) continue;
      into = one;
      return;
    }
    place.refuse("is not one of " + names().dump());
  }
  static Json schema() { return {{"enum", names()}}; }
};

// Several values.

template <class T>
struct JsonForm<std::optional<T>> {
  static Json write(const std::optional<T>& value) { return value ? json_of(*value) : Json(nullptr); }
  static void read(const JsonPlace& place, std::optional<T>& into) {
    into.reset();
    if (!place.value().is_null()) read_json(place, into.emplace());
  }
  static Json schema() { return nullable(json_schema_of<T>()); }
};

template <class T>
struct JsonForm<std::vector<T>> {
  static Json write(const std::vector<T>& values) {
    Json json = Json::array();
    for (const T& value : values) json.push_back(json_of(value));
    return json;
  }
  static void read(const JsonPlace& place, std::vector<T>& into) {
    place.require_type(place.value().is_array(), "array");
    into.clear();
    for (std::size_t i = 0; i < place.value().size(); ++i) read_json(place.at(i), into.emplace_back());
  }
  static Json schema() { return array_schema(json_schema_of<T>()); }
};

// By name, where an enumerator is the key, or by number.
template <class Key, class T>
struct JsonForm<std::map<Key, T>> {
  static std::string text(Key key) {
    if constexpr (std::is_enum_v<Key>) return std::string(name(key));
    else return std::to_string(key);
  }
  static Json write(const std::map<Key, T>& values) {
    Json json = Json::object();
    for (const auto& [key, value] : values) put_member(json, text(key), json_of(value));
    return json;
  }
  static void read(const JsonPlace& place, std::map<Key, T>& into) {
    place.require_type(place.value().is_object(), "object");
    into.clear();
    for (const auto& [member, value] : place.value().items()) read_json(place.at(member), into[key(place, member)]);
  }
  static Json schema() {
    Json names = {{"pattern", "^(0|-?[1-9][0-9]*)$"}};
    if constexpr (std::is_enum_v<Key>) names = {{"enum", JsonForm<Key>::names()}};
    return map_schema(json_schema_of<T>(), std::move(names));
  }

 private:
  static Key key(const JsonPlace& place, const std::string& member) {
    if constexpr (std::is_enum_v<Key>) {
      for (const Key one : enumerators<Key>) {
        if (name(one) == member) return one;
      }
    } else {
      Key number{};
      const auto [end, error] = std::from_chars(member.data(), member.data() + member.size(), number);
      if (error == std::errc() && text(number) == member) return number;
    }
    refuse_name(place, member);
  }
};

template <class T, std::size_t n>
struct JsonForm<std::array<T, n>> {
  static Json write(const std::array<T, n>& values) {
    Json json = Json::array();
    for (const T& value : values) json.push_back(json_of(value));
    return json;
  }
  static void read(const JsonPlace& place, std::array<T, n>& into) {
    place.require_type(place.value().is_array(), "array");
    if (place.value().size() != n) place.refuse(fmt::format("has not {} items", n));
    for (std::size_t i = 0; i < n; ++i) read_json(place.at(i), into[i]);
  }
  static Json schema() { return array_schema(json_schema_of<T>(), n); }
};

template <class T>
struct JsonForm<NamedValues<T>> {
  static Json write(const NamedValues<T>& values) {
    Json json = Json::object();
    for (const auto& [name, value] : values) put_member(json, name, json_of(value));
    return json;
  }
  static void read(const JsonPlace& place, NamedValues<T>& into) {
    place.require_type(place.value().is_object(), "object");
    into = {};
    for (const auto& [name, value] : place.value().items()) read_json(place.at(name), into.put(printable_line(name)));
  }
  static Json schema() { return map_schema(json_schema_of<T>()); }
};

// A value for each enumerator, by its name.
template <class Enum, class T>
struct JsonForm<EnumArray<Enum, T>> {
  static Json write(const EnumArray<Enum, T>& values) {
    Json json = Json::object();
    for (const Enum one : enumerators<Enum>) put_member(json, name(one), json_of(values[one]));
    return json;
  }
  static void read(const JsonPlace& place, EnumArray<Enum, T>& into) {
    place.require_type(place.value().is_object(), "object");
    for (const Enum one : enumerators<Enum>) read_json(place.at(name(one)), into[one]);
    refuse_other_names(place, JsonForm<Enum>::is_name);
  }
  static Json schema() {
    Json schema = {{"type", "object"}, {"additionalProperties", false}, {"required", JsonForm<Enum>::names()}};
    for (const Enum one : enumerators<Enum>) put_member(schema["properties"], name(one), json_schema_of<T>());
    return schema;
  }
};

template <class Rule>
struct JsonForm<SparseCounts<Rule>> {
  static Json write(const SparseCounts<Rule>& counts) {
    Json json = Json::object();
    for (std::size_t i = 0; i < Rule::size; ++i) {
      if (counts[i] != 0) json[Rule::name(i)] = counts[i];
    }
    return json;
  }
  static void read(const JsonPlace& place, SparseCounts<Rule>& into) {
    place.require_type(place.value().is_object(), "object");
    into = {};
    for (const auto& [member, value] : place.value().items()) {
      std::size_t i = 0;
      while (i < Rule::size && Rule::name(i) != member) ++i;
      if (i == Rule::size) place.at(member).refuse("under a name that is not in the schema");
      read_json(place.at(member), into[i]);
    }
  }
  static Json schema() {
    Json names = Json::array();
    for (std::size_t i = 0; i < Rule::size; ++i) names.push_back(Rule::name(i));
    return {{"description", Rule::about},
            {"type", "object"},
            {"propertyNames", {{"enum", std::move(names)}}},
            {"additionalProperties", json_schema_of<std::uint64_t>()}};
  }
};

template <WrittenAs T>
struct JsonForm<T> {
  static Json write(const T& value) { return json_of(value.written()); }
  static void read(const JsonPlace& place, T& into) {
    typename T::Written written{};
    read_json(place, written);
    into.take(written);
  }
  static Json schema() { return json_schema_of<typename T::Written>(); }
};

template <class File>
struct JsonForm<FormatName<File>> {
  static Json write(FormatName<File>) { return File::format; }
  static void read(const JsonPlace& place, FormatName<File>&) {
    if (place.value() != File::format) place.refuse(fmt::format("is not \"{}\"", File::format));
  }
  static Json schema() { return {{"const", File::format}}; }
};

}  // namespace axiscert
