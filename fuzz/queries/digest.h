// Digests that determine a family to the bit: the same on every machine, with every compiler.
#pragma once

#include <string>

#include "fuzz/queries/family.h"

namespace axiscert {

// SHA-256, in hex, of the queries at seed 1 and positions 0 .. 4095 and 2^16 k, k = 1 .. 64: their thirteen coordinates
// in order, little-endian.
std::string family_digest(const Family& family, Precision precision);

// One line, without its line end: family, version, precision, digest. The committed file
// fuzz/families/sphere_triangle/digests.txt has one line for each family and precision, in the order of the registry.
std::string digest_line(const Family& family, Precision precision);

}  // namespace axiscert
