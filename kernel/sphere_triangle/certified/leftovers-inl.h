// Blocks as vectors, and the queries of a block that a step passed on, packed. No include guard: included once for each
// of Highway's instruction sets, after coarse_step-inl.h.
#include <bit>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {

template <class D>
AXISCERT_INLINE std::uint64_t bits_of(D d, hn::Mask<D> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  std::uint64_t bits;
  std::memcpy(&bits, bytes, sizeof bits);
  return bits;
}
constexpr std::uint64_t low_bits(std::size_t count) {
  return count >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
}

// Queries i to i + N of a block; binary32 is widened if D is of doubles.
template <bool fused = true, class D, class Real>
AXISCERT_INLINE Problem<Lanes<D, fused>> load(D d, const Block<Real>& block, std::size_t i) {
  using T = Lanes<D, fused>;
  const auto lanes = [&](std::size_t k) HWY_ATTR {
    const Real* from = block.column[k] + i;
    if constexpr (sizeof(Real) == sizeof(hn::TFromD<D>)) return T{hn::LoadU(d, from)};
    else return T{hn::PromoteTo(d, hn::LoadU(hn::Rebind<Real, D>(), from))};
  };
  const auto sphere = [&](std::size_t k) HWY_ATTR {
    return block.one_sphere ? T{hn::Set(d, static_cast<hn::TFromD<D>>(block.column[k][0]))} : lanes(k);
  };
  return {{lanes(0), lanes(1), lanes(2)},
          {lanes(3), lanes(4), lanes(5)},
          {lanes(6), lanes(7), lanes(8)},
          {sphere(9), sphere(10), sphere(11)},
          sphere(12),
          T{hn::Zero(d)}};
}

// Moves the lanes of a vector that a mask selects to its front. hn::Compress is not used for all vectors, because
// Highway 1.0 copies a table of 2 KiB to the stack for each vector of eight doubles.
template <class D>
struct Packing {
  static constexpr bool is_native = hn::MaxLanes(D()) > 8;
  using Indices = hn::RebindToUnsigned<D>;
  hn::Mask<D> mask;
  hn::Vec<Indices> from;

  AXISCERT_INLINE Packing(D d, std::uint64_t bits)
      : mask(hn::LoadMaskBits(d, reinterpret_cast<const std::uint8_t*>(&bits))), from(hn::Zero(Indices())) {
    if constexpr (!is_native) {
      const hn::Rebind<std::uint32_t, D> words;
      const auto places = hn::PromoteTo(words, hn::LoadU(hn::Rebind<std::uint8_t, D>(), set_bits_first[bits].place));
      if constexpr (sizeof(hn::TFromD<D>) == 8) from = hn::PromoteTo(Indices(), places);
      else from = places;
    }
  }
  AXISCERT_INLINE hn::Vec<D> operator()(D d, hn::Vec<D> v) const {
    if constexpr (is_native) return hn::Compress(v, mask);
    else return hn::TableLookupLanes(v, hn::IndicesFromVec(d, from));
  }
};

// The queries of a block that a step passed on, packed.
template <class Real, std::size_t capacity = block_size>
struct Leftovers {
  using Number = Real;
  static constexpr std::size_t padding = 16;  // whole vectors are read and written: at most 16 floats
  alignas(64) Real column[13][capacity + padding];
  std::uint16_t index[capacity];  // position in the block
  std::size_t size = 0;
  bool has_spheres = false;  // each query has its own sphere, even if the block has only one

  // Adds the queries selected by `mask` among at..at + 64 of `from`; number(j) is the position in the block of query at
  // + j.
  template <class D, class Number>
  AXISCERT_INLINE void add(D d, const Block<Real>& from, std::size_t at, std::uint64_t mask, Number&& number) {
    const Packing<D> packed(d, mask);
    for (std::size_t k = 0; k < (from.one_sphere ? 9u : 13u); ++k) {
      hn::StoreU(packed(d, hn::LoadU(d, from.column[k] + at)), d, column[k] + size);
    }
    for (; mask != 0; mask &= mask - 1) {
      index[size++] = static_cast<std::uint16_t>(number(first_bit(mask)));
    }
  }
  // Adds `count` queries of the block itself, from `first` on.
  AXISCERT_INLINE void add_all(const Block<Real>& from, std::size_t first, std::size_t count) {
    for (std::size_t k = 0; k < (from.one_sphere ? 9u : 13u); ++k) {
      std::memcpy(column[k] + size, from.column[k] + first, count * sizeof(Real));
    }
    for (std::size_t i = 0; i < count; ++i) index[size++] = static_cast<std::uint16_t>(first + i);
  }
  // Adds a query with its own sphere.
  AXISCERT_INLINE void add(const double (&q)[13], std::size_t i) {
    for (std::size_t k = 0; k < 13; ++k) column[k][size] = static_cast<Real>(q[k]);
    index[size++] = static_cast<std::uint16_t>(i);
    has_spheres = true;
  }
  // The queries as a block followed by zeros; it has the one sphere of `from`, if that has one and no query here has
  // its own.
  AXISCERT_INLINE Block<Real> block(const Block<Real>& from) {
    const bool one_sphere = from.one_sphere && !has_spheres;
    Block<Real> made{{}, size, one_sphere};
    for (std::size_t k = 0; k < 13; ++k) {
      const bool is_one = one_sphere && k >= 9;
      made.column[k] = is_one ? from.column[k] : column[k];
      if (!is_one) std::memset(column[k] + size, 0, padding * sizeof(Real));
    }
    return made;
  }
};

template <class Real>
AXISCERT_INLINE void widen(const Block<Real>& block, std::size_t i, double (&q)[13]) {
  for (std::size_t k = 0; k < 9; ++k) q[k] = static_cast<double>(block.column[k][i]);
  const std::size_t of_sphere = block.one_sphere ? 0 : i;
  for (std::size_t k = 9; k < 13; ++k) q[k] = static_cast<double>(block.column[k][of_sphere]);
}

constexpr int stored_exponent(std::uint64_t bits) { return static_cast<int>((bits >> 52) & 0x7ff); }

// Finite numbers and r >= 0.
inline bool is_valid(const double (&q)[13]) {
  for (const double x : q) {
    if (stored_exponent(std::bit_cast<std::uint64_t>(x)) == 0x7ff) return false;
  }
  return q[12] >= 0;
}

inline void set_bit(std::uint64_t* words, std::size_t i) { words[i / 64] |= std::uint64_t{1} << (i % 64); }

// A padded copy of the queries after the last whole vector, so that no lane reads outside the block.
template <class Real, std::size_t lanes>
struct Tail {
  Real storage[13][lanes] = {};
  Block<Real> block;

  Tail(const Block<Real>& from, std::size_t begin) : block{{}, from.size - begin, from.one_sphere} {
    for (std::size_t k = 0; k < 13; ++k) {
      const bool is_one = from.one_sphere && k >= 9;
      block.column[k] = is_one ? from.column[k] : storage[k];
      if (!is_one) std::memcpy(storage[k], from.column[k] + begin, block.size * sizeof(Real));
    }
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
