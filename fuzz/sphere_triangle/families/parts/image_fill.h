// Groups of images, for the families that make them one query at a time.
#pragma once

#include <cstdint>

#include "fuzz/queries/random.h"
#include "kernel/query.h"

namespace axiscert {

// Fills the queries from position `first` on of groups of `size`: make(random, base) makes a base from its stream, and
// image(random, query, base, i) is its image number i, the base itself for 0. An image draws after its base, from the
// base's stream.
template <class Real, class Make, class Image>
void fill_groups(const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out, std::uint64_t size,
                 const Make& make, const Image& image) {
  for (std::size_t i = 0; i < out.size;) {
    const std::uint64_t base = (first + i) / size;
    Stream random(name, base);
    const auto q = make(random, base);
    for (; i < out.size && (first + i) / size == base; ++i) {
      Stream after = random;
      out.set(i, image(after, q, base, static_cast<std::size_t>((first + i) % size)));
    }
  }
}

}  // namespace axiscert
