// Structs as JSON, JSON read and checked as structs, and the JSON Schema of what is read: all from the fields.
#pragma once

#include "fuzz/fields/field.h"
#include "fuzz/fields/json_values.h"

namespace axiscert {

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <class T>
inline constexpr bool is_named_list = false;
template <class T>
inline constexpr bool is_named_list<NamedValues<T>> = true;

template <Fielded T>
struct JsonForm<T> {
  static Json write(const T& value) {
    Json json = Json::object();
    put(json, value);
    return json;
  }
  static void read(const JsonPlace& place, T& into) {
    place.require_type(place.value().is_object(), "object");
    get(place, into);
    if constexpr (requires { T::is_open; }) return;
    for (const auto& [member, value] : place.value().items()) {
      if (!has(member) && !get_rest(place, member, into))
        place.at(member).refuse("under a name that is not in the schema");
    }
  }
  static Json schema() {
    constexpr bool is_open = requires { T::is_open; };
    Json schema = {{"type", "object"}, {"additionalProperties", is_open}, {"required", Json::array()}};
    if constexpr (requires { T::about; }) schema["description"] = T::about;
    schema["properties"] = Json::object();
    describe(schema);
    return schema;
  }

  static void put(Json& json, const T& value) {
    for_each_written<T>([&](const auto& field) {
      using Value = std::remove_cvref_t<decltype(value_of(value, field))>;
      if constexpr (Fielded<Value>) {
        if (field.is_inlined) return JsonForm<Value>::put(json, value_of(value, field));
      }
      const Value& of = value_of(value, field);
      if constexpr (is_named_list<Value>) {
        if (field.is_rest) return json.update(json_of(of));
      }
      if constexpr (is_optional<Value>) {
        if (field.may_be_absent) {
          if (of) json[std::string(field.name)] = json_of(*of);
          return;
        }
      }
      json[std::string(field.name)] = json_of<Value>(of);
    });
  }
  static void get(const JsonPlace& place, T& into) {
    for_each_written<T>([&](const auto& field) {
      using Value = std::remove_cvref_t<decltype(value_of(into, field))>;
      if constexpr (std::remove_cvref_t<decltype(field)>::is_stored) {
        if constexpr (Fielded<Value>) {
          if (field.is_inlined) return JsonForm<Value>::get(place, value_of(into, field));
        }
        Value& of = value_of(into, field);
        const bool is_there = place.value().contains(field.name);
        if constexpr (is_named_list<Value>) {
          if (field.is_rest) return void(of = {});
        }
        if constexpr (is_optional<Value>) {
          if (field.may_be_absent) {
            of.reset();
            if (is_there) read_json(place.at(field.name), of.emplace());
            return;
          }
        }
        if (!is_there) place.refuse(fmt::format("without {}", Json(field.name).dump()));
        read_json(place.at(field.name), of);
      }
    });
    // What the others say already.
    for_each_written<T>([&](const auto& field) {
      if constexpr (!std::remove_cvref_t<decltype(field)>::is_stored) {
        if (!place.value().contains(field.name)) place.refuse(fmt::format("without {}", Json(field.name).dump()));
        const Json expected = json_of(value_of(into, field));
        if (place.value()[std::string(field.name)] != expected)
          place.at(field.name).refuse(fmt::format("is not {}, as the members beside it say", expected.dump()));
      }
    });
  }
  // A member whose name no field has.
  static bool get_rest(const JsonPlace& place, const std::string& member, T& into) {
    bool is_got = false;
    for_each_written<T>([&](const auto& field) {
      if constexpr (is_named_list<std::remove_cvref_t<decltype(value_of(into, field))>>) {
        if (!field.is_rest) return;
        read_json(place.at(member), value_of(into, field).put(member));
        is_got = true;
      }
    });
    return is_got;
  }
  static bool has(std::string_view member) {
    bool found = false;
    for_each_written<T>([&](const auto& field) {
      using Value = std::remove_cvref_t<decltype(value_of(std::declval<const T&>(), field))>;
      if constexpr (Fielded<Value>) {
        if (field.is_inlined) found |= JsonForm<Value>::has(member);
      }
      found |= !field.is_inlined && !field.is_rest && field.name == member;
    });
    return found;
  }
  static void describe(Json& schema) {
    for_each_written<T>([&](const auto& field) {
      using Value = std::remove_cvref_t<decltype(value_of(std::declval<const T&>(), field))>;
      if constexpr (Fielded<Value>) {
        if (field.is_inlined) return JsonForm<Value>::describe(schema);
      }
      if (field.is_rest) {
        if constexpr (is_named_list<Value>)
          schema["additionalProperties"] = JsonForm<Value>::schema()["additionalProperties"];
        return;
      }
      Json& member = schema["properties"][std::string(field.name)];
      if constexpr (is_optional<Value>) {
        if (field.may_be_absent) member = json_schema_of<typename Value::value_type>();
      }
      if (member.is_null()) member = json_schema_of<Value>();
      if (!field.about.empty()) member["description"] = field.about;
      if (!field.unit.empty()) member["unit"] = field.unit;
      if (!field.may_be_absent) schema["required"].push_back(field.name);
    });
  }
};

}  // namespace axiscert
