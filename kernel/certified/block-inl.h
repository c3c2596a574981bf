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

template <bool fused = true, class D, class Real = hn::TFromD<D>>
AXISCERT_INLINE Problem<Lanes<D, fused>> load(D d, const Block<Real>& block, std::size_t i) {
  using T = Lanes<D, fused>;
  const auto lanes = [&](std::size_t k) HWY_ATTR { return T{hn::LoadU(d, block.column[k] + i)}; };
  const auto sphere = [&](std::size_t k)
                          HWY_ATTR { return block.one_sphere ? T{hn::Set(d, block.column[k][0])} : lanes(k); };
  return {{lanes(0), lanes(1), lanes(2)},
          {lanes(3), lanes(4), lanes(5)},
          {lanes(6), lanes(7), lanes(8)},
          {sphere(9), sphere(10), sphere(11)},
          sphere(12),
          T{hn::Zero(d)}};
}

// The queries that the first step passed on, widened and scaled, for the second.
struct Leftovers {
  static constexpr std::size_t padding = 8;  // of the widest vector of doubles
  alignas(64) double column[13][block_size + padding];
  std::uint16_t index[block_size];
  std::size_t size = 0;
};

template <class Real>
AXISCERT_INLINE void widened(const Block<Real>& block, std::size_t i, double (&q)[13]) {
  for (std::size_t k = 0; k < 9; ++k) q[k] = block.column[k][i];
  const std::size_t of_sphere = block.one_sphere ? 0 : i;
  for (std::size_t k = 9; k < 13; ++k) q[k] = block.column[k][of_sphere];
}

constexpr int stored_exponent(std::uint64_t bits) { return static_cast<int>((bits >> 52) & 0x7ff); }

// Finite, r >= 0.
inline bool is_valid(const double (&q)[13]) {
  for (const double x : q) {
    if (stored_exponent(std::bit_cast<std::uint64_t>(x)) == 0x7ff) return false;
  }
  return q[12] >= 0;
}

// Scales by a power of two so that the greatest number is near 1, where that loses no bit. Otherwise it leaves the
// query as it is, for the last step.
inline bool scaled_to_range(const double (&q)[13], double (&scaled)[13]) {
  std::uint64_t greatest = 0;
  for (const double x : q) {
    const std::uint64_t magnitude = std::bit_cast<std::uint64_t>(x) << 1;
    if (magnitude > greatest) greatest = magnitude;
  }
  const int exponent = static_cast<int>(greatest >> 53) - 1023;
  if (exponent >= -60 && exponent <= 60) {
    for (int k = 0; k < 13; ++k) scaled[k] = q[k];
    return true;
  }
  if (exponent < -1022 || exponent > 1022) return false;
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

template <class Real>
void decide_exactly(const Block<Real>& block, std::size_t i, Question question, BlockAnswer& answer) {
  double q[13];
  widened(block, i, q);
  if (!exactly_separated(q, question)) set_bit(answer.contact, i);
}

// The second step and the last, for the queries of `pending`.
template <class D2, class Real>
HWY_NOINLINE void settle(const Block<Real>& block, const std::uint64_t* pending, Question question,
                         BlockAnswer& answer) {
  Leftovers left;
  for (std::size_t w = 0; w * 64 < block.size; ++w) {
    for (std::uint64_t rest = pending[w]; rest != 0; rest &= rest - 1) {
      const std::size_t i = w * 64 + static_cast<std::size_t>(std::countr_zero(rest));
      double q[13], scaled[13];
      widened(block, i, q);
      if (!is_valid(q)) {
        set_bit(answer.invalid, i);
        continue;
      }
      if constexpr (sizeof(Real) == 8) {
        if (!scaled_to_range(q, scaled)) {
          decide_exactly(block, i, question, answer);
          continue;
        }
      }
      const double(&taken)[13] = sizeof(Real) == 8 ? scaled : q;
      for (std::size_t k = 0; k < 13; ++k) left.column[k][left.size] = taken[k];
      left.index[left.size++] = static_cast<std::uint16_t>(i);
    }
  }
  const D2 d;
  constexpr std::size_t lanes = hn::MaxLanes(D2());
  static_assert(lanes <= Leftovers::padding);
  for (std::size_t k = 0; k < 13; ++k) {
    for (std::size_t j = left.size; j < left.size + lanes; ++j) left.column[k][j] = 0;
  }
  Block<double> fine{{}, left.size, false};
  for (std::size_t k = 0; k < 13; ++k) fine.column[k] = left.column[k];
  for (std::size_t j = 0; j < left.size; j += lanes) {
    const FineStep<D2> step(d, load(d, fine, j), question == Question::open_sphere);
    Decided<D2> decided = step.decide();
    if constexpr (sizeof(Real) == 8) {
      const auto in_range = step.in_range();
      decided = {hn::And(decided.separated, in_range), hn::And(decided.contact, in_range)};
    }
    const std::uint64_t contact = bits_of(d, decided.contact), separated = bits_of(d, decided.separated);
    for (std::size_t k = 0; k < lanes && j + k < left.size; ++k) {
      const std::size_t i = left.index[j + k];
      if ((contact >> k) & 1u) set_bit(answer.contact, i);
      else if (!((separated >> k) & 1u)) decide_exactly(block, i, question, answer);
    }
  }
}

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
    if (!(bits_of(d, Conservative<D>::answer(d, load<false>(d, one, 0)).separated) & 1u)) set_bit(answer.contact, i);
  }
}

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

// D takes the queries of the block, D2 those that are left over.
template <class D, class D2, class Real = hn::TFromD<D>>
void decide(const Block<Real>& block, Question question, BlockAnswer& answer) noexcept {
  const D d;
  constexpr std::size_t lanes = hn::MaxLanes(D());
  answer = {};
  std::uint64_t pending[block_size / 64] = {};
  const auto certified = [&](const Block<Real>& from, std::size_t at, std::size_t i) HWY_ATTR {
    const Decided<D> decided = coarse_step(d, load(d, from, at));
    const std::uint64_t contact = bits_of(d, decided.contact), separated = bits_of(d, decided.separated);
    answer.contact[i / 64] |= contact << (i % 64);
    pending[i / 64] |= ((contact | separated) ^ low_bits(lanes)) << (i % 64);
  };
  const auto conservative = [&](const Block<Real>& from, std::size_t at, std::size_t i) HWY_ATTR {
    const auto found = Conservative<D>::answer(d, load<false>(d, from, at));
    const std::uint64_t unknown = bits_of(d, found.unknown), separated = bits_of(d, found.separated);
    answer.contact[i / 64] |= ((separated | unknown) ^ low_bits(lanes)) << (i % 64);
    pending[i / 64] |= unknown << (i % 64);
  };
  const auto each_vector = [&](auto&& vector) HWY_ATTR {
    std::size_t i = 0;
    for (; i + lanes <= block.size; i += lanes) vector(block, i, i);
    if (i == block.size) return;
    const Tail<Real, lanes> tail(block, i);
    vector(tail.block, 0, i);
    const std::uint64_t queries = low_bits(block.size % 64 == 0 ? 64 : block.size % 64);
    pending[i / 64] &= queries;
    answer.contact[i / 64] &= queries;
  };
  const bool is_conservative = question == Question::conservative;
  if (is_conservative) each_vector(conservative);
  else each_vector(certified);
  std::uint64_t any = 0;
  for (const std::uint64_t word : pending) any |= word;
  if (any == 0) return;
  if (is_conservative) settle_conservatively<D>(block, pending, answer);
  else settle<D2>(block, pending, question, answer);
}

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
