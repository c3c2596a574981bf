// Structs as JSON, JSON read and checked as structs, and the JSON Schema of what is read: all from the fields.
#pragma once

#include "fuzz/text/field.h"
#include "fuzz/text/json_values.h"

namespace axiscert {

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <class T>
inline constexpr bool is_named_list = false;
template <class T>
inline constexpr bool is_named_list<NamedValues<T>> = true;

template <class T>
inline constexpr bool has_rest = [] {
  bool found = false;
  for_each_written<T>([&](const auto& field) { found |= field.is_rest; });
  return found;
}();

Json object_schema(bool is_open, std::string_view about);
void describe_member(Json& schema, const Field& field, Json (*schema_of_member)());
// Makes the member null where it was looked at on nothing.
void clear_unseen(Json& object, const Field& field);
// Whether a member that is there was looked at on nothing.
bool is_unseen(const JsonPlace& place, const Field& field);
// Throws JsonFault where a member that was looked at on nothing says more than that: then `value` is not `nothing`.
void require_nothing(const JsonPlace& place, const Field& field, const Json& value, const Json& nothing);
// Throws JsonFault where a member is not what the members beside it say.
void require_said(const JsonPlace& place, std::string_view member, const Json& expected);

// Once for each type, and not for each field: these keep the temporaries out of the code of structs.
template <class Value>
void put_value(Json& object, std::string_view name, const Value& value) {
  put_member(object, name, json_of(value));
}
template <class Value>
void read_member(const JsonPlace& place, std::string_view name, Value& into) {
  read_json(place.at(name), into);
}

template <Fielded T>
struct JsonForm<T> {
  static constexpr bool is_open = requires { T::is_open; };

  static Json write(const T& value) {
    Json json = Json::object();
    put(json, value);
    return json;
  }
  static void read(const JsonPlace& place, T& into) {
    place.require_type(place.value().is_object(), "object");
    get(place, into);
    if constexpr (has_rest<T>) get_rest(place, into);
    else if constexpr (!is_open) refuse_other_names(place, has);
  }
  static Json schema() {
    std::string_view about;
    if constexpr (requires { T::about; }) about = T::about;
    Json schema = object_schema(is_open, about);
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
          if (of) put_value(json, field.name, *of);
          return;
        }
      }
      put_value<Value>(json, field.name, of);
    });
    for_each_written<T>([&](const auto& field) { clear_unseen(json, field); });
  }
  static void get(const JsonPlace& place, T& into) {
    for_each_written<T>([&](const auto& field) {
      using Value = std::remove_cvref_t<decltype(value_of(into, field))>;
      if constexpr (std::remove_cvref_t<decltype(field)>::is_stored) {
        if constexpr (Fielded<Value>) {
          if (field.is_inlined) return JsonForm<Value>::get(place, value_of(into, field));
        }
        Value& of = value_of(into, field);
        if constexpr (is_named_list<Value>) {
          if (field.is_rest) return void(of = {});
        }
        const bool unseen = is_unseen(place, field);
        if (unseen && place.at(field.name).value().is_null()) return;
        if constexpr (is_optional<Value>) {
          if (field.may_be_absent) {
            of.reset();
            if (!place.has(field.name)) return;
            read_member(place, field.name, of.emplace());
            if (unseen) require_nothing(place, field, json_of(*of), json_of(*Value(std::in_place)));
            return;
          }
        }
        read_member(place, field.name, of);
        if (unseen) require_nothing(place, field, json_of(of), json_of(Value()));
      }
    });
    // Fields that others already say.
    for_each_written<T>([&](const auto& field) {
      if constexpr (!std::remove_cvref_t<decltype(field)>::is_stored) {
        if (is_unseen(place, field) && place.at(field.name).value().is_null()) return;
        require_said(place, field.name, json_of(value_of(into, field)));
      }
    });
  }
  // Members whose names no field has.
  static void get_rest(const JsonPlace& place, T& into) {
    for (const auto& [member, value] : place.value().items()) {
      if (has(member)) continue;
      for_each_written<T>([&](const auto& field) {
        if constexpr (is_named_list<std::remove_cvref_t<decltype(value_of(into, field))>>) {
          if (field.is_rest) read_json(place.at(member), value_of(into, field).put(member));
        }
      });
    }
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
      if constexpr (is_named_list<Value>) {
        if (field.is_rest)
          return put_member(schema, "additionalProperties", JsonForm<Value>::schema()["additionalProperties"]);
      }
      if constexpr (is_optional<Value>) {
        if (field.may_be_absent) return describe_member(schema, field, json_schema_of<typename Value::value_type>);
      }
      describe_member(schema, field, json_schema_of<Value>);
    });
  }
};

// Puts back, at any depth, what is null for having been looked at on nothing: as zeros, which add up.
template <Fielded T>
void put_unseen(Json& json, const T& value) {
  for_each_written<T>([&](const auto& field) {
    const auto& of = value_of(value, field);
    using Value = std::remove_cvref_t<decltype(of)>;
    if constexpr (is_optional<Value>) {
      if (!of) return;
      if (!field.looked_at.empty()) put_value(json, field.name, *of);
      else if constexpr (Fielded<typename Value::value_type>) put_unseen(json[std::string(field.name)], *of);
    } else if (!field.looked_at.empty()) {
      put_value<Value>(json, field.name, of);
    } else if constexpr (Fielded<Value>) {
      put_unseen(field.is_inlined ? json : json[std::string(field.name)], of);
    }
  });
}

}  // namespace axiscert
