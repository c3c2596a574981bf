// Conversion between text and numbers, exactly: the only form in which a number is written in a query file, a witness
// or a report.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

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

}  // namespace axiscert
