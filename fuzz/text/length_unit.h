// Units of length, and lengths as people read them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axiscert {

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
