// What exact arithmetic tells of a valid query besides its verdict: lengths, places, directions and names.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "exact/judge/depth.h"
#include "exact/numbers/roots.h"

namespace axiscert {

using ExactValue = std::variant<RootNumber, ExactDepth>;

// Nothing is rounded here: whoever shows a fact rounds it once.
struct ExactFact {
  std::string_view name;
  std::vector<ExactValue> numbers = {};  // one, or the three coordinates of a place or a direction
  std::vector<std::string_view> names = {};
  std::string_view unit = {};  // "of the scene"; lengths are in the unit of the query's numbers, and say none
  std::string_view note = {};  // that there is none, or more than one, and why
};

// A length, a point and the direction of a vector v, of length 1 and of the number type that tells it.
inline ExactFact length_fact(std::string_view name, RootNumber length) { return {name, {std::move(length)}}; }
ExactFact place_fact(std::string_view name, const Rational& x, const Rational& y, const Rational& z);
// Without numbers where v is 0.
ExactFact direction_fact(std::string_view name, const Rational& x, const Rational& y, const Rational& z);
inline ExactFact depth_fact(ExactDepth depth) { return {"depth", {std::move(depth)}, {}, "of the scene"}; }

// The decimal nearest to the value with so many significant digits; and the value itself, as a fraction or with roots.
std::string decimal_text(const ExactValue& value, int digits);
std::string exact_text(const ExactValue& value);

}  // namespace axiscert
