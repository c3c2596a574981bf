// Types of members that say more than a number or a text does, and what JSON is made of them, declared: a struct needs
// no more. Who writes or reads JSON takes json_form.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>

#include "fuzz/text/field.h"
#include "fuzz/text/json_fwd.h"

namespace axiscert {

class JsonPlace;

// What a type is in JSON: static Json write(const T&); void read(JsonPlace, T&), which refuses all but what write()
// gives; static Json schema(). Json itself is not asked for more levels than parsed_json() allows.
template <class T>
struct JsonForm;
// The same of what is written as another value: `using Written`, Written written() const, void take(Written).
template <class T>
concept WrittenAs = requires { typename T::Written; };

struct SignedNumber {
  double value = 0;
};

// A whole number of 64 bits that counts nothing.
struct WholeNumber {
  std::uint64_t value = 0;
};

// An error of more digits than a Decimal6, or less than binary64 has with six: a number, or its text beyond binary64.
struct ErrorNumber {
  double value = 0;
  std::string text = {};  // not empty: beyond binary64
};

// Text of a form: `Rule` has `longest`, and may have `pattern`, a regular expression, and `may_be_empty`.
template <class Rule>
struct Text : std::string {
  using std::string::string;
  Text(std::string text) : std::string(std::move(text)) {}
  Text(std::string_view text) : std::string(text) {}
};
struct NameRule {
  static constexpr std::size_t longest = 4096;
};
using Name = Text<NameRule>;  // not empty

// Text of our own that has more than one line: it is read as it is.
struct WholeText : std::string {
  using std::string::string;
  using std::string::operator=;
};

// A line of a query file, which JSON has as the object that it is.
struct QueryLine : std::string {
  using std::string::string;
  QueryLine(std::string text) : std::string(std::move(text)) {}
};

// The name and version of the format of a file, as its struct says it.
template <class File>
struct FormatName {};

// Counts under many names, most of them zero: JSON has the others. `Rule` has `size`, `name(i)` and `about`.
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

}  // namespace axiscert
