// Sentences about answers that change with an exact image of a query: from which size on, and which number of the
// kernel's own explains them.
#pragma once

#include <string>

#include "fuzz/text/json.h"

namespace axiscert {

// A family's images of one kind, in the record of a family; null where it makes none, or the record has none.
const Json* changes_of(const Json& family, const std::string& kind);
// Those of the kind `scale` where all are within the range of forms of degree 6; null where that is not so.
const Json* units_of(const Json& family);

// Says of a record's counts by size, of powers of two: "from 2^-7 down", "from 2^3 up", "from 2^-7 down and from 2^3
// up".
std::string powers_text(const Json& by_size);
// The least exponent of a record's counts by size, which are not empty.
int least_size(const Json& by_size);
// Says of a record's "wrong" (images in other units of length): "where numbers are small, as if an absolute number near
// 0.01 (squared 0.0001) were compared with the distance d"; what it found of both directions. Where nothing common
// explains the answers, a sentence that says so.
std::string absolute_number_text(const Json& wrong);
// The failure of a family's images within the range of degree 6: how often and from which power on the verdict is
// wrong, or changes, and why.
struct UnitChange {
  std::uint64_t count = 0;
  std::string what;
  Json first;  // the addresses of base and image; null where there is none
};
// The change of a family's "scale" in the record, with a range. `count` is 0 where no verdict changes.
UnitChange unit_change(const Json& scale);

}  // namespace axiscert
