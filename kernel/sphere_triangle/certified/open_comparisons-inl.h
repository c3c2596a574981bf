// Takes the comparisons that a step in doubles left open through the deep step, those of one kind together. No include
// guard: included once for each of Highway's instruction sets, after deep_step-inl.h and leftovers-inl.h.
#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {

// Lanes in which at most one comparison is still open; `known` has the bits of Known.
template <class D>
AXISCERT_INLINE hn::Mask<D> has_one_open(D d, hn::Vec<hn::RebindToUnsigned<D>> known) {
  const hn::RebindToUnsigned<D> words;
  const auto fails = hn::And(known, hn::Set(words, 0b1111111 << KnownResults::fails));
  const auto closed =
      hn::Or(known, hn::Or(hn::ShiftLeft<KnownResults::radius>(fails), hn::ShiftLeft<KnownResults::sides>(fails)));
  const auto open = hn::AndNot(closed, hn::Set(words, KnownResults::comparisons));
  return hn::RebindMask(d, hn::Eq(hn::And(open, hn::Sub(open, hn::Set(words, 1))), hn::Zero(words)));
}

// The open comparisons of queries of `Left`, named by their places there; the numbers of a query are read when it is
// added.
template <class D, class Left>
class OpenComparisons {
 public:
  using Number = typename Left::Number;

  // `block` has the same queries as `left`.
  OpenComparisons(const Left& left, const Block<Number>& block, bool open_sphere) noexcept
      : left_(left), open_(open_sphere), sphere_stride_(block.one_sphere ? 0 : 1) {
    std::copy(block.column + 9, block.column + 13, sphere_);
  }

  // Adds the queries selected by `mask` among first..first + lanes, with the bits known about them, and asks their open
  // comparisons.
  AXISCERT_INLINE void add(std::size_t first, std::uint64_t mask, hn::Vec<hn::RebindToUnsigned<D>> known) noexcept {
    for_each_place(first, mask, known, [&](std::size_t place) HWY_ATTR {
      list(place);
      ask_all(place);
    });
  }

  // Adds queries whose open comparisons the deep step is not asked.
  AXISCERT_INLINE void add_unasked(std::size_t first, std::uint64_t mask,
                                   hn::Vec<hn::RebindToUnsigned<D>> known) noexcept {
    for_each_place(first, mask, known, [&](std::size_t place) HWY_ATTR { list(place); });
  }

  // Calls take(place, index, known) for each query, with everything known now; the index is the one it had when it was
  // added.
  template <class Take>
  void finish(Take&& take) noexcept {
    for (std::size_t kind = 0; kind < comparing_count; ++kind) {
      if (queue_[kind].size >= worth_asking) flush(static_cast<DeepComparison>(kind));
    }
    for (std::size_t i = 0; i < size_; ++i)
      take(std::size_t{place_[i]}, std::size_t{index_[i]}, KnownResults{known_[place_[i]]});
  }

 private:
  static constexpr std::size_t lanes = hn::MaxLanes(D()), capacity = 2 * lanes;
  // A queue with fewer comparisons at the end is left to the last step, which takes about a fifth as long for a query
  // as the deep step for a vector.
  static constexpr std::size_t worth_asking = lanes == 1 ? 1 : lanes / 2 + 1;
  static constexpr DeepComparison radius_of_[KnownResults::axes] = {
      DeepComparison::vertex_radius, DeepComparison::vertex_radius, DeepComparison::vertex_radius,
      DeepComparison::plane_radius,  DeepComparison::edge_radius,   DeepComparison::edge_radius,
      DeepComparison::edge_radius};
  static constexpr DeepComparison sides_of_[KnownResults::axes] = {
      DeepComparison::vertex_sides, DeepComparison::vertex_sides, DeepComparison::vertex_sides, {},
      DeepComparison::edge_side,    DeepComparison::edge_side,    DeepComparison::edge_side};
  // The first columns of the vertices that are renamed A, B and C.
  struct Turn {
    std::uint8_t a, b, c;
  };
  static constexpr Turn turn_of_[KnownResults::axes] = {{0, 3, 6}, {3, 6, 0}, {6, 0, 3}, {0, 3, 6},
                                                        {0, 3, 6}, {3, 6, 0}, {6, 0, 3}};

  struct Queue {
    alignas(64) Number column[13][capacity];
    std::uint16_t place[capacity];
    std::uint8_t axis[capacity];
    std::size_t size = 0;
  };

