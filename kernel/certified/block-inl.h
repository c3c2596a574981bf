// A block of queries through the steps. No guard: included once for each of Highway's instruction sets, after the
// steps.
#include <bit>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {

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

// A block through the steps: D takes the queries, D2, of doubles, those that are left over.
template <class D, class D2>
class Steps {
 public:
  using Real = hn::TFromD<D>;

  Steps(const Block<Real>& block, Question question, BlockAnswer& answer) noexcept
      : block_(block), question_(question), answer_(answer) {}

  // The first step asks chunks of 64, a word of the answer. Where it passes most of one on, the queries come from
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
    if (block_.one_sphere) i = skipped_by_box(first, size);
    for (; i + lanes <= size; i += lanes) contact |= coarse_vector(block_, first + i, lanes, first + i, left) << i;
    if (i < size) {
      const Tail<Real, lanes> tail(block_, first + i);
      contact |= coarse_vector(tail.block, 0, size - i, first + i, left) << i;
    }
    answer_.contact[first / 64] = contact;
  }

  static constexpr std::size_t prefetched_bytes = 2048;  // ahead, within a page mostly
  // How many of the chunk's queries, from its first, are vectors wholly beyond the sphere's box.
  AXISCERT_INLINE std::size_t skipped_by_box(std::size_t first, std::size_t size) const noexcept {
    const D d;
    const BoxStep<D> box(block_.column[9][0], block_.column[10][0], block_.column[11][0], block_.column[12][0]);
    std::size_t i = 0;
    while (i + lanes <= size && box.all_beyond(load(d, block_, first + i))) {
      // It waits for memory; nine columns are more than processors foresee.
      for (std::size_t k = 0; k < 9; ++k) {
        const auto at = reinterpret_cast<std::uintptr_t>(block_.column[k] + first + i);
        hwy::Prefetch(reinterpret_cast<const char*>(at + prefetched_bytes));
      }
      i += lanes;
    }
    return i;
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
