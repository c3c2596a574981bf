// Counts under many names, most of them zero: JSON has the others.
#pragma once

#include <array>
#include <cstdint>
#include <numeric>

#include "fuzz/fields/json_form.h"

namespace axiscert {

// `Rule` has `size`, `name(i)` and `about`.
template <class Rule>
struct SparseCounts : std::array<std::uint64_t, Rule::size> {
  std::uint64_t sum() const { return std::accumulate(this->begin(), this->end(), std::uint64_t{0}); }
  void merge(const SparseCounts& other) {
    for (std::size_t i = 0; i < Rule::size; ++i) (*this)[i] += other[i];
  }
  void put(auto& encoder) const {
    for (const std::uint64_t count : *this) encoder.put(count);
  }
  void get(auto& decoder) {
    for (std::uint64_t& count : *this) decoder.get(count);
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

}  // namespace axiscert
