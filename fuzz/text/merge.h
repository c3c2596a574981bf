// Merging by fields: any order of merging gives the same result.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <type_traits>
#include <vector>

#include "fuzz/text/field.h"
#include "kernel/base/enums.h"

namespace axiscert {

template <class T>
void merge(T& into, const T& from);
template <Fielded T>
void merge_fields(T& into, const T& from);

namespace merging {

// A type that says itself how two of it are merged.
template <class T>
concept Merged = requires(T& into, const T& from) { into.merge(from); };

template <class T>
struct Rule;  // not defined: the field has to say how two are merged

template <class T>
  requires(std::is_unsigned_v<T> && !std::is_same_v<T, bool>)
struct Rule<T> {
  static void merge(T& into, T from) { into = static_cast<T>(into + from); }
};
template <Merged T>
struct Rule<T> {
  static void merge(T& into, const T& from) { into.merge(from); }
};
template <Fielded T>
  requires(!Merged<T>)
struct Rule<T> {
  static void merge(T& into, const T& from) { merge_fields(into, from); }
};
template <class List>
struct EachOf {
  static void merge(List& into, const List& from) {
    if constexpr (requires { into.resize(from.size()); }) into.resize(std::max(into.size(), from.size()));
    for (std::size_t i = 0; i < from.size(); ++i) axiscert::merge(into[i], from[i]);
  }
};
template <class Enum, class T>
struct Rule<EnumArray<Enum, T>> : EachOf<EnumArray<Enum, T>> {};
template <class T, std::size_t n>
struct Rule<std::array<T, n>> : EachOf<std::array<T, n>> {};
// By name, whatever the order of each.
template <class T>
struct Rule<NamedValues<T>> {
  static void merge(NamedValues<T>& into, const NamedValues<T>& from) {
    for (const auto& [name, value] : from) {
      if (T* const found = into.find(name)) axiscert::merge(*found, value);
      else into.put(name) = value;
    }
  }
};
// Lists that a plan makes, of one length or empty.
template <class T>
  requires(!std::is_arithmetic_v<T>)
struct Rule<std::vector<T>> : EachOf<std::vector<T>> {};
// Numbers whose order has no meaning.
template <class T>
  requires std::is_arithmetic_v<T>
struct Rule<std::vector<T>> {
  static void merge(std::vector<T>& into, const std::vector<T>& from) {
    into.insert(into.end(), from.begin(), from.end());
  }
};
template <class Key, class T>
struct Rule<std::map<Key, T>> {
  static void merge(std::map<Key, T>& into, const std::map<Key, T>& from) {
    for (const auto& [key, value] : from) axiscert::merge(into[key], value);
  }
};
template <class T>
struct Rule<std::optional<T>> {
  static void merge(std::optional<T>& into, const std::optional<T>& from) {
    if (!from) return;
    if (into) axiscert::merge(*into, *from);
    else into = from;
  }
};

template <class T>
void increase(T& into, const T& more) {
  if constexpr (std::is_arithmetic_v<T>) into += more;
  else {
    for (std::size_t i = 0; i < into.size(); ++i) increase(into[i], more[i]);
  }
}

}  // namespace merging

template <Fielded T>
void merge_fields(T& into, const T& from) {
  for_each_field<T>([&](const auto& field) {
    using Of = std::remove_cvref_t<decltype(field)>;
    if constexpr (Of::is_stored) {
      auto& value = value_of(into, field);
      const auto& other = value_of(from, field);
      using How = typename Of::Merge;
      if constexpr (requires { How::merge(value, other); }) How::merge(value, other);
      else if constexpr (std::is_same_v<How, by::Greatest>) value = std::max(value, other);
      else if constexpr (std::is_same_v<How, by::Least>) value = std::min(value, other);
      else if constexpr (std::is_same_v<How, by::AddedUp>) merging::increase(value, other);
      else if constexpr (std::is_same_v<How, by::First>) value = value ? value : other;
      else if constexpr (std::is_same_v<How, by::Same>) return;
      else axiscert::merge(value, other);
    }
  });
}

template <class T>
void merge(T& into, const T& from) {
  merging::Rule<T>::merge(into, from);
}

}  // namespace axiscert
