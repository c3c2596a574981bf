// Takes a block of queries through the conservative test. No include guard: included once for each of Highway's
// instruction sets, after conservative_step-inl.h and leftovers-inl.h.
HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {

// Decides the queries that the conservative test could not: invalid ones, and differences that overflow. The valid ones
// are asked again with all numbers times 2^-4; where a difference overflowed, the rounding in that scaling is
// negligible.
template <class D, class Real = hn::TFromD<D>>
HWY_NOINLINE void settle_conservatively(const Block<Real>& block, const std::uint64_t* pending, BlockAnswer& answer) {
  const D d;
  for (std::size_t i = 0; i < block.size; ++i) {
    if (!has_bit(pending[i / 64], i % 64)) continue;
    double q[13];
    widen(block, i, q);
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

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
