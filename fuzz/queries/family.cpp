// The families that exist: one line each, in the order of the reports.
#include "fuzz/queries/family.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "fuzz/queries/random.h"
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

template <class Real>
void Maker<Real>::fill(const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out) const {
  if (batch_) return batch_(name, first, out);
  for (std::size_t i = 0; i < out.size; ++i) {
    Stream random(name, first + i);
    out.set(i, one_(random, first + i));
  }
}
template class Maker<float>;
template class Maker<double>;

std::span<const Family* const> families() {
#define AXISCERT_POINT(name) &name##_family,
  static const Family* const all[] = {AXISCERT_FAMILIES(AXISCERT_POINT)};
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
