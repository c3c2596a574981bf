// Stream over Highway vectors: lane i draws the same numbers as Stream at position first + i, bit for bit, on every
// instruction set. Draws are in lockstep, so that their number cannot depend on the content of a lane. Compiled for the
// current instruction set of foreach_target; the including file has to include
// fuzz/sphere_triangle/families/parts/lanes.h and then define AXISCERT_PER_TARGET.
#include "kernel/base/geometry.h"
#include "kernel/sphere_triangle/forms/simd-inl.h"

// g++ -O2 does not unroll even a loop of ten iterations.
#undef AXISCERT_UNROLL
#ifdef __clang__
#define AXISCERT_UNROLL _Pragma("clang loop unroll(full)")
#else
#define AXISCERT_UNROLL _Pragma("GCC unroll 16")
#endif

HWY_BEFORE_NAMESPACE();
namespace axiscert {
namespace HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR
// Philox4x32-10 in the low halves of 64-bit lanes. The high halves are unspecified: a product reads only low halves,
// and other operations carry high halves only into high halves.
template <class W64>
struct PhiloxWords {
  W64 w0, w1, w2, w3;
};
template <class W64>
AXISCERT_INLINE PhiloxWords<W64> philox(PhiloxWords<W64> w, std::uint64_t key) {
  const hn::ScalableTag<std::uint32_t> d32;
  const hn::ScalableTag<std::uint64_t> d64;
  const auto multiplier0 = hn::Set(d32, 0xD2511F53u), multiplier1 = hn::Set(d32, 0xCD9E8D57u);
  auto key0 = static_cast<std::uint32_t>(key), key1 = static_cast<std::uint32_t>(key >> 32);
  AXISCERT_UNROLL
  for (int round = 0; round < 10; ++round) {
    const W64 product0 = hn::MulEven(hn::BitCast(d32, w.w0), multiplier0);
    const W64 product1 = hn::MulEven(hn::BitCast(d32, w.w2), multiplier1);
    w = {hn::Xor(hn::ShiftRight<32>(product1), hn::Xor(w.w1, hn::Set(d64, key0))), product1,
         hn::Xor(hn::ShiftRight<32>(product0), hn::Xor(w.w3, hn::Set(d64, key1))), product0};
    key0 += 0x9E3779B9u;
    key1 += 0xBB67AE85u;
  }
  return w;
}
#endif

template <class Real>
class LaneStream {
 public:
  using D = hn::ScalableTag<Real>;
  using T = LanesOf<D>;
  using DW = hn::RebindToUnsigned<D>;
  using W = hn::Vec<DW>;  // words: in binary64 the low half of each lane, with a high half of zero
  using M = hn::Mask<D>;
  static constexpr std::size_t lanes = hn::MaxLanes(D());

#if HWY_TARGET == HWY_SCALAR  // one lane, which is not half of a wider one
  LaneStream(const StreamName& name, std::uint64_t first) : stream_(name, first) {}
  LaneStream(const StreamName& name, const std::uint64_t* positions) : stream_(name, *positions) {}

  W word() { return hn::Set(DW(), stream_.word()); }
  // n is at most 2^32 - 1 and may differ from lane to lane.
  W below(W n) { return hn::Set(DW(), static_cast<hn::TFromD<DW>>(stream_.below(hn::GetLane(n)))); }
#else
  // Lane i is at position first + i.
  LaneStream(const StreamName& name, std::uint64_t first) : name_(name) {
    const hn::ScalableTag<std::uint64_t> d64;
    const auto lane = hn::Iota(d64, 0), start = hn::Set(d64, first);
    if constexpr (sizeof(Real) == 8) {
      position_[0] = hn::Add(start, lane);
    } else {
      position_[0] = hn::Add(start, hn::Add(lane, lane));
      position_[1] = hn::Add(position_[0], hn::Set(d64, 1));
    }
  }
  // Lane i is at positions[i].
  LaneStream(const StreamName& name, const std::uint64_t* positions) : name_(name) {
    constexpr std::size_t each = 8 / sizeof(Real);
    for (std::size_t k = 0; k < each; ++k) {
      HWY_ALIGN std::uint64_t taken[lanes];
      for (std::size_t i = 0; i < lanes / each; ++i) taken[i] = positions[i * each + k];
      position_[k] = hn::Load(hn::ScalableTag<std::uint64_t>(), taken);
    }
  }

