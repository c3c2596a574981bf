// Takes a block of queries through the steps of a contact's numbers. No include guard: included once for each of
// Highway's instruction sets, after contact_step-inl.h.
HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {

// F is of floats, D of doubles, with as many lanes or half of them.
template <class F, class D, class Real>
class Contacts {
 public:
  Contacts(const Block<Real>& block, Question question, const ContactColumns<Real>& to, BlockContacts& answer) noexcept
      : block_(block), question_(question), to_(to), answer_(answer) {}

  HWY_NOINLINE void run() noexcept {
    if constexpr (sizeof(Real) == 4) {
      run_quickly();
    } else {
      for (std::size_t first = 0; first < block_.size; first += 64) {
        const Word found = take_word<ContactStep<D, Real>>(D(), first, [](auto&&...) {});
        const std::uint64_t open = low_bits(size_of_word(first)) & ~found.measured;
        for (std::uint64_t rest = open; rest != 0; rest &= rest - 1) settle(first + first_bit(rest));
      }
    }
    if (unsure_count_ != 0) settle_verdicts(block_, unsure_, unsure_count_, question_, to_, answer_);
  }

 private:
  using Left = Leftovers<Real>;

  // A bit for each of up to 64 queries.
  struct Word {
    std::uint64_t contact = 0, measured = 0, decided = 0, feature[3] = {};
  };

  std::size_t size_of_word(std::size_t first) const noexcept {
    return block_.size - first < 64 ? block_.size - first : 64;
  }
  Real* column(std::size_t k) const noexcept {
    return k == 0 ? to_.separation : k < 4 ? to_.normal[k - 1] : to_.point[k - 4];
  }
  template <class Room>
  static ContactColumns<Real> columns_of(Room& room) noexcept {
    return {room[0], {room[1], room[2], room[3]}, {room[4], room[5], room[6]}};
  }

  // What the quick step is not certain of, all in doubles.
  HWY_NOINLINE void run_quickly() noexcept {
    Left left;
    for (std::size_t first = 0; first < block_.size; first += 64) {
      take_word<QuickStep<F, D>>(F(), first,
                                 [&](const Block<Real>& from, std::size_t at, std::uint64_t open, std::size_t i)
                                     HWY_ATTR { left.add(F(), from, at, open, [i](std::size_t j) { return i + j; }); });
    }
    if (left.size != 0) take_again(left);
  }
  HWY_NOINLINE void take_again(Left& left) noexcept {
    constexpr std::size_t lanes = hn::MaxLanes(D());
    const Block<Real> rest = left.block(block_);
    Real room[7][lanes];
    for (std::size_t j = 0; j < rest.size; j += lanes) {
      Word found;
      take_vector<ContactStep<D, Real>>(D(), rest, j, columns_of(room), 0, 0, found);
      for (std::size_t lane = 0; lane < lanes && j + lane < rest.size; ++lane) {
        const std::size_t i = left.index[j + lane];
        if (!has_bit(found.measured, lane)) {
          settle(i);
          continue;
        }
        for (std::size_t k = 0; k < 7; ++k) column(k)[i] = room[k][lane];
        for (int k = 0; k < 3; ++k) {
          if (has_bit(found.feature[k], lane)) set_bit(answer_.feature[k], i);
        }
        if (has_bit(found.contact, lane)) set_bit(answer_.contact, i);
        if (!has_bit(found.decided, lane)) unsure_[unsure_count_++] = static_cast<std::uint16_t>(i);
      }
    }
  }

  // Takes up to 64 queries of the block through a step; leave(block, at, bits, i) is told of each vector's queries that
  // it did not measure, of which the first is query i.
  template <class Step, class V, class Leave>
  AXISCERT_INLINE Word take_word(V d, std::size_t first, const Leave& leave) noexcept {
    constexpr std::size_t lanes = hn::MaxLanes(V());
    const std::size_t size = size_of_word(first);
    Word found;
    std::size_t i = 0;
    for (; i + lanes <= size; i += lanes) {
      const std::uint64_t open = take_vector<Step>(d, block_, first + i, to_, first + i, i, found);
      if (open != 0) leave(block_, first + i, open, first + i);
    }
    if (i < size) {
      const Tail<Real, lanes> tail(block_, first + i);
      Real room[7][lanes];
      const std::uint64_t open = take_vector<Step>(d, tail.block, 0, columns_of(room), 0, i, found);
      if ((open & low_bits(size - i)) != 0) leave(tail.block, 0, open & low_bits(size - i), first + i);
      for (std::size_t k = 0; k < 7; ++k) std::memcpy(column(k) + first + i, room[k], (size - i) * sizeof(Real));
    }
    const std::size_t word = first / 64;
    const std::uint64_t measured = found.measured & low_bits(size);
    answer_.contact[word] = found.contact & measured;
    for (int k = 0; k < 3; ++k) answer_.feature[k][word] = found.feature[k] & measured;
    for (std::uint64_t rest = measured & ~found.decided; rest != 0; rest &= rest - 1) {
      unsure_[unsure_count_++] = static_cast<std::uint16_t>(first + first_bit(rest));
    }
    return found;
  }

  // Takes the queries at `at` of a block; their numbers go to `place` of the columns, their bits to `shift` of the
  // word. Returns the bits of those that were not measured.
  template <class Step, class V>
  AXISCERT_INLINE static std::uint64_t take_vector(V d, const Block<Real>& from, std::size_t at,
                                                   const ContactColumns<Real>& to, std::size_t place, std::size_t shift,
                                                   Word& found) noexcept {
    const Step step(load<false>(d, from, at));
    const auto store = [&](const Lanes<V, false>& x, Real* out) HWY_ATTR {
      if constexpr (sizeof(Real) == sizeof(hn::TFromD<V>)) hn::StoreU(x.v, d, out + place);
      else hn::StoreU(hn::DemoteTo(hn::Rebind<float, V>(), x.v), hn::Rebind<float, V>(), out + place);
    };
    store(step.separation, to.separation);
    store(step.normal.x, to.normal[0]);
    store(step.normal.y, to.normal[1]);
    store(step.normal.z, to.normal[2]);
    store(step.point.x, to.point[0]);
    store(step.point.y, to.point[1]);
    store(step.point.z, to.point[2]);
    const std::uint64_t measured = bits_of(d, step.measured);
    found.contact |= bits_of(d, step.contact) << shift;
    found.measured |= measured << shift;
    found.decided |= bits_of(d, step.decided) << shift;
    for (int k = 0; k < 3; ++k) found.feature[k] |= bits_of(d, step.feature[k]) << shift;
    return ~measured & low_bits(hn::MaxLanes(V()));
  }
  HWY_NOINLINE void settle(std::size_t at) noexcept {
    double q[13];
    widen(block_, at, q);
    settle_contact(q, question_, at, to_, answer_);
  }

  const Block<Real>& block_;
  const Question question_;
  const ContactColumns<Real>& to_;
  std::uint16_t unsure_[block_size];  // queries that lack their verdict alone
  std::size_t unsure_count_ = 0;
  BlockContacts& answer_;
};

template <class F, class D, class Real>
void decide_contacts(const Block<Real>& block, Question question, const ContactColumns<Real>& to,
                     BlockContacts& answer) noexcept {
  answer = {};
  Contacts<F, D, Real>(block, question, to, answer).run();
}

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
