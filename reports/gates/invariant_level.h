// Sentences about answers that change with an exact image of a query: from which size on, and which number of the
// kernel's own explains them.
#pragma once

#include <optional>
#include <string>

#include "fuzz/record/family_record.h"

namespace axiscert {

// A family's images of one kind; null where it makes none.
const ImageChangesRecord* changes_of(const FamilyRecord& family, ImageKind kind);
// Those of the kind `scale` where all are within the range of forms of degree 6; null where that is not so.
const ImageChangesRecord* units_of(const FamilyRecord& family);

// Says of counts by size, of powers of two: "from 2^-7 down", "from 2^3 up", "from 2^-7 down and from 2^3 up".
std::string powers_text(const CountsBySize& by_size);
// The least exponent of counts by size, which are not empty.
inline int least_size(const CountsBySize& by_size) { return by_size.begin()->first; }
// Says of images in other units of length: "where numbers are small, as if an absolute number near 0.01 (squared
// 0.0001) were compared with the distance d"; what it found of both directions. Where nothing common explains the
// answers, a sentence that says so.
std::string absolute_number_text(const UnitFaultsRecord& wrong);
// The failure of a family's images within the range of degree 6: how often and from which power on the verdict is
// wrong, or changes, and why.
struct UnitChange {
  std::uint64_t count = 0;
  std::string what;
  std::optional<AddressPair> first;
};
// The change of a family's images of the kind `scale`, with a range. `count` is 0 where no verdict changes.
UnitChange unit_change(const ImageChangesRecord& scale);

}  // namespace axiscert
