// A block of queries through the steps. No guard: included once for each of Highway's instruction sets, after the
// steps.
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

// Queries i to i + N of a block; binary32 widened where D is of doubles.
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

// The lanes of a vector that a mask names, to its front. Not hn::Compress for all: Highway 1.0 copies a table of 2 KiB
// to the stack for each vector of eight doubles.
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

// Queries of a block that a step passed on, packed.
template <class Real, std::size_t capacity = block_size>
struct Leftovers {
  static constexpr std::size_t padding = 16;  // whole vectors are read and written: 16 floats at most
  alignas(64) Real column[13][capacity + padding];
  std::uint16_t index[capacity];  // in the block
  std::size_t size = 0;
  bool has_spheres = false;  // each its own, even where the block has one

  // Queries at..at + 64 of `from`, those of `mask`: number(j) of the block is at + j.
  template <class D, class Number>
  AXISCERT_INLINE void add(D d, const Block<Real>& from, std::size_t at, std::uint64_t mask, Number&& number) {
    const Packing<D> packed(d, mask);
    for (std::size_t k = 0; k < (from.one_sphere ? 9u : 13u); ++k) {
      hn::StoreU(packed(d, hn::LoadU(d, from.column[k] + at)), d, column[k] + size);
    }
    for (; mask != 0; mask &= mask - 1) {
      index[size++] = static_cast<std::uint16_t>(number(static_cast<std::size_t>(std::countr_zero(mask))));
    }
  }
  // `count` queries of the block itself.
  AXISCERT_INLINE void add_all(const Block<Real>& from, std::size_t first, std::size_t count) {
    for (std::size_t k = 0; k < (from.one_sphere ? 9u : 13u); ++k) {
      std::memcpy(column[k] + size, from.column[k] + first, count * sizeof(Real));
    }
    for (std::size_t i = 0; i < count; ++i) index[size++] = static_cast<std::uint16_t>(first + i);
  }
  // A query of its own.
  AXISCERT_INLINE void add(const double (&q)[13], std::size_t i) {
    for (std::size_t k = 0; k < 13; ++k) column[k][size] = static_cast<Real>(q[k]);
    index[size++] = static_cast<std::uint16_t>(i);
    has_spheres = true;
  }
  // As a block, which asks of the one sphere of `from` where that does; zeros after its end.
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
AXISCERT_INLINE void widened(const Block<Real>& block, std::size_t i, double (&q)[13]) {
  for (std::size_t k = 0; k < 9; ++k) q[k] = static_cast<double>(block.column[k][i]);
  const std::size_t of_sphere = block.one_sphere ? 0 : i;
  for (std::size_t k = 9; k < 13; ++k) q[k] = static_cast<double>(block.column[k][of_sphere]);
}

constexpr int stored_exponent(std::uint64_t bits) { return static_cast<int>((bits >> 52) & 0x7ff); }

// Finite, r >= 0.
inline bool is_valid(const double (&q)[13]) {
  for (const double x : q) {
    if (stored_exponent(std::bit_cast<std::uint64_t>(x)) == 0x7ff) return false;
  }
  return q[12] >= 0;
}

// Scales by a power of two so that the greatest number is near 1. False where that loses a bit, or where it has been
// near 1 before.
inline bool scaled_to_range(const double (&q)[13], double (&scaled)[13]) {
  std::uint64_t greatest = 0;
  for (const double x : q) {
    const std::uint64_t magnitude = std::bit_cast<std::uint64_t>(x) << 1;
    if (magnitude > greatest) greatest = magnitude;
  }
  const int exponent = static_cast<int>(greatest >> 53) - 1023;
  if ((exponent >= -60 && exponent <= 60) || exponent < -1022 || exponent > 1022) return false;
  const double down = std::bit_cast<double>(static_cast<std::uint64_t>(1023 - exponent) << 52);
  const double up = std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
  bool exact = true;
  for (int k = 0; k < 13; ++k) {
    scaled[k] = q[k] * down;
    exact &= scaled[k] * up == q[k];
  }
  return exact;
}

inline void set_bit(std::uint64_t* words, std::size_t i) { words[i / 64] |= std::uint64_t{1} << (i % 64); }

// A copy of what is left after whole vectors, so that no lane reads outside the block.
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

// A block through the steps: D takes the queries, D2, of doubles, those that are left over.
template <class D, class D2>
class Steps {
 public:
  using Real = hn::TFromD<D>;

  Steps(const Block<Real>& block, Question question, BlockAnswer& answer) noexcept
      : block_(block), question_(question), answer_(answer) {}

