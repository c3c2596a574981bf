// Digests that determine a family to the bit: the same on every machine, with every compiler.
#pragma once

#include <string>
#include <vector>

#include "fuzz/queries/family.h"

namespace axiscert {

// SHA-256, in hex, of the queries at seed 1 and positions 0 .. 4095 and 2^16 k, k = 1 .. 64: their numbers in
// order, little-endian.
std::string family_digest(const Family& family, Precision precision);

// One line, without its line end: family, version, precision, digest.
std::string digest_line(const Family& family, Precision precision);

// The lines of a predicate's families, in the order of its list, for each precision: the committed digests.txt beside
// that list holds them.
std::vector<std::string> digest_lines(const Predicate& predicate);

}  // namespace axiscert