  template <class Visit>
  AXISCERT_INLINE void for_each_place(std::size_t first, std::uint64_t mask, hn::Vec<hn::RebindToUnsigned<D>> known,
                                      Visit&& visit) noexcept {
    if (mask == 0) return;
    hn::StoreU(known, hn::RebindToUnsigned<D>(), known_ + first);
    for (; mask != 0; mask &= mask - 1) visit(first + first_bit(mask));
  }
  AXISCERT_INLINE void list(std::size_t place) noexcept {
    place_[size_] = static_cast<std::uint16_t>(place);
    index_[size_++] = left_.index[place];
  }
  AXISCERT_INLINE void ask_all(std::size_t place) noexcept {
    const KnownResults known{known_[place]};
    for (std::uint32_t rest = known.open_radii(); rest != 0; rest &= rest - 1) {
      ask(radius_of_[std::countr_zero(rest)], std::countr_zero(rest), place);
    }
    for (std::uint32_t rest = known.open_sides(); rest != 0; rest &= rest - 1) {
      ask(sides_of_[std::countr_zero(rest)], std::countr_zero(rest), place);
    }
  }
  AXISCERT_INLINE void ask(DeepComparison what, int axis, std::size_t place) noexcept {
    Queue& queue = queue_[what];
    const std::size_t at = queue.size++;
    const auto copy = [&](std::size_t to, const Number* from) { queue.column[to][at] = *from; };
    const auto copy_vertex = [&](std::size_t to, std::size_t from) {
      copy(to, left_.column[from] + place);
      copy(to + 1, left_.column[from + 1] + place);
      copy(to + 2, left_.column[from + 2] + place);
    };
    const Turn& turn = turn_of_[axis];
    copy_vertex(0, turn.a);
    copy_vertex(3, turn.b);
    copy_vertex(6, turn.c);
    const std::size_t of_sphere = place * sphere_stride_;
    copy(9, sphere_[0] + of_sphere);
    copy(10, sphere_[1] + of_sphere);
    copy(11, sphere_[2] + of_sphere);
    copy(12, sphere_[3] + of_sphere);
    queue.place[at] = static_cast<std::uint16_t>(place);
    queue.axis[at] = static_cast<std::uint8_t>(axis);
    if (queue.size == capacity) flush(what);
  }

  // Asks the comparisons in the queue, and empties it.
  HWY_NOINLINE void flush(DeepComparison what) noexcept {
    switch (what) {
      case DeepComparison::vertex_radius:
        return flush<DeepComparison::vertex_radius>(KnownResults::radius);
      case DeepComparison::vertex_sides:
        return flush<DeepComparison::vertex_sides>(KnownResults::sides);
      case DeepComparison::edge_radius:
        return flush<DeepComparison::edge_radius>(KnownResults::radius);
      case DeepComparison::edge_side:
        return flush<DeepComparison::edge_side>(KnownResults::sides);
      case DeepComparison::plane_radius:
        return flush<DeepComparison::plane_radius>(KnownResults::radius);
    }
  }
  template <DeepComparison what>
  HWY_NOINLINE void flush(int group) noexcept {
    Queue& queue = queue_[what];
    const std::size_t end = (queue.size + lanes - 1) / lanes * lanes;
    for (std::size_t i = queue.size; i < end; ++i) {
      for (auto& column : queue.column) column[i] = 0;
    }
    for (std::size_t first = 0; first < end; first += lanes) ask_vector<what>(queue, first, group);
    queue.size = 0;
  }

  template <DeepComparison what>
  AXISCERT_INLINE void ask_vector(const Queue& queue, std::size_t first, int group) noexcept {
    const D d;
    Block<Number> queries{{}, lanes, false};
    for (std::size_t k = 0; k < 13; ++k) queries.column[k] = queue.column[k] + first;
    const DeepStep<D> step(d, load(d, queries, 0), open_);
    const auto found = step.template answer<what>();
    const std::uint64_t holds = bits_of(d, found.holds), fails = bits_of(d, found.fails);
    const std::size_t count = std::min(queue.size - first, lanes);
    for (std::size_t i = 0; i < count; ++i) {
      const int axis = queue.axis[first + i];
      known_[queue.place[first + i]] |= std::uint64_t{has_bit(holds, i)} << (group + axis) |
                                        std::uint64_t{has_bit(fails, i)} << (KnownResults::fails + axis);
    }
  }

  const Left& left_;
  const Number* sphere_[4];
  const bool open_;
  const std::size_t sphere_stride_;
  std::uint64_t known_[block_size + lanes];  // the bits of Known for the places in place_
  std::uint16_t place_[block_size], index_[block_size];
  std::size_t size_ = 0;
  EnumArray<DeepComparison, Queue, comparing_count> queue_;
};

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