  // The first step asks chunks of 64, a word of the answer. Where it passes most of the first on, the queries come from
  // where it is of no use, and the next step takes the other chunks as they are.
  HWY_NOINLINE void run() noexcept {
    Leftovers<Real> left;
    bool is_hard = false;
    for (std::size_t first = 0; first < block_.size; first += chunk_size) {
      const std::size_t size = block_.size - first < chunk_size ? block_.size - first : chunk_size;
      if (is_hard && size == chunk_size) {
        left.add_all(block_, first, size);
      } else {
        const std::size_t before = left.size;
        coarse(first, size, left);
        is_hard = left.size - before > chunk_size * 3 / 4;
      }
    }
    if (left.size != 0) settle(left);
  }

 private:
  static constexpr std::size_t chunk_size = 64, lanes = hn::MaxLanes(D()), fine_lanes = hn::MaxLanes(D2());
  static_assert(lanes <= Leftovers<Real>::padding && fine_lanes <= Leftovers<Real>::padding);

  AXISCERT_INLINE void coarse(std::size_t first, std::size_t size, Leftovers<Real>& left) noexcept {
    std::size_t i = 0;
    std::uint64_t contact = 0;
    for (; i + lanes <= size; i += lanes) contact |= coarse_vector(block_, first + i, lanes, first + i, left) << i;
    if (i < size) {
      const Tail<Real, lanes> tail(block_, first + i);
      contact |= coarse_vector(tail.block, 0, size - i, first + i, left) << i;
    }
    answer_.contact[first / 64] = contact;
  }

  // The contacts among `count` queries from `at`; the first is the i-th of the block.
  AXISCERT_INLINE static std::uint64_t coarse_vector(const Block<Real>& from, std::size_t at, std::size_t count,
                                                     std::size_t i, Leftovers<Real>& left) noexcept {
    const D d;
    const Decided<D> decided = coarse_step(d, load(d, from, at));
    const std::uint64_t contact = bits_of(d, decided.contact), separated = bits_of(d, decided.separated);
    const std::uint64_t pending = ~(contact | separated) & low_bits(count);
    if (pending != 0) left.add(d, from, at, pending, [i](std::size_t j) { return i + j; });
    return contact & low_bits(count);
  }

  // What the first step left. In doubles it is a step between for binary32: half as dear as the second.
  HWY_NOINLINE void settle(Leftovers<Real>& left) noexcept {
    if constexpr (sizeof(Real) == 4) {
      Leftovers<Real> less;
      const D2 d;
      const Block<Real> block = left.block(block_);
      for (std::size_t j = 0; j < left.size; j += fine_lanes) {
        const Decided<D2> decided = coarse_step(d, load(d, block, j));
        const std::uint64_t queries = low_bits(left.size - j < fine_lanes ? left.size - j : fine_lanes);
        const std::uint64_t contact = bits_of(d, decided.contact) & queries;
        const std::uint64_t pending = queries & ~(contact | bits_of(d, decided.separated));
        add_contacts(contact, left.index + j);
        if (pending != 0) {
          less.add(hn::Rebind<Real, D2>(), block, j, pending,
                   [index = left.index + j](std::size_t lane) { return std::size_t{index[lane]}; });
        }
      }
      if (less.size != 0) fine(less);
    } else {
      fine(left);
      if (again_.size != 0) fine_again();
    }
  }

  AXISCERT_INLINE void add_contacts(std::uint64_t lanes, const std::uint16_t* index) noexcept {
    for (; lanes != 0; lanes &= lanes - 1) set_bit(answer_.contact, index[std::countr_zero(lanes)]);
  }

  // The second step, and the last for those that it does not settle.
  template <class Left>
  HWY_NOINLINE void fine(Left& left) noexcept {
    const D2 d;
    const auto from = left.block(block_);
    for (std::size_t j = 0; j < left.size; j += fine_lanes) {
      const FineStep<D2> step(d, load(d, from, j), question_ == Question::open_sphere);
      const auto found = step.answer();
      const std::uint64_t queries = low_bits(left.size - j < fine_lanes ? left.size - j : fine_lanes);
      const std::uint64_t valid = bits_of(d, step.is_valid()) & queries;
      const std::uint64_t sound = sizeof(Real) == 8 ? bits_of(d, step.in_range()) & valid : valid;
      const std::uint64_t separated = bits_of(d, found.decided.separated) & sound;
      const std::uint64_t contact = bits_of(d, found.decided.contact) & sound;
      std::uint64_t rest = queries & ~(contact | separated);
      add_contacts(contact, left.index + j);
      if (rest == 0) continue;
      alignas(64) std::uint64_t known[fine_lanes];
      hn::Store(found.known, hn::RebindToUnsigned<D2>(), known);
      for (; rest != 0; rest &= rest - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
        double q[13];
        widened(from, j + lane, q);
        if (((sound >> lane) & 1u) != 0) last_step(q, left.index[j + lane], Known{known[lane]});
        else if (((valid >> lane) & 1u) != 0 || is_valid(q)) scaled_step(q, left.index[j + lane]);
        else set_bit(answer_.invalid, left.index[j + lane]);
      }
    }
  }

