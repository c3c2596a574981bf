// The families that exist: one line each, in the order of the reports.
#include "fuzz/queries/family.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "kernel/base/error.h"

#define AXISCERT_FAMILIES(X) \
  X(general)                 \
  X(tangent)                 \
  X(seam)                    \
  X(sliver)                  \
  X(needle)                  \
  X(collinear)               \
  X(repeated)                \
  X(tie)                     \
  X(speck)                   \
  X(lattice)                 \
  X(far)                     \
  X(scale)                   \
  X(ratio)                   \
  X(on)                      \
  X(grid)                    \
  X(bits)                    \
  X(subnormal)               \
  X(nonfinite)               \
  X(orders)                  \
  X(axes)                    \
  X(inverted)                \
  X(scaled)                  \
  X(translated)

namespace axiscert {

#define AXISCERT_DECLARE(name) extern const Family name##_family;
AXISCERT_FAMILIES(AXISCERT_DECLARE)

std::span<const Family* const> families() {
#define AXISCERT_POINT(name) &name##_family,
  static const Family* const all[] = {AXISCERT_FAMILIES(AXISCERT_POINT)};
  return all;
}

std::vector<const Family*> families_of(const TestDescription& test) {
  std::vector<const Family*> all;
  for (const Family* family : families()) {
    if (&family->test() == &test) all.push_back(family);
  }
  return all;
}

const Family& find_family(std::string_view name) {
  std::vector<std::string_view> known;
  for (const Family* family : families()) {
    if (family->name == name) return *family;
    known.push_back(family->name);
  }
  throw Error(fmt::format("unknown family '{}'; families: {}", name, fmt::join(known, ", ")));
}

}  // namespace axiscert
