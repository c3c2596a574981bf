// The stored fields of a struct as a flat CBOR array, in their order: for the journal and between ranks. Equal values
// have equal bytes, in whatever order they were merged.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "exact/numbers/rational.h"
#include "fuzz/text/field.h"
#include "fuzz/text/json.h"
#include "kernel/base/enums.h"
#include "kernel/base/error.h"

namespace axiscert {

using Cbor = nlohmann::json;

// A type with members put(Encoder&) const and get(Decoder&) is written by these.
class Encoder {
 public:
  template <class T>
  void put(const T& value) {
    if constexpr (requires { value.put(*this); }) value.put(*this);
    else if constexpr (std::is_arithmetic_v<T>) all_.push_back(value);
    else if constexpr (Fielded<T>) {
      for_each_field<T>([&](const auto& field) {
        if constexpr (std::remove_cvref_t<decltype(field)>::is_stored) put(value_of(value, field));
      });
    } else {
      put_one(value);
    }
  }
  std::string bytes() const {
    std::string bytes;
    Cbor::to_cbor(all_, bytes);
    return bytes;
  }

 private:
  void put_one(const std::string& text) { all_.push_back(text); }
  void put_one(const Decimal6& decimal) {
    put(decimal.exponent);
    put(decimal.mantissa);
  }
  template <class T>
  void put_one(const std::optional<T>& value) {
    put(value.has_value());
    if (value) put(*value);
  }
  template <class Enum, class T>
  void put_one(const EnumArray<Enum, T>& values) {
    for (const T& value : values) put(value);
  }
  template <class T, std::size_t n>
  void put_one(const std::array<T, n>& values) {
    for (const T& value : values) put(value);
  }
  // Without the names, which a plan decides.
  template <class T>
  void put_one(const NamedValues<T>& values) {
    put(values.size());
    for (const auto& [name, value] : values) put(value);
  }
  template <class T>
    requires(!std::is_arithmetic_v<T>)
  void put_one(const std::vector<T>& values) {
    put(values.size());
    for (const T& value : values) put(value);
  }
  // Numbers whose order has no meaning: each value once, with its count. Many are equal.
  template <class Number>
    requires std::is_arithmetic_v<Number>
  void put_one(std::vector<Number> values) {
    std::sort(values.begin(), values.end());
    std::vector<std::pair<Number, std::size_t>> runs;
    for (const Number value : values) {
      if (runs.empty() || runs.back().first != value) runs.push_back({value, 0});
      ++runs.back().second;
    }
    put(runs.size());
    for (const auto& [value, count] : runs) {
      put(value);
      put(count);
    }
  }
  template <class Key, class T>
  void put_one(const std::map<Key, T>& values) {
    put(values.size());
    for (const auto& [key, value] : values) {
      put(key);
      put(value);
    }
  }

  Cbor all_ = Cbor::array();
};

// Reads what an Encoder wrote; throws Error, or Cbor::exception, for other bytes.
class Decoder {
 public:
  explicit Decoder(std::string_view bytes) : all_(Cbor::from_cbor(bytes)) {
    if (!all_.is_array()) throw Error("the bytes are not an array");
  }
  template <class T>
  void get(T& value) {
    if constexpr (requires { value.get(*this); }) value.get(*this);
    else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) value = whole_number<T>(next());
    else if constexpr (std::is_arithmetic_v<T>) next().get_to(value);
    else if constexpr (Fielded<T>) {
      for_each_field<T>([&](const auto& field) {
        if constexpr (std::remove_cvref_t<decltype(field)>::is_stored) get(value_of(value, field));
      });
    } else {
      get_one(value);
    }
  }
  template <class T>
  T next_of() {
    T value{};
    get(value);
    return value;
  }
  // How many elements follow, each of at least one number, and at most so many.
  std::size_t next_size(std::size_t most) {
    const auto size = next_of<std::size_t>();
    if (size > std::min(most, all_.size() - next_)) throw Error(fmt::format("the bytes have a list of {}", size));
    return size;
  }
  void finish() const {
    if (next_ != all_.size()) throw Error("the bytes go on after their end");
  }

 private:
  static constexpr std::size_t any_size = std::size_t(-1);

  const Cbor& next() { return all_.at(next_++); }
  void get_one(std::string& text) { next().get_to(text); }
  void get_one(Decimal6& decimal) {
    get(decimal.exponent);
    get(decimal.mantissa);
  }
  template <class T>
  void get_one(std::optional<T>& value) {
    if (!next_of<bool>()) value.reset();
    else get(value ? *value : value.emplace());  // one that is there has the lists that its plan makes
  }
  template <class Enum, class T>
  void get_one(EnumArray<Enum, T>& values) {
    for (T& value : values) get(value);
  }
  template <class T, std::size_t n>
  void get_one(std::array<T, n>& values) {
    for (T& value : values) get(value);
  }
  template <class T>
  void get_one(NamedValues<T>& values) {
    if (next_size(values.size()) != values.size()) throw Error("the bytes are of another plan");
    for (auto& [name, value] : values) get(value);
  }
  template <class T>
    requires(!std::is_arithmetic_v<T>)
  void get_one(std::vector<T>& values) {
    values.resize(next_size(any_size));
    for (T& value : values) get(value);
  }
  template <class Number>
    requires std::is_arithmetic_v<Number>
  void get_one(std::vector<Number>& values) {
    constexpr std::size_t most = std::size_t{1} << 16;  // a source's (has_critical_radius)
    for (std::size_t runs = next_size(any_size); runs > 0; --runs) {
      const auto value = next_of<Number>();
      const auto count = next_of<std::size_t>();
      if (count > most) throw Error(fmt::format("the bytes have a number {} times", count));
      values.insert(values.end(), count, value);
    }
  }
  template <class Key, class T>
  void get_one(std::map<Key, T>& values) {
    for (std::size_t size = next_size(any_size); size > 0; --size) {
      const auto key = next_of<Key>();
      get(values[key]);
    }
  }

  Cbor all_;
  std::size_t next_ = 0;
};

}  // namespace axiscert