  // For a query that is the i-th of the block, or that one scaled.
  AXISCERT_INLINE void last_step(const double (&q)[13], std::size_t i, Known known) noexcept {
    if (!exactly_separated(q, question_, known)) set_bit(answer_.contact, i);
  }
  // The same of one that the second step could not look at. Scaled, it may.
  AXISCERT_INLINE void scaled_step(const double (&q)[13], std::size_t i) noexcept {
    if constexpr (sizeof(Real) == 8) {
      if (double scaled[13]; scaled_to_range(q, scaled)) {
        again_.add(scaled, i);
        if (again_.size == again_size) fine_again();
        return;
      }
    }
    last_step(q, i, {});
  }

  HWY_NOINLINE void fine_again() noexcept {
    fine(again_);
    again_.size = 0;
  }

  static constexpr std::size_t again_size = sizeof(Real) == 8 ? 32 : 1;  // binary32 needs none
  const Block<Real>& block_;
  const Question question_;
  BlockAnswer& answer_;
  Leftovers<Real, again_size> again_;  // scaled
};

// What the conservative test could not look at: no query, or differences that overflow. Those it asks again with all
// numbers times 2^-4: where a difference overflowed, what that rounds is nothing.
template <class D, class Real = hn::TFromD<D>>
HWY_NOINLINE void settle_conservatively(const Block<Real>& block, const std::uint64_t* pending, BlockAnswer& answer) {
  const D d;
  for (std::size_t i = 0; i < block.size; ++i) {
    if (!((pending[i / 64] >> (i % 64)) & 1u)) continue;
    double q[13];
    widened(block, i, q);
    if (!is_valid(q)) {
      set_bit(answer.invalid, i);
      continue;
    }
    Real column[13][hn::MaxLanes(D())] = {};
    Block<Real> one{{}, 1, false};
    for (std::size_t k = 0; k < 13; ++k) {
      column[k][0] = static_cast<Real>(q[k] * 0x1p-4);
      one.column[k] = column[k];
    }
    if (!(bits_of(d, Conservative<D>::answer_scaled(load<false>(d, one, 0)).separated) & 1u))
      set_bit(answer.contact, i);
  }
}

template <class D, class Real = hn::TFromD<D>>
HWY_NOINLINE void decide_conservatively(const Block<Real>& block, BlockAnswer& answer) {
  const D d;
  constexpr std::size_t lanes = hn::MaxLanes(D());
  std::uint64_t pending[block_size / 64] = {}, any = 0;
  const auto vector = [&](const Block<Real>& from, std::size_t at, std::size_t count, std::size_t i) HWY_ATTR {
    auto found = Conservative<D>::answer(load<false>(d, from, at));
    if (!hn::AllFalse(d, found.unknown)) {
      const auto scaled = Conservative<D>::answer_scaled(load<false>(d, from, at));
      found = {hn::Or(found.separated, hn::And(found.unknown, scaled.separated)),
               hn::And(found.unknown, scaled.unknown)};
    }
    const std::uint64_t unknown = bits_of(d, found.unknown) & low_bits(count);
    answer.contact[i / 64] |= (~(bits_of(d, found.separated) | unknown) & low_bits(count)) << (i % 64);
    pending[i / 64] |= unknown << (i % 64);
    any |= unknown;
  };
  std::size_t i = 0;
  for (; i + lanes <= block.size; i += lanes) vector(block, i, lanes, i);
  if (i < block.size) {
    const Tail<Real, lanes> tail(block, i);
    vector(tail.block, 0, block.size - i, i);
  }
  if (any != 0) settle_conservatively<D>(block, pending, answer);
}

// D takes the queries of the block, D2 those that are left over.
template <class D, class D2, class Real = hn::TFromD<D>>
void decide(const Block<Real>& block, Question question, BlockAnswer& answer) noexcept {
  answer = {};
  if (question == Question::conservative) decide_conservatively<D>(block, answer);
  else Steps<D, D2>(block, question, answer).run();
}

// One query; D4, if the instruction set has it, takes its vertices a lane each.
template <class D4, class D1, class D2, class Real = hn::TFromD<D1>>
void decide_pair(const Real* triangle, const Real* sphere, Question question, BlockAnswer& answer) noexcept {
  if constexpr (!std::is_void_v<D4>) {
    if (question != Question::conservative) {
      if (const PairStep<D4> step(triangle, sphere); step.separated() || step.contact()) {
        answer.contact[0] = step.contact();
        answer.invalid[0] = 0;
        return;
      }
    }
  }
  Block<Real> block{{}, 1, true};
  for (std::size_t k = 0; k < 9; ++k) block.column[k] = triangle + k;
  for (std::size_t k = 9; k < 13; ++k) block.column[k] = sphere + (k - 9);
  decide<D1, D2>(block, question, answer);
}

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
