// Takes a block of queries through the steps. No include guard: included once for each of Highway's instruction sets,
// after the steps. Each step answers what it is certain of:
//
// box     of one sphere: triangles beyond one face of its box, in whole vectors or chunks of a mesh; not for
//         AXISCERT_CONSERVATIVE
// coarse  SIMD in the input's precision, with one threshold for each degree; then in double for the rest. Silent on
//         margins within the threshold and extreme sizes
// fine    SIMD in double, each margin with a bound from its own differences. Silent within the bound, on extreme sizes
// deep    the open comparisons: pairs of doubles with the same bounds; values too small for these by their residue
//         modulo 2^64. Silent as before
// exact   one query at a time: integers of 1 to 27 words on the stack where the numbers span at most 286 bits (all of
//         binary32), in binary64 126; beyond 126 after balls (a midpoint and an error); else by digits to the base 2^56
#include <bit>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {

// Takes a block through the steps. D is the vector type for the queries of the block, D2, of doubles, for those that
// the first step leaves open.
template <class D, class D2>
class Steps {
 public:
  using Real = hn::TFromD<D>;

  Steps(const Block<Real>& block, Question question, BlockAnswer& answer) noexcept
      : block_(block), question_(question), answer_(answer) {}

  // The first step takes chunks of 64 queries, a word of the answer each. If it leaves more than three quarters of a
  // chunk open, such queries are likely to follow, and further whole chunks of the block go to the next step directly.
  HWY_NOINLINE void run() noexcept {
    Leftovers<Real> left;
    bool is_hard = false;
    for (std::size_t first = 0; first < block_.size; first += chunk_size) {
      const std::size_t size = block_.size - first < chunk_size ? block_.size - first : chunk_size;
      if (is_hard && size == chunk_size) {
        left.add_all(block_, first, size);
      } else {
        const std::size_t before = left.size;
        take_coarse_step(first, size, left);
        is_hard = left.size - before > chunk_size * 3 / 4;
      }
    }
    if (left.size != 0) settle(left);
  }

 private:
  static constexpr std::size_t chunk_size = 64, lanes = hn::MaxLanes(D()), fine_lanes = hn::MaxLanes(D2());
  static_assert(lanes <= Leftovers<Real>::padding && fine_lanes <= Leftovers<Real>::padding);

