// The format of figures that several instruments show.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "fuzz/queries/address.h"
#include "fuzz/instruments/extreme.h"
#include "fuzz/text/json.h"
#include "reports/wording/summary.h"

namespace axiscert {

// A JSON number; text where binary64 cannot hold it.
inline Json number_json(const Decimal6& decimal) {
  const double value = decimal.value();
  return std::isfinite(value) ? Json(value) : Json(decimal.text());
}
// The number to four significant digits.
inline std::string shown(const Decimal6& decimal) {
  const double value = decimal.value();
  return std::isfinite(value) ? amount(value, 4) : decimal.text();
}

// The origin of an instrument's queries, for their addresses.
struct QueryOrigin {
  std::uint64_t seed;
  Precision precision;

  std::string address(const Source& source, std::uint64_t position) const {
    return text(address_of(source, seed, precision, position));
  }
  // {NAME: value, "address": ...}, or null.
  Json measured_json(const std::optional<Measured>& measured, const char* name, const Source& source) const {
    if (!measured) return nullptr;
    return {{name, number_json(measured->value)}, {"address", address(source, measured->position)}};
  }
};

}  // namespace axiscert
