// Conversion between text and numbers, exactly: the only form in which a number is written in a query file, a witness
// or a report; and units of length, and lengths as people read them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axiscert {

// C hexadecimal ("0x1.8p-3", "-0x1p+0") has to be exact in Real. Decimal ("0.2", "-1e-9") becomes the Real nearest to
// the text itself, ties to even, subnormals included, as a compiler rounds a literal. "nan", "inf" and "-inf" are
// values. Any other text, and a number beyond the range, throws Error. Nothing depends on the locale.
template <class Real>
Real parse_number(std::string_view text);

// C hexadecimal with the fewest digits and a leading 1 ("0x1.8p-3", "0x1p-149", "-0x0p+0"), or "nan", "inf", "-inf".
// parse_number returns the same number; a NaN remains a NaN but loses its payload.
template <class Real>
std::string format_number(Real x);

// The lowest `count` bits as 0 and 1, bit 0 first: the form in which comparisons, ties and axes are written everywhere.
std::string bit_string(std::uint64_t bits, std::size_t count);

// A piece of input in the form in which a message may quote it: one line, no control characters, truncated if long.
std::string shown(std::string_view text);

struct LengthUnit {
  std::string_view name;  // "cm"
  double metres;          // rounded to nearest
};

// Null where there is no such unit.
const LengthUnit* find_length_unit(std::string_view name);
std::vector<std::string_view> length_unit_names();

// "16.6 cm", "1.23 mm", "12 um", "3.4 km": three digits, in the metric unit that leaves 1 to 1000 of them.
std::string metric_text(double metres);

// A length of queries whose unit is known, or, where none is, "0.166 units".
std::string length_text(double length, const LengthUnit* unit);

// "1mm", "0.5 ft": in metres. Empty where the text is no number above 0 followed by a unit.
std::optional<double> length_in_metres(std::string_view text);

}  // namespace axiscert