  AXISCERT_INLINE void take_coarse_step(std::size_t first, std::size_t size, Leftovers<Real>& left) noexcept {
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

  static constexpr std::size_t prefetched_bytes = 2048;  // ahead, mostly within the same page
  // Number of queries at the beginning of the chunk that are in vectors wholly beyond the sphere's box.
  AXISCERT_INLINE std::size_t skipped_by_box(std::size_t first, std::size_t size) const noexcept {
    const D d;
    const BoxStep<D> box(
        SphereBox<Real>(block_.column[9][0], block_.column[10][0], block_.column[11][0], block_.column[12][0]));
    std::size_t i = 0;
    while (i + lanes <= size && box.all_beyond(load(d, block_, first + i))) {
      // The loop waits for memory, and nine columns are more streams than processors prefetch by themselves.
      for (std::size_t k = 0; k < 9; ++k) {
        const auto at = reinterpret_cast<std::uintptr_t>(block_.column[k] + first + i);
        hwy::Prefetch(reinterpret_cast<const char*>(at + prefetched_bytes));
      }
      i += lanes;
    }
    return i;
  }

  // The contacts, as bits, among `count` queries of `from` beginning at `at`; the first of them is query i of the
  // block.
  AXISCERT_INLINE static std::uint64_t coarse_vector(const Block<Real>& from, std::size_t at, std::size_t count,
                                                     std::size_t i, Leftovers<Real>& left) noexcept {
    const D d;
    const DecidedLanes<D> decided = coarse_step(d, load(d, from, at));
    const std::uint64_t contact = bits_of(d, decided.contact), separated = bits_of(d, decided.separated);
    const std::uint64_t pending = ~(contact | separated) & low_bits(count);
    if (pending != 0) left.add(d, from, at, pending, [i](std::size_t j) { return i + j; });
    return contact & low_bits(count);
  }

  // Takes the queries that the first step left open through the same step in doubles, which also tells which
  // comparisons are open. A query with one open comparison goes to the deep step. For a query with more, the fine step,
  // which costs twice as much, may settle more; these queries are packed again in place.
  HWY_NOINLINE void settle(Leftovers<Real>& left) noexcept {
    const D2 d;
    const Block<Real> block = left.block(block_);
    OpenComparisons<D2, Leftovers<Real>> open(left, block, open_sphere());
    bool is_worth_it = true;  // whether enough queries of the last vector had only one open comparison
    left.size = 0;
    for (std::size_t j = 0; j < block.size; j += fine_lanes) {
      const CoarseMargins<D2, true> margins = coarse_margins(load(d, block, j));
      const CoarseLimits<D2, true> limits(margins.S, margins.E);
      const DecidedLanes<D2> decided = coarse_step(margins, limits);
      const std::uint64_t queries = low_bits(block.size - j < fine_lanes ? block.size - j : fine_lanes);
      const std::uint64_t contact = bits_of(d, decided.contact) & queries;
      const std::uint64_t pending = queries & ~(contact | bits_of(d, decided.separated));
      add_contacts(contact, left.index + j);
      if (pending == 0) continue;
      std::uint64_t few = 0;
      if (is_worth_it) {
        const auto known = coarsely_known(d, margins, limits);
        few = pending & bits_of(d, hn::And(has_one_open(d, known), limits.in_deep_range(margins.S, margins.r)));
        open.add(j, few, known);
        is_worth_it = 2 * std::popcount(few) >= std::popcount(pending);
      }
      if (const std::uint64_t many = pending & ~few; many != 0) {
        left.add(hn::Rebind<Real, D2>(), block, j, many,
                 [index = left.index + j](std::size_t lane) { return std::size_t{index[lane]}; });
      }
    }
    conclude(open, [&](std::size_t, std::size_t i, double(&q)[13]) HWY_ATTR { widen(block_, i, q); });
    if (left.size != 0) take_fine_step(left);
    if (again_.size != 0) repeat_fine_step();
  }

  bool open_sphere() const noexcept { return question_ == Question::open_sphere; }
  AXISCERT_INLINE void add_contacts(std::uint64_t lanes, const std::uint16_t* index) noexcept {
    for (; lanes != 0; lanes &= lanes - 1) set_bit(answer_.contact, index[first_bit(lanes)]);
  }

  // The fine step, then the deep and the last step for the comparisons that it leaves open.
  template <class Left>
  HWY_NOINLINE void take_fine_step(Left& left) noexcept {
    const D2 d;
    const auto block = left.block(block_);
    OpenComparisons<D2, Left> open(left, block, open_sphere());
    for (std::size_t j = 0; j < left.size; j += fine_lanes) {
      const FineStep<D2> step(d, load(d, block, j), open_sphere());
      const auto found = step.answer();
      const std::uint64_t queries = low_bits(left.size - j < fine_lanes ? left.size - j : fine_lanes);
      const std::uint64_t valid = bits_of(d, step.is_valid()) & queries;
      const std::uint64_t sound = sizeof(Real) == 8 ? bits_of(d, step.is_sound()) & valid : valid;
      const std::uint64_t separated = bits_of(d, found.decided.separated) & sound;
      const std::uint64_t contact = bits_of(d, found.decided.contact) & sound;
      add_contacts(contact, left.index + j);
      const std::uint64_t pending = sound & ~(contact | separated);
      const std::uint64_t quick = pending & ~bits_of(d, has_one_open(d, found.known)) & have_few_bits(block, j);
      open.add_unasked(j, quick, found.known);
      open.add(j, pending & ~quick, found.known);  // after add_unasked, which would overwrite answers that this call
                                                   // adds
      if (const std::uint64_t rest = queries & ~sound; rest != 0)
        settle_out_of_range(block, j, rest, valid, left.index);
    }
    conclude(open, [&](std::size_t place, std::size_t, double(&q)[13]) HWY_ATTR { widen(block, place, q); });
  }

  // Queries at j..j + lanes whose numbers have so few bits that the last step is as quick as the deep step for two
  // comparisons. Those of binary32 have, and with one lane every query counts.
  template <class Number>
  AXISCERT_INLINE static std::uint64_t have_few_bits(const Block<Number>& block, std::size_t j) noexcept {
    if constexpr (sizeof(Number) == 4 || fine_lanes == 1) return ~std::uint64_t{0};
    else {
      const D2 d;
      const hn::RebindToUnsigned<D2> words;
      auto any = hn::Zero(words);
      for (std::size_t k = 0; k < (block.one_sphere ? 9u : 13u); ++k) {
        any = hn::Or(any, hn::BitCast(words, hn::LoadU(d, block.column[k] + j)));
      }
      const auto last_bits = hn::And(any, hn::Set(words, (std::uint64_t{1} << 28) - 1));
      return bits_of(d, hn::RebindMask(d, hn::Eq(last_bits, hn::Zero(words))));
    }
  }

  // Runs the deep step, and the last step for the queries that it does not settle. read(place, index, q) writes a query
  // to q.
  template <class Open, class Read>
  AXISCERT_INLINE void conclude(Open& open, Read&& read) noexcept {
    open.finish([&](std::size_t place, std::size_t i, KnownResults known) HWY_ATTR {
      // Both cases are about equally likely, so there is no branch on the contact.
      answer_.contact[i / 64] |= std::uint64_t{known.is_contact()} << (i % 64);
      if (int{known.is_separated()} | int{known.is_contact()}) return;
      double q[13];
      read(place, i, q);
      take_last_step(q, i, known);
    });
  }

  // Handles the queries of `lanes` of a vector, which are outside the fine step's range: an invalid one is marked, and
  // a valid one scaled for another pass of that step; the last step decides those that cannot be scaled.
  template <class Number>
  HWY_NOINLINE void settle_out_of_range(const Block<Number>& from, std::size_t first, std::uint64_t lanes,
                                        std::uint64_t valid, const std::uint16_t* index) noexcept {
    double scaled[13][fine_lanes];
    std::uint64_t useful = 0;
    if constexpr (sizeof(Real) == 8) {
      const D2 d;
      const ScaledToRange<D2> found(d, load(d, from, first));
      useful = bits_of(d, found.useful);
      for (std::size_t k = 0; k < 13; ++k) hn::StoreU(found.number[k], d, scaled[k]);
    }
    for (; lanes != 0; lanes &= lanes - 1) {
      const std::size_t lane = first_bit(lanes), i = index[first + lane];
      double q[13];
      widen(from, first + lane, q);
      if (!has_bit(valid, lane) && !is_valid(q)) {
        set_bit(answer_.invalid, i);
      } else if (has_bit(useful, lane)) {
        for (std::size_t k = 0; k < 13; ++k) q[k] = scaled[k][lane];
        again_.add(q, i);
        if (again_.size == again_size) repeat_fine_step();
      } else {
        take_last_step(q, i, {});
      }
    }
  }

  // The last step for query i of the block; q is that query, perhaps scaled.
  AXISCERT_INLINE void take_last_step(const double (&q)[13], std::size_t i, KnownResults known) noexcept {
    if (!exactly_separated(q, question_, known, widest_integers<Real>)) set_bit(answer_.contact, i);
  }

  HWY_NOINLINE void repeat_fine_step() noexcept {
    take_fine_step(again_);
    again_.size = 0;
  }

  static constexpr std::size_t again_size = sizeof(Real) == 8 ? 32 : 1;  // not used for binary32
  const Block<Real>& block_;
  const Question question_;
  BlockAnswer& answer_;
  Leftovers<Real, again_size> again_;  // scaled queries
};

// D is the vector type for the queries of the block, D2 for those that the first step leaves open.
template <class D, class D2, class Real = hn::TFromD<D>>
void decide(const Block<Real>& block, Question question, BlockAnswer& answer) noexcept {
  answer = {};
  if (question == Question::conservative) decide_conservatively<D>(block, answer);
  else Steps<D, D2>(block, question, answer).run();
}

// Decides one query. D4, unless it is void, has a lane for each of its vertices.
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