  W word() {
    if (used_ == held) refill();
    return words_[used_++];
  }
  // n is at most 2^32 - 1 and may differ from lane to lane.
  W below(W n) {
    const hn::ScalableTag<std::uint32_t> d32;
    const hn::ScalableTag<std::uint64_t> d64;
    const W w = word();
    const auto even = hn::ShiftRight<32>(hn::MulEven(hn::BitCast(d32, w), hn::BitCast(d32, n)));
    if constexpr (sizeof(Real) == 8) {
      return even;
    } else {
      const auto odd_lanes = [&](W v) HWY_ATTR { return hn::BitCast(d32, hn::ShiftRight<32>(hn::BitCast(d64, v))); };
      const auto odd = hn::MulEven(odd_lanes(w), odd_lanes(n));
      return hn::OddEven(hn::BitCast(d32, odd), hn::BitCast(d32, even));
    }
  }
#endif
  W below(std::uint32_t n) { return below(hn::Set(DW(), n)); }
  // A word of at most 24 (52) bits as a number: exact.
  static T number(W word) {
    if constexpr (sizeof(Real) == 4) {
      return {hn::ConvertTo(D(), hn::BitCast(hn::RebindToSigned<D>(), word))};
    } else {
      const T two_to_52 = T{hn::Set(D(), 0x1p52)};  // the unit of its last bit is one: the word's bits go there
      return T{hn::BitCast(D(), hn::Or(word, hn::BitCast(DW(), two_to_52.v)))} - two_to_52;
    }
  }
  static T constant(Real x) { return {hn::Set(D(), x)}; }
  // Uniform integer in [low, high], as a number.
  T integer(std::int32_t low, std::int32_t high) {
    return number(below(static_cast<std::uint32_t>(high - low) + 1)) + constant(static_cast<Real>(low));
  }
  M coin() {
    const W top = hn::Set(DW(), 0x80000000u);
    return hn::RebindMask(D(), hn::TestBit(word(), top));
  }
  // 1 if coin() is true, else -1.
  T sign() {
    const M positive = coin();
    return {hn::IfThenElse(positive, constant(1).v, constant(-1).v)};
  }
  T unit() {
    if constexpr (sizeof(Real) == 4) {
      return number(hn::ShiftRight<8>(word())) * constant(Real(0x1p-24));
    } else {
      const W high = word(), low = word();
      return significand(high, low);
    }
  }
  T symmetric() {
    if constexpr (sizeof(Real) == 4) {
      const W w = word();
      const T x = number(hn::ShiftRight<8>(w)) * constant(Real(0x1p-24));
      return {hn::Xor(x.v, hn::BitCast(D(), hn::ShiftLeft<31>(w)))};
    } else {
      const W high = word(), low = word();
      return {hn::Xor(significand(high, low).v, hn::BitCast(D(), hn::ShiftLeft<63>(low)))};
    }
  }

 private:
  // 53 bits from two exact parts, whose sum is exact as well.
  static T significand(W high, W low) {
    return number(high) * constant(Real(0x1p-32)) + number(hn::ShiftRight<11>(low)) * constant(Real(0x1p-53));
  }

#if HWY_TARGET == HWY_SCALAR
  Stream stream_;
#else
  // two at once: a single block would wait for its own products
  static constexpr unsigned blocks = 2, held = 4 * blocks;

  HWY_NOINLINE void refill() {
    const hn::ScalableTag<std::uint32_t> d32;
    const hn::ScalableTag<std::uint64_t> d64;
    const auto block_at = [&](auto position, unsigned k) HWY_ATTR {
      return philox(
          PhiloxWords<decltype(position)>{position, hn::ShiftRight<32>(position), hn::Set(d64, name_.generator),
                                          hn::Set(d64, name_.kind | (block_ + k))},
          name_.seed);
    };
    AXISCERT_UNROLL
    for (unsigned k = 0; k < blocks; ++k) {
      W* const words = words_ + 4 * k;
      if constexpr (sizeof(Real) == 8) {
        const auto all = block_at(position_[0], k);
        const auto low_half = [&](auto w) HWY_ATTR { return hn::And(w, hn::Set(d64, 0xffffffffu)); };
        words[0] = low_half(all.w0);
        words[1] = low_half(all.w1);
        words[2] = low_half(all.w2);
        words[3] = low_half(all.w3);
      } else {
        const auto even = block_at(position_[0], k), odd = block_at(position_[1], k);
        const auto joined = [&](auto e, auto o) HWY_ATTR {
          return hn::OddEven(hn::BitCast(d32, hn::ShiftLeft<32>(o)), hn::BitCast(d32, e));
        };
        words[0] = joined(even.w0, odd.w0);
        words[1] = joined(even.w1, odd.w1);
        words[2] = joined(even.w2, odd.w2);
        words[3] = joined(even.w3, odd.w3);
      }
    }
    block_ += blocks;
    used_ = 0;
  }

  StreamName name_;
  hn::Vec<hn::ScalableTag<std::uint64_t>> position_[2];  // binary32: for the even and for the odd lanes
  std::uint32_t block_ = 0;
  unsigned used_ = held;
  W words_[held];
#endif
};

}  // namespace HWY_NAMESPACE
}  // namespace axiscert
HWY_AFTER_NAMESPACE();
