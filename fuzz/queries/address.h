// An address: all that is needed to make one query again, on any machine.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "fuzz/queries/source.h"

namespace axiscert {

// The text form is SEED:NAME:VERSION:PRECISION:UNIT:INDEX, for instance 1:tangent:1:binary32:0:1234. The name of a mesh
// or a query file is mesh-SHA256 or queries-SHA256.
struct Address {
  std::uint64_t seed;
  std::string name;
  int version;
  Precision precision;
  std::uint64_t unit, index;  // index < 2^16

  std::uint64_t position() const { return unit * unit_size + index; }
};

// The text of the address of a position, for code that lists positions and does not know their source.
using AddressOf = std::function<std::string(std::uint64_t position)>;

std::string text(const Address& address);
Address address_of(const Source& source, std::uint64_t seed, Precision precision, std::uint64_t position);

// The queries of a source in a precision, made of a seed.
struct SeededSource {
  const Source& source;
  std::uint64_t seed;
  Precision precision;

  // The text of a position's address.
  std::string address(std::uint64_t position) const { return text(address_of(source, seed, precision, position)); }
  AddressOf addresses() const {
    return [of = *this](std::uint64_t position) { return of.address(position); };
  }
};

// Throws Error that says which field is wrong and shows the form.
Address parse_address(std::string_view text);
// Throws Error that lists the precisions that exist.
Precision parse_precision(std::string_view text);

}  // namespace axiscert
